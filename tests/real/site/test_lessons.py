"""A teacher's own exercise: its file is an exercise like any other, and what is forgotten is a line of the list."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rosspin.site.claims import Stale
from rosspin.site.lessons import counted, stale_files
from tests.helpers.lesson import FILES, HOW_TO
from tests.helpers.tree import ROOT

LESSON = FILES["lessons/faster_heartbeat.py"]
PAGE = FILES["docs/heartbeat.rst"]

SOLVED = "\n" + LESSON.partition("NODE = '''\n")[2].partition("'''")[0].replace("0.5", "0.25")

_LOOK = """
import json, sys
from rosspin import exercises
from rosspin.site.lessons import stale_lessons
print(json.dumps([vars(each) for each in stale_lessons(__import__("pathlib").Path(sys.argv[1]))]))
"""

pytestmark = pytest.mark.shares(10)


def in_site(folder: Path, code: str, *args: str) -> str:
    """What some code prints, in a Python that has the lessons of a site."""
    environment = os.environ | {"ROSSPIN_LESSONS": str(folder / "lessons")}
    command = [sys.executable, "-c", code, *args]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def listed(folder: Path, **lessons: str) -> list[str]:
    """What the list says of lessons, by the names of their files: each entry in a line."""
    (folder / "lessons").mkdir(exist_ok=True)
    for name, text in lessons.items():
        (folder / "lessons" / f"{name}.py").write_text(text)
    found: list[dict[str, Any]] = json.loads(in_site(folder, _LOOK, str(folder)))
    return ["{page}:{line}: {stands}: {now}".format(**each) for each in found]


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A folder with the page of the how-to."""
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/heartbeat.rst").write_text(PAGE)
    return tmp_path


def test_the_lesson_of_the_how_to_lacks_nothing(site: Path) -> None:
    assert listed(site, faster_heartbeat=LESSON) == []
    said = in_site(
        site,
        "import sys; from rosspin.exercises import EXERCISES, check\n"
        "print(EXERCISES[-1].name, EXERCISES[-1].number, EXERCISES[-1].ros, len(EXERCISES))\n"
        "print(check('faster-heartbeat', sys.argv[1]).passed)",
        SOLVED,
    )
    number = said.split()[1]
    assert said.split() == ["faster-heartbeat", number, "2", number, "True"]


def test_it_is_judged_on_the_command_line(site: Path) -> None:
    listed(site, faster_heartbeat=LESSON)
    (site / "faster-heartbeat.py").write_text(SOLVED)
    code = "import sys; from rosspin.__main__ import main; print(main(['judge', sys.argv[1]]))"
    out = in_site(site, code, str(site / "faster-heartbeat.py"))
    assert "- Right: Beats in 1.9 s: 7, the first at 0.25 s." in out and out.endswith("\n0\n")


def _line(name: str) -> int:
    return LESSON.count("\n", 0, re.search(rf"^{name}\b", LESSON, re.MULTILINE).start()) + 1  # type: ignore[union-attr]


FILE = "lessons/faster_heartbeat.py"
WRONG_AT, RIGHT_AT, NODE_AT = _line("WRONG"), _line("RIGHT"), _line("NODE")
FORGOTTEN = {
    'TITLE = "A faster heartbeat"': ("", f"{FILE}:1: TITLE is missing: what the exercise is called"),
    "HINTS = [": ("hints = [", f"{FILE}:1: HINTS is missing: a list of hints, one after the other"),
    "def check(": (
        "def look(",
        f"{FILE}:1: check is missing: a function that looks at an answer, and yields findings",
    ),
    ', {"0.5": "1 / 4"}]': ("]", f"{FILE}:{RIGHT_AT}: RIGHT has 1 answer: give at least 2"),
    '    ({"0.5": "1"}, "Beats in 1.9 s: 1"),\n': ("", f"{FILE}:{WRONG_AT}: WRONG has 2 answers: give at least 3"),
    '{"0.5": "1 / 4"}': ('{"0.5": "1"}', f"{FILE}:{RIGHT_AT}: RIGHT[1]: Exercise "),
    '({"0.5": "4"}': ('({"0.5": "0.25"}', f"{FILE}:{WRONG_AT}: WRONG[0]: No beat was printed.: Exercise "),
    '({"0.5": "1"}': ('({"5.0": "1"}', f"{FILE}:{_line('WRONG')}: WRONG[1]: Beats in 1.9 s: 1: NODE has no '5.0'"),
    "beats[0] - 0.25": (
        "bets[0] - 0.25",
        f"{FILE}:{_line('    right = len')}: check: NameError: name 'bets' is not defined",
    ),
    "from rosspin.exercises import Finding": (
        "from rosspin import Finding",
        f"{FILE}:1: it cannot be loaded: Imp",
    ),
    "yield Finding(right": ("yield Finding(right))", "it cannot be loaded: SyntaxError: "),
}


