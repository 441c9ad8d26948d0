"""The parts of the benchmark that need a real clock run, at tiny sizes; what they measure is no success."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from benchmarks import lateness, limited, live, ros1_beside, ros2_beside


def test_lateness_is_compared_with_the_real_rclpy(require: Callable[[str], None]) -> None:
    require("ros2")
    title, *lines = ros2_beside.report(turns=[(50, 0.2)], rounds=1)
    assert ["p50 of 10 ticks" in line and "at most 1" in line for line in lines] == [True, False]


def test_the_stand_in_is_compared_with_the_real_ros_1(require: Callable[[str], None]) -> None:
    require("ros1")
    title, *lines = ros1_beside.report(turns=((50, 0.5),), rounds=1, loads=(1,), scenarios=(("timer_oneshot.py",),))
    assert len(lines) == 10
    assert sum("at most 1" in line for line in lines) == 2
    assert sum("stand-in / roscpp" in line for line in lines) == 4


def test_lateness_is_compared_with_deadlines() -> None:
    title, *lines = lateness.report(turns=[(50, 0.2)], rounds=1)
    assert [re.sub(" of .* ticks", "", line[:40]).split()[:4] for line in lines] == [
        ["50", "Hz,", f"{quantile},", name] for quantile in ("p50", "p99") for name in ("Timer", "Rate")
    ]
    assert all(re.search(r"\(.* (ms|µs|s) / .* (ms|µs|s)\)$", line) for line in lines)


@pytest.mark.parametrize(
    ("code", "limit", "why"),
    [
        ("", 60.0, ""),
        ("import sys; sys.exit(3)", 60.0, "it ended with status 3"),
        ("import time; time.sleep(600)", 0.2, "it has taken more than 0.2 s"),
    ],
)
def test_a_part_ends_within_its_limit(code: str, limit: float, why: str) -> None:
    assert limited.run([sys.executable, "-c", code], limit) == why


def test_the_page_is_measured(site: Path, require: Callable[[str], None]) -> None:
    require("browser")
    lines = list(live.report(rounds=1, seconds=1.0, pause=0.0))
    assert sum("at most" in line for line in lines) == 9
    assert "10 ticks" in lines[-1]
