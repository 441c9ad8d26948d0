"""What both Python and the page's script have to know is the same in both."""

from __future__ import annotations

import ast
import json
import random
import re
import subprocess
from typing import Any

import pytest

from rosspin.hand_ins.on_page import ROOM
from rosspin.measures import describe_timeline, lost_by_source, say_time
from rosspin.plots import layout
from rosspin.results.ticks import Tick
from rosspin.run import noted_steps
from rosspin.site.rules import defined
from tests.helpers.tree import ROOT

SCRIPTS = ROOT / "web/src"

# Constants that are written in both languages, since the page trusts nothing that comes out of a sandbox: where they
# are in the script, and the name of that in rosspin/page.py, or the value. All others are given to the script by
# rosspin.site.rules.
BOTH: list[tuple[str, str, str | int]] = [
    ("protocol.js", r"const NAME = text\((\w+)\)", "_NAME"),
    ("protocol.js", r"const SENTENCE = text\((\w+)\)", "_SENTENCE"),
    ("protocol.js", r"const TIMES = (\w+)", "_MOST_ENTRIES"),
    ("protocol.js", r"const ROWS = (\w+)", ROOM.rows),
    ("protocol.js", r"const EXERCISES_OF_ALL = (\w+)", ROOM.exercises),
    ("protocol.js", r"threads: list\(SENTENCE, (\w+)\)", "_MOST"),
    ("protocol.js", r"rings: list\(.*, (\w+)\),\n", "_MOST_RINGS"),
    ("protocol.js", r"chunks: list\(list\(integer\(\), (\w+)\)", "_MOST_CHUNKS"),
    ("cpp.js", r"const MOST_CHUNKS = (\w+)", "_MOST_CHUNKS"),
    ("cpp.js", r"const MOST_RINGS = (\w+)", "_MOST_RINGS"),
    ("called.js", r"const MOST = (\w+)", noted_steps._MOST),
    ("called.js", r"const MOST_CALLBACKS = (\w+)", noted_steps._MOST_CALLBACKS),
    ("limits.js", r"SHOWN = .*ticks: (\w+)", "_MOST_TICKS"),
]


def constants(text: str) -> dict[str, int]:
    """The whole numbers that a module of Python assigns to names."""
    found: dict[str, int] = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.Assign):
            target, value = node.targets[0], node.value
            pairs = [(target, value)]
            if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                pairs = [*zip(target.elts, value.elts, strict=True)]
            for name, number in pairs:
                if isinstance(name, ast.Name) and isinstance(number, ast.Constant) and isinstance(number.value, int):
                    found[name.id] = number.value
    return found


@pytest.mark.parametrize(("script", "place", "python"), BOTH, ids=lambda value: str(value)[:30])
def test_a_constant_that_is_written_in_both_languages(script: str, place: str, python: str | int) -> None:
    (found,) = re.findall(place, (SCRIPTS / script).read_text(encoding="utf-8"))
    own = constants((ROOT / "src/rosspin/page.py").read_text(encoding="utf-8"))
    assert int(found) == (own[python] if isinstance(python, str) else python)


def test_the_verdicts_that_a_page_knows_are_those_of_a_judge() -> None:
    text = (SCRIPTS / "protocol.js").read_text(encoding="utf-8")
    (listed,) = re.findall(r"const VERDICTS = (\[.*\])", text)
    judge = (ROOT / "src/rosspin/exercises/__init__.py").read_text(encoding="utf-8")
    assert all(f'"{verdict}"' in judge for verdict in json.loads(listed))


