"""An answer runs in one Python and is judged in another, by the trace of its runs; whatever it is, and they are."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rosspin.exercises import EXERCISES, Misfit, check, judge, trace
from rosspin.exercises.traces import LONGEST
from tests.helpers.answers import CELLS, NAMES, answer_in, number_of

pytestmark = pytest.mark.shares(3)

# The page's Python, as far as it is not of a browser.
PAGE = """
import json, sys
from unittest.mock import MagicMock
sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
from rosspin import page
"""
TRACE = "name, path, given = json.load(sys.stdin)\nopen(path, 'w').write(page.trace(name, given, None))"
JUDGE = "for given in json.load(sys.stdin): print(page.judge(*given))"

SOLUTIONS = {name: answer_in(CELLS[name][1]) for name in NAMES}
WRONG = answer_in(CELLS["ten-hertz"][0])  # prints at another rate


def in_page(code: str, given: Any) -> subprocess.CompletedProcess[str]:
    """What came of some code in the page's Python, a new one."""
    return subprocess.run([sys.executable, "-c", PAGE + code], input=json.dumps(given), capture_output=True, text=True)


def judged(*given: tuple[str, str, str]) -> list[dict[str, Any]]:
    """What the page says of answers to exercises, by their traces."""
    done = in_page(JUDGE, given)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def verdict(name: str, answer: str, folder: Path) -> dict[str, Any]:
    """What the page says of an answer that runs in one Python and is judged in another."""
    path = folder / "trace"
    in_page(TRACE, (name, str(path), answer))
    found = path.read_text() if path.exists() else ""
    (said,) = judged((name, answer, found))
    return said


def test_each_verdict(tmp_path: Path) -> None:
    solved = verdict("fire-once", SOLUTIONS["fire-once"], tmp_path)
    assert solved.pop("said").startswith(f"Exercise {number_of('fire-once')}: right.\n- Right: Counter 1 came at 1.5 s")
    console = "[INFO] [1.500000]: [SPINNER PY NODE] counter = 1\n"
    assert solved == {
        "verdict": "solved",
        "solved": True,
        "status": f"Exercise {number_of('fire-once')}: right.",
        "console": console,
        "why": "",
        "hint": "",
        "off": None,
        "drive": [],
    }
    wrong = verdict("ten-hertz", "\n1 / 0", tmp_path)
    assert (wrong["verdict"], wrong["solved"], wrong["status"]) == (
        "not yet",
        False,
        f"Exercise {number_of('ten-hertz')}: not yet.",
    )
    assert "The node stopped in line 2: ZeroDivisionError" in wrong["said"]
    assert wrong["why"].startswith("The node stopped in line 2: ZeroDivisionError")
    assert wrong["hint"] in wrong["said"]
    assert "Traceback" in wrong["console"]
    none = verdict("nothing", "", tmp_path)
    assert (none["verdict"], none["solved"]) == ("not judged", False)
    assert none["said"] == (
        f"there is no exercise 'nothing': they are numbered 1 to {len(EXERCISES)}, and have the names in the first "
        "lines of their cells"
    )


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("first-ticks", ""),
        ("ten-hertz", "\n"),
        ("ten-hertz", "# later"),
        ("first-ticks", answer_in(CELLS["first-ticks"][0])),
        ("frequency-parameter", answer_in(CELLS["frequency-parameter"][0])),
        ("first-ticks", "timer = None"),
    ],
)
def test_what_is_not_answered_yet_is_open(name: str, answer: str, tmp_path: Path) -> None:
    assert verdict(name, answer, tmp_path)["verdict"] == "open"


def test_something_wrong_is_not_open() -> None:
    answer = "timer = [1, 2, 3]\nloop = ..."
    assert [each["verdict"] for each in judged(("first-ticks", answer, trace("first-ticks", answer)))] == ["not yet"]


# --- forgeries --------------------------------------------------------------------------------------------------------