@pytest.mark.parametrize("old", FORGOTTEN)
def test_each_thing_forgotten_is_a_line(site: Path, old: str) -> None:
    new, said = FORGOTTEN[old]
    assert LESSON.count(old) >= 1
    found = listed(site, faster_heartbeat=LESSON.replace(old, new, 1))
    assert any(said in entry for entry in found), found
    assert not any("Traceback" in entry for entry in found)


def test_a_check_that_fails_and_a_node_that_is_no_python_are_one_line(site: Path) -> None:
    returns = LESSON.replace("yield Finding(F", "Finding(F").replace("yield Finding(r", "return Finding(r")
    said = "check: TypeError: check returned a Finding: let it yield each Finding"
    assert listed(site, faster_heartbeat=returns) == [f"{FILE}:{_line('def check')}: {said}"]
    fails = LESSON.replace('run.values("HEART", "beat")', "run.beats")
    (found,) = listed(site, faster_heartbeat=fails)
    assert found.startswith(f"{FILE}:{_line('    beats')}: check: AttributeError: ")
    line = _line("    node.get_logger")
    (found,) = listed(site, faster_heartbeat=LESSON.replace("str(beat))", "str(beat)"))
    assert found == f'{FILE}:{line}:     node.get_logger().info("[HEART] beat = " + str(beat): NODE is not Python'


def test_a_node_that_is_right_as_it_stands(site: Path) -> None:
    found = listed(site, faster_heartbeat=LESSON.replace("timer(0.5,", "timer(0.25,"))
    assert f"{FILE}:{NODE_AT}: NODE: it is right as it is: there is nothing to do" in found


def test_an_exercise_without_a_page_and_answers_above_the_check(site: Path) -> None:
    above, right, below = LESSON.partition("RIGHT = ")
    moved = right + below + above
    assert listed(site, slower_heartbeat=moved) == [
        "lessons/slower_heartbeat.py:1: no page shows it: write .. exercise:: slower-heartbeat on one",
        "lessons/slower_heartbeat.py:1: RIGHT: it comes after check: the page gets only what is above",
    ]


def test_the_page_is_given_no_answers() -> None:
    """It has what is above RIGHT."""
    script = (ROOT / "web/build.mjs").read_text(encoding="utf-8")
    assert r'replace(/^(SOLUTION|RIGHT) = [^]*$/m, "RIGHT = WRONG = ()\n")' in script
    kept = re.sub(r"^RIGHT = [\s\S]*$", "RIGHT = WRONG = ()\n", LESSON, flags=re.MULTILINE)
    assert "def check" in kept and '0.25"' not in kept


# --- counts and run bits ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("said", "now"),
    [
        ("There is one exercise.", ""),
        ("There are two exercises.", "the page has one"),
        ("nineteen exercises", "the page has one"),
        ("21\nexercises", "the page has one"),
        ("The exercises are easy.", ""),
    ],
)
def test_a_count_in_prose(site: Path, said: str, now: str) -> None:
    (site / "docs/heartbeat.rst").write_text(PAGE.replace("There is one exercise.", said))
    stands = [(entry.page, entry.stands, entry.now) for entry in counted(site)]
    assert stands == (
        [("docs/heartbeat.rst", " ".join(said.removeprefix("There are ").rstrip(".").split()), now)] if now else []
    )


def test_the_counts_of_the_site_hold() -> None:
    assert list(counted(ROOT)) == []


def test_a_script_without_its_run_bit(tmp_path: Path) -> None:
    (tmp_path / "examples/heartbeat").mkdir(parents=True)
    node = tmp_path / "examples/heartbeat/node.py"
    node.write_text("#!/usr/bin/env python3\n")
    (tmp_path / "examples/module.py").write_text("x = 1\n")
    name = "examples/heartbeat/node.py"
    assert list(stale_files(tmp_path)) == [Stale(name, 1, "it begins with #! and has no run bit", f"chmod +x {name}")]
    node.chmod(0o755)
    assert list(stale_files(tmp_path)) == list(stale_files(ROOT)) == []


def test_what_the_how_to_quotes_is_said() -> None:
    source = (ROOT / "src/rosspin/site/lessons.py").read_text() + (
        ROOT / "src/rosspin/exercises/own/__init__.py"
    ).read_text()
    assert "``no page shows it``" in " ".join(HOW_TO.split()) and "no page shows it" in source
