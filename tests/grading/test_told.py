"""What `rosspin judge` tells of a class: in words, as data, and in tables."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
from pathlib import Path

import pytest
from tree import ROOT

from rosspin.exercises import Verdict
from rosspin.grading.students import Class, Row
from rosspin.grading.told import PAGE_PYTHON, as_data, as_words, hard, say_python, say_unsealed, write_csv


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


FORMULAS = ["=1+1", "+1", "-1", "@SUM(A1)", " =x", '"=x', "a,=x", "a;-x", "＝x", "\t=x", "\u200b=x", "a\r\n=x"]


@pytest.mark.parametrize("name", FORMULAS)
def test_no_cell_is_a_formula(name: str) -> None:
    ((cell,),) = csv.reader(io.StringIO(write_csv([[name]]).decode("utf-8-sig")))
    guarded = cell.replace("'", "", 1)
    assert len(cell) == len(guarded) + 1 or name == "a\r\n=x"
    assert "\n" not in cell


def test_cells_are_as_on_the_page(tmp_path: Path) -> None:
    """The same text comes out of web/src/csv.js."""
    script = f"import {{ csv }} from {json.dumps((ROOT / 'web/src/csv.js').as_uri())}\n"
    script += "process.stdout.write(csv(JSON.parse(process.argv[1])))"
    rows: list[list[str | int]] = [[each, 5, "a-b", 'Zoë "Z", jr.'] for each in FORMULAS]
    node = Path(sys.prefix, "bin/node")
    command = [str(node), "--input-type=module", "-e", script, json.dumps(rows)]
    assert subprocess.run(command, check=True, capture_output=True).stdout == write_csv(rows)


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
    said = "1 answer is no Python to this Python 3.11; that of the page is 3.14, and newer ones read more."
    assert say_python(found) == said
    monkeypatch.setattr(sys, "version_info", (3, 14, 0))
    assert say_python(found) == ""


def test_the_python_of_the_page() -> None:
    assert f"python{PAGE_PYTHON[0]}{PAGE_PYTHON[1]}.zip" in (ROOT / "web/src/worker.js").read_text(encoding="utf-8")