def in_script(code: str, given: Any) -> Any:
    """What a piece of the page's script gives for ``given``, with the constants that the build defines."""
    head = "import { readFileSync } from 'node:fs'\n"
    head += f"Object.assign(globalThis, {json.dumps(defined())})\nconst given = JSON.parse(readFileSync(0))\n"
    body = f"const svg = await import({json.dumps((SCRIPTS / 'svg.js').as_uri())})\n"
    body += f"const measures = await import({json.dumps((SCRIPTS / 'measures.js').as_uri())})\n"
    body += f"const series = await import({json.dumps((SCRIPTS / 'series.js').as_uri())})\n"
    command = [
        str(ROOT / ".venv/bin/node"),
        "--input-type=module",
        "-e",
        f"{head}{body}console.log(JSON.stringify({code}))",
    ]
    run = subprocess.run(command, input=json.dumps(given), capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def some_rows() -> list[list[tuple[float, float]]]:
    """Ticks in rows: few and many, at the same times, overlapping, and thirty calls at once."""
    drawn = random.Random(1)
    rows = [[(0.0, 5.0)] * 30, [(1.0, 0.0)] * 5, [(0.0, 0.5), (0.2, 0.0), (0.2005, 0.3), (0.7, 0.0)]]
    for count in (1, 7, 50, 600, 601, 2000):
        times = sorted(round(drawn.choice((0.5, 1, 3)) * drawn.randrange(count), 6) for _ in range(count))
        rows.append([(time, drawn.choice((0.0, 0.001, 0.7, 4.0))) for time in times])
    return rows


def test_a_timeline_is_laid_out_alike() -> None:
    """Lanes, heights of bars and marks, and which marks are drawn."""
    rows = some_rows()
    code = """given.map(ticks => [
        svg.lanesOf(ticks), svg.heights(0, ticks),
        svg.toDraw(ticks.map(([real]) => real), ticks.map(([, duration]) => duration), RULES.timeline.many)])"""
    for ticks, (laid, down, drawn) in zip(rows, in_script(code, rows), strict=True):
        lanes, height = layout.lanes(ticks)
        assert (laid[0], laid[1]) == (pytest.approx(lanes), pytest.approx(height)) and height >= 0.5
        middle = layout.TOP + layout.TICKS
        assert down == pytest.approx([middle + each for each in layout.heights(ticks)], abs=1e-3)
        assert drawn == layout.to_draw([real for real, _ in ticks], [duration for _, duration in ticks])


def test_an_axis_has_the_same_numbers() -> None:
    drawn = random.Random(1)
    axes = [(0.0, span) for span in (1e-6, 0.5, 1.0, 2.0, 6.0, 6.2, 7.0, 7.1, 10.0, 60.0, 3600.0, 1e9)]
    axes += [(drawn.uniform(-9, 1e4), 10 ** drawn.uniform(-4, 6)) for _ in range(200)]
    for (first, span), found in zip(axes, in_script("given.map(axis => svg.numbers(...axis))", axes), strict=True):
        assert found == pytest.approx(layout.numbers(first, span), rel=1e-9, abs=1e-12) and 1 <= len(found) <= 8


def test_a_length_of_time_is_said_alike() -> None:
    drawn = random.Random(1)
    times = [
        0.0,
        1e-10,
        0.5,
        0.0995,
        0.09949,
        1234.0,
        86_400.0,
        1e-6,
        *(0.03125, 0.0009765625, 0.15625, 2.125),
        *(10 ** drawn.uniform(-9, 6) for _ in range(300)),
    ]
    assert in_script("given.map(time => series.say(time))", times) == [say_time(time) for time in times]
    assert say_time(0.0) == "0 s" and say_time(1234.0) == "1230 s"


def test_ticks_are_described_and_counted_alike() -> None:
    """Of C++ in a page, where no Python is."""
    drawn = random.Random(1)
    runs = []
    for count in [1, 1, 2, 3, 7, 99, 100, 101, 250] * 12:
        period = drawn.choice((0.5, 0.0625, 0.1, 1.0))
        real = expected = drawn.choice((0.0, period, 1 / 3))
        ticks = []
        for number in range(1, count + 1):
            late = drawn.choice((0.0, 0.0, 1e-7, 8.5e-5, 0.0123, 1.7 * period, 2.5 * period, 3.2 * period))
            real = max(real, expected + late)
            ticks.append(("timer", number, expected, real, drawn.choice((0.0, 0.3, period + 5e-4, 4.0))))
            expected += period * drawn.choice((1, 1, 1, 1, 2, 3.5))
        runs.append((ticks, period))
    code = "given.map(([ticks, period]) => [measures.describe('timer', ticks), measures.lost(ticks, period)])"
    for (ticks, period), (said, times) in zip(runs, in_script(code, runs), strict=True):
        group = [Tick(*each) for each in ticks]
        assert said == describe_timeline("timer", group)
        assert times == pytest.approx(lost_by_source(group, {"timer": period}).get("timer", []))