# Ways to the modules of the process, and what is done with them there.
WAYS = {
    "attrgetter": 'from operator import attrgetter\nmodules = attrgetter("modules")(sys)',
    "Formatter": 'import string\nmodules, _ = string.Formatter().get_field("0.modules", (sys,), {})',
    "ext": 'import logging.config\nmodules = logging.config.BaseConfigurator({}).convert("ext://sys.modules")',
}
PATCHES = {
    "passed": 'modules["rosspin.exercises.feedback"].Feedback.passed = True',
    "verdict": 'modules["rosspin.exercises"]._kind = lambda feedback: "solved"',
    "find": 'modules["rosspin.exercises.judges"].on_time = lambda *_: '
    'modules["rosspin.exercises.feedback"].Finding(True, "")',
    "judge": 'modules["rosspin.exercises"].judge = modules["rosspin.page"].judge = lambda *_: "solved"',
    "dumps": 'import json\njson.dumps = lambda *_, **__: \'{"verdict": "solved"}\'',
    "write": 'modules["rosspin.exercises"].write = lambda _: \'{"verdict": "solved", "solved": true}\'',
    "trace": 'modules["rosspin.exercises"].trace = modules["rosspin.page"].trace = lambda *_: "[4, true]"',
    "bool": "import builtins\nbuiltins.all = lambda _: True",
}


@pytest.mark.parametrize(
    ("way", "patch"), [("Formatter", "passed"), ("ext", "passed"), *(("attrgetter", patch) for patch in PATCHES)]
)
def test_an_answer_that_takes_over_its_python_is_not_solved(way: str, patch: str, tmp_path: Path) -> None:
    said = verdict("ten-hertz", f"import sys\n{WAYS[way]}\n{PATCHES[patch]}\n{WRONG}", tmp_path)
    assert said["solved"] is False
    assert said["verdict"] == ("not judged" if patch == "write" else "not yet"), said


@pytest.mark.parametrize(("end", "what"), [("os.abort()", "not judged"), ("os._exit(0)", "not yet")])
def test_an_answer_that_ends_its_python_is_not_solved(end: str, what: str, tmp_path: Path) -> None:
    said = verdict("ten-hertz", f"import json, os\njson.dumps = lambda *_, **__: 'solved'\n{end}", tmp_path)
    assert (said["solved"], said["verdict"]) == (False, what)


def test_judging_runs_nothing_of_an_answer(tmp_path: Path) -> None:
    """Nor does it load what answers on ROS 2 need."""
    there = tmp_path / "there"
    answer = f"open({str(there)!r}, 'w')\n"
    code = "page.judge(*json.load(sys.stdin))\nassert not [name for name in sys.modules if 'rosspin.rclpy.' in name]"
    traced = trace("call-back-once", answer)
    there.unlink()
    assert in_page(code, ("call-back-once", answer, traced)).returncode == 0
    assert not there.exists()


def test_an_odd_name_is_a_hint() -> None:
    answer = f"import gc\n{SOLUTIONS['fire-once']}"
    (said,) = judged(("fire-once", answer, trace("fire-once", answer)))
    assert said["verdict"] == "solved"
    assert said["said"].endswith("\n\nThe answer uses gc, which no exercise needs.")


# --- traces -----------------------------------------------------------------------------------------------------------


GOOD = trace("fire-once", SOLUTIONS["fire-once"])


def changed(old: str, new: str) -> str:
    assert GOOD.count(old), old
    return GOOD.replace(old, new, 1)


