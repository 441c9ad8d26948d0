"""The vehicle of the first page: how it drives, and what the page says and carries of it."""

from __future__ import annotations

import gzip
import json
import math
import re
from itertools import pairwise
from pathlib import Path

import pytest

from rosspin import simulate
from rosspin.plots.vehicle import PERIOD, SECONDS, drive
from rosspin.results.recordings import load
from rosspin.site.outputs import stale_picture
from rosspin.site.vehicle import NODES
from tests.helpers.built_pages import parsed
from tests.helpers.tree import ROOT

SECOND = {"second_callback", "callback 2", "lambda 2"}  # the timer that steers, in each language
ON_TIME = [PERIOD * n for n in range(1, 24)]


def without(first: float, last: float) -> list[float]:
    """Ticks on time, but none that would be due from ``first`` on and before ``last`` (s)."""
    return [time for time in ON_TIME if not first <= time < last]


# --- how it drives ----------------------------------------------------------------------------------------------------


def test_steered_on_time_it_keeps_to_its_line() -> None:
    found = drive(ON_TIME)
    assert found.off < 0.05 and found.overdue == []
    assert found.words == "keeps to its line: at most 3 cm off"


def test_it_is_on_its_line_at_each_tick() -> None:
    for time in ON_TIME:
        x, y, _ = drive(ON_TIME).at(time)
        assert abs(y - 1.2 * math.sin(math.tau * x / 7)) < 0.05


def test_between_ticks_its_wheels_stay_as_they_are() -> None:
    """It continues along the arc on which it was, at its speed."""
    found = drive(without(4.0, 6.0))
    assert found.overdue == [(4.0, 6.0)]
    places = [found.at(3.5 + 0.1 * n) for n in range(26)]
    turns = [after[2] - before[2] for before, after in pairwise(places)]
    assert max(turns) - min(turns) < 1e-9
    assert all(math.dist(a[:2], b[:2]) == pytest.approx(0.12, rel=1e-2) for a, b in pairwise(places))


def test_it_jumps_nowhere() -> None:
    found = drive(without(4.0, 6.0))
    for before, after in pairwise(found.arcs):
        x, y, heading = before.after(after.time - before.time)
        assert (x, y, heading) == pytest.approx((after.x, after.y, after.heading))


def test_the_later_a_tick_the_farther_it_is_off() -> None:
    off = [drive(sorted([*without(4.0, 4.0 + late), 4.0 + late])).off for late in (0.6, 1.1, 1.6, 1.9)]
    assert off == sorted(off) and off[0] < 0.1 and off[-1] > 0.9


def test_never_steered_it_drives_straight_on() -> None:
    x, y, heading = drive([]).at(SECONDS)
    assert (heading, math.hypot(x, y)) == pytest.approx((math.atan2(y, x), 1.2 * SECONDS))


def test_two_ticks_at_one_time_are_as_one() -> None:
    assert drive(sorted([*ON_TIME, 4.0])).at(SECONDS) == drive(ON_TIME).at(SECONDS)


def test_the_way_ends_where_the_vehicle_does() -> None:
    found = drive(without(4.0, 6.0))
    x, y, _ = found.at(SECONDS)
    assert found.path.endswith(f" {x:.3f} {-y:.3f}") and found.path.count("A") == len(found.arcs)
    assert found.dashes == "0 4 2 18"  # of a path as long as the run: from the time 4 s on, for 2 s


# --- the first page ---------------------------------------------------------------------------------------------------


def carried(site: Path) -> tuple[list[float], list[list[tuple[str, str, str, str, float]]]]:
    (figure,) = parsed(site / "index.html").select("figure[data-vehicle]")
    _, lengths, positions = json.loads(str(figure["data-vehicle"]))
    return lengths, positions


def test_the_page_carries_what_the_runs_give(site: Path) -> None:
    lengths, positions = carried(site)
    assert len(positions) == len(NODES)
    for (name, (file, words)), found in zip(NODES.items(), positions, strict=True):
        ticks = simulate(ROOT / file, SECONDS, words.format(lengths[-1]).split()).ticks
        wanted = drive([tick.real for tick in ticks if tick.source in SECOND])
        assert (found[-1][2], found[-1][3]) == (wanted.path, wanted.dashes), name


def test_with_a_group_for_each_timer_the_languages_of_ros_2_are_alike() -> None:
    """So one choice stands for both: the simulated one in Python ticks as the real one in C++ did."""
    file, _ = NODES["ROS 2, two threads, a group each"]
    real = load(ROOT / "examples/recordings/ros2/two_timers_cpp_multi_own.csv")
    found = simulate(ROOT / file, real.seconds, real.provenance["command"].split()[1:]).ticks
    for ours, theirs in (("timer_callback", "timerCallback"), ("second_callback", "secondCallback")):
        times = [tick.real for tick in found if tick.source == ours]
        of_real = [tick.real for tick in real.ticks if tick.source == theirs]
        assert of_real == pytest.approx(times[: len(of_real)], abs=0.1) and len(times) - len(of_real) in (0, 1)


def test_it_leaves_its_line_where_one_thread_makes_all_calls(site: Path) -> None:
    lengths, positions = carried(site)
    leaves = {
        name: [length for length, (words, *_) in zip(lengths, found, strict=True) if "leaves" in words]
        for name, found in zip(NODES, positions, strict=True)
    }
    assert leaves["ROS 2, two threads, a group each"] == leaves["ROS 1 in Python"] == []
    assert leaves["ROS 2 in Python"] == leaves["ROS 1 in C++"] == [n / 10 for n in range(12, 21)]
    assert leaves["ROS 2 in C++"] == [n / 10 for n in range(14, 21)]


def test_its_alternative_says_what_is_seen(site: Path) -> None:
    (figure,) = parsed(site / "index.html").select("figure[data-vehicle]")
    (picture,) = figure.select("svg")
    assert picture["aria-label"] == (
        "A vehicle on a winding line, steered by a timer every 0.5 s. ROS 2 in Python, another callback takes 1.8 s: "
        "the vehicle leaves its line by 0.9 m, at 6.5 s. A tick is overdue from 4 s to 5.8 s."
    )
    (words,) = figure.select("output")
    assert words.text == "It leaves its line by 0.9 m, at 6.5\N{NO-BREAK SPACE}s."
    _, positions = carried(site)
    assert len({alternative for found in positions for _, alternative, *_ in found}) == sum(map(len, positions))


def test_it_is_small(site: Path) -> None:
    (figure,) = parsed(site / "index.html").select("figure[data-vehicle]")
    script = (site / "_static/handles/vehicle.js").read_bytes()
    assert len(gzip.compress(str(figure).encode())) + len(gzip.compress(script)) < 30_000


def test_only_the_first_page_loads_its_script(site: Path) -> None:
    pages = {path.relative_to(site).as_posix(): path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert {name for name, text in pages.items() if "handles/vehicle.js" in text} == {"index.html"}


def test_the_readme_shows_it(site: Path) -> None:
    """``make outputs`` writes the file; it is what the run gives."""
    assert stale_picture(ROOT) == []
    drawn = (ROOT / "docs/vehicle.svg").read_text(encoding="utf-8")
    (label,) = re.findall(r'aria-label="([^"]*)"', drawn)
    assert f"![{label}](docs/vehicle.svg)" in (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(gzip.compress(drawn.encode())) < 30_000
