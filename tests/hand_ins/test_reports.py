"""What `rosspin judge` tells of a class: in words, as data, and in tables."""

from __future__ import annotations

import csv
import io
import re
import sys
import unicodedata

import pytest

from rosspin.exercises import Verdict
from rosspin.hand_ins.reports import PAGE_PYTHON, as_csv, as_data, as_words, hard, say_python, say_unsealed, write_csv
from rosspin.hand_ins.students import Class, Row
from tests.helpers.tree import ROOT


def a_class(*rows: tuple[str, dict[str, Verdict]]) -> Class:
    found = Class()
    for name, verdicts in rows:
        row = Row(name, f"{name}.json", answers=dict.fromkeys(verdicts, ""), verdicts=verdicts)
        found._rows["", name] = row
    return found


def told(kind: str, hint: str = "", why: str = "") -> Verdict:
    return Verdict(kind, kind == "solved", "", "", "", why, hint)


def test_what_the_class_found_hard() -> None:
    found = a_class(
        ("a", {"slow-timer": told("not yet", "h1"), "two-timers": told("solved"), "who-calls": told("solved")}),
        ("b", {"slow-timer": told("not yet", "h2"), "two-timers": told("not yet", "h3")}),
        ("c", {"slow-timer": told("not yet", "h1"), "two-timers": told("open")}),
        ("d", {"slow-timer": told("solved")}),
    )
    (slow, two) = hard(found)
    assert (slow.exercise, *slow[2:]) == ("slow-timer", 4, 1, (("h1", 2), ("h2", 1)))
    assert two[2:] == (3, 1, (("h3", 1),))
    words = (
        "What was hard:\n  slow-timer: 1 of 4 solved\n    2 × h1\n    1 × h2\n  two-timers: 1 of 3 solved\n    1 × h3"
    )
    assert "\n".join(as_words(found)).endswith(words)
    assert as_data(found)["hard"][0]["hints"] == {"h1": 2, "h2": 1}


def test_a_class_compares_how_far_its_vehicles_came_off_the_line() -> None:
    found = a_class(
        ("Ada", {"follow-the-line": told("solved")._replace(off=0.214), "slow-timer": told("solved")}),
        ("Ben", {"follow-the-line": told("solved")._replace(off=0.05)}),
        ("Cem", {"follow-the-line": told("not yet", "h")._replace(off=3.5)}),
        ("Di", {"slow-timer": told("solved")}),
    )
    assert "follow-the-line, largest deviation: 0.05 m (Ben), 0.214 m (Ada)" in list(as_words(found))
    head, *rows = as_csv(found)
    assert head[-1] == "follow-the-line: off (m)" and [row[-1] for row in rows] == ["0.214", "0.05", "3.5", ""]
    assert as_data(found)["students"][1]["answers"]["follow-the-line"]["off"] == 0.05


PLAIN = ["", "Ada", "O'Neill", "Anna-Lena Groß-Gerau", "Nguyễn Thị Minh", "李雷", "علی\u200cرضا", 'Zoë "Z", jr.']
PLAIN += ["Sam, Al", "1+1=2.json", "a@b.org.json", "a; b.json", "C++", "5", "2026-11-21 22:05", "refused: it is odd"]

# Each with what it becomes. A sign may be full-width, small, or the mathematical one; what is white, quoted or not
# seen may come before it; cells may be separated by what is in the middle.
FORMULAS = {sign + "1": f"'{sign}1" for sign in "=+-@＝＋－＠−﹦⁺₋"}
FORMULAS |= {each + "=1": f"{each}'=1" for each in (" ", "\u00a0", "\u3000", "\ufeff", "\u200b", "\u202e")}
FORMULAS |= {
    each + "=1": f"{each}'=1" for each in ("\u2060\u200d", "\u00ad", "\u034f", "\u3164", "\ufe0f", "\U000e0101", '"')
}
FORMULAS |= {each + "=1": " '=1" for each in ("\t", "\r", "\n", "\r\n\0", "\u0085", "\u2028")}
FORMULAS |= {f"Ada{each}=1": f"Ada{each}'=1" for each in (";", "; ", ";;", ",", "|", "；", ";\ufeff", '";"', ';""')}
FORMULAS |= {"=cmd|' /C calc'!A0": "'=cmd|' /C calc'!A0", "Ada\t=1": "Ada =1", "a\r\n=x": "a =x"}
FORMULAS |= {"Ada;\t=1": "Ada; '=1"}


def cell(text: str) -> str:
    """What a spreadsheet has of it."""
    ((found,),) = csv.reader(io.StringIO(write_csv([[text]]).decode("utf-8-sig")))
    return found


@pytest.mark.parametrize("text", FORMULAS)
def test_no_cell_is_a_formula(text: str) -> None:
    assert cell(text) == FORMULAS[text]
    line = write_csv([["Ada", text, "solved"]]).decode("utf-8-sig").rstrip("\r\n")
    for separator in ",;\t|":
        for found in next(csv.reader([line], delimiter=separator)):
            seen = found.lstrip(' "\u00a0\u3000\ufeff\u200b\u2060\u200d\u202e\u00ad\u034f\u3164\ufe0f\U000e0101')
            assert not re.match("[=+@\u2212-]", unicodedata.normalize("NFKC", seen))


@pytest.mark.parametrize("text", PLAIN)
def test_other_cells_stay_as_they_are(text: str) -> None:
    assert cell(text) == text


def test_half_a_character_is_no_error() -> None:
    assert write_csv([["a\ud800"]]).endswith(b'"a?"\r\n')


def test_it_is_said_first_and_in_each_row_that_answers_were_not_sealed() -> None:
    found = a_class(("a", {"slow-timer": told("solved")}), ("b", {"slow-timer": told("solved")}))
    assert say_unsealed(found) == "" and not any("sealed" in line for line in as_words(found))
    found.why_unsealed = "bubblewrap is not installed"
    said = "The answers were NOT sealed: each ran with all of your rights. (Bubblewrap is not installed.)"
    assert say_unsealed(found) == said
    assert list(as_words(found)) == [said, "a: 1 of 1 solved; NOT sealed", "b: 1 of 1 solved; NOT sealed"]


def test_it_is_said_that_a_newer_python_reads_more(monkeypatch: pytest.MonkeyPatch) -> None:
    found = a_class(("a", {"slow-timer": told("not yet", why="Line 1 is not Python: invalid syntax.")}))
    monkeypatch.setattr(sys, "version_info", (3, 11, 2))
    said = "1 answer is no Python to this Python 3.11; the page's is 3.14, and newer ones read more."
    assert say_python(found) == said
    monkeypatch.setattr(sys, "version_info", (3, 14, 0))
    assert say_python(found) == ""


def test_the_python_of_the_page() -> None:
    assert f"python{PAGE_PYTHON[0]}{PAGE_PYTHON[1]}.zip" in (ROOT / "web/src/worker.js").read_text(encoding="utf-8")