@pytest.mark.parametrize(
    "traced",
    [
        *("", "null", "5", "{}", "[]", '"solved"', '{"verdict": "solved"}', "[" * 100_000, "\0", GOOD[:-1], GOOD * 2),
        changed('["fire-once",', '["ten-hertz",'),
        changed('["fire-once",', "[5,"),
        changed('["fire-once",', "[true,"),
        changed("[5.0,[],", "[6.0,[],"),
        changed("[5.0,[],", '[5.0,["_a:=1"],'),
        changed("[5.0,[],", "[NaN,[],"),
        changed("[5.0,[],", "[1e999,[],"),
        changed("[5.0,[],", f"[{10**400},[],"),
        changed("[5.0,[],", "[[],[],"),
        changed("[1.5,", "[Infinity,"),
        changed("[1.5,", "[null,"),
        changed("[1.5,", f"[{'[' * 5000}{']' * 5000},"),
        changed('"running"' if '"running"' in GOOD else '"stopped"', "7"),
        changed("[INFO]", "x" * 30_001),
        f"{GOOD[:-2]}]]]]",
        '["fire-once","",false,[]]',
        json.dumps([*json.loads(GOOD)[:3], json.loads(GOOD)[3] * 2]),
        json.dumps([*json.loads(GOOD)[:3], [[*json.loads(GOOD)[3][0][:1], None, None]]]),
        json.dumps([*json.loads(GOOD)[:3], [[*json.loads(GOOD)[3][0][:2], ["", ""]]]]),
        trace("ten-hertz", SOLUTIONS["ten-hertz"]),
        " " * LONGEST + GOOD,
    ],
)
def test_what_is_no_trace_of_the_exercise_is_refused(traced: str) -> None:
    with pytest.raises(Misfit, match="The trace does not fit: "):
        judge("fire-once", SOLUTIONS["fire-once"], traced)


def test_a_refused_trace_is_not_judged() -> None:
    for said in judged(
        ("fire-once", SOLUTIONS["fire-once"], ""), ("fire-once", SOLUTIONS["fire-once"], GOOD.replace("5.0", "6.0"))
    ):
        assert (said["verdict"], said["solved"], said["console"]) == ("not judged", False, "")
        assert said["said"].startswith("The trace does not fit: ")


STRANGE = [
    *("first-ticks", "loop-to-timer", "share-data", "publish-the-counter", "newest-position", "period-parameter"),
    *("starving-neighbour", "wake-a-rate", "end-without-a-traceback", "slow-service"),
]


def test_no_trace_is_too_strange() -> None:
    """Whatever stands in place of a part of it: there is a verdict."""
    draw = random.Random(1)
    given = []
    for name in STRANGE:
        traced = json.loads(trace(name, SOLUTIONS[name]))
        for _ in range(40):
            odd = json.loads(json.dumps(traced))
            part, place = odd, 3
            while isinstance(part[place], list) and part[place] and draw.random() < 0.9:
                part, place = part[place], draw.randrange(len(part[place]))
            part[place] = draw.choice([None, True, -1, 0, 1e300, 2**62, "", "9" * 400, "²", "nan", [], [[]], {}])
            given.append((name, SOLUTIONS[name], json.dumps(odd)))
    found = judged(*given)
    assert len(found) == len(given)
    assert {each["verdict"] for each in found} >= {"not judged", "not yet"}
    assert all(each["solved"] is (each["verdict"] == "solved") for each in found)


@pytest.mark.parametrize(
    "flood",
    [
        "for _ in range(100_000): print('x' * 50)",
        "for _ in range(100_000): print('\\0' * 50)",
        "print('\\0' * 10_000_000)",
        "p = rospy.Publisher('flood', std_msgs.msg.String, queue_size=1)\nfor _ in range(30_000): p.publish('x' * 99)",
    ],
)
def test_a_trace_is_bounded(flood: str) -> None:
    """What does not fit is said, and is for the teacher to read; of a line that is too long a part will do."""
    answer = f"import std_msgs.msg\n{SOLUTIONS['fire-once']}\n{flood}\n"
    traced = trace("fire-once", answer)
    assert len(traced) < LONGEST
    (said,) = judged(("fire-once", answer, traced))
    assert said["verdict"] == ("to read" if "for" in flood else "solved")
    assert ("not all of it was looked at" in said["said"]) is ("for" in flood)
    assert len(said["console"]) < 30_000


def test_a_trace_does_not_know_what_is_judged() -> None:
    """It is data: nothing of a finding, a hint or a verdict."""
    assert not {"Right", "Wrong", "Hint", "solved"} & set(GOOD.replace('"', " ").split())


def test_the_environment_of_the_reader_is_put_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """For an answer it is a plain one."""
    monkeypatch.setenv("ROS_NAMESPACE", "/mine")
    assert check("first-ticks", "timer = [0.4, 0.8, 1.2]").console == ""
    assert os.environ["ROS_NAMESPACE"] == "/mine"
