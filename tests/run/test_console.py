"""Reading log lines and ticks out of console text."""

from __future__ import annotations

import math

import pytest

from rosspin import Tick, simulate
from rosspin.results.console import Line, read_lines, read_ticks
from tests.helpers.tree import ROOT

TIMER_NODE = ROOT / "examples" / "my_robotics_pkg" / "src" / "spinner_py_node.py"

# Both nodes under roslaunch: roscpp's colours, padding and nanoseconds, and what is no log line.
LAUNCHED = (
    "process[mrp/spinner_cpp_node-1]: started with pid [20000]\n"
    "\x1b[0m[ INFO] [1650283861.482913600]: [SPINNER CPP NODE] namespace of nh = /mrp/spinner_cpp_node\x1b[0m\n"
    "\x1b[0m[ INFO] [1650283861.989005528]: [SPINNER CPP NODE] counter = 1\x1b[0m\n"
    "[INFO] [1650283862.694406]: [SPINNER PY NODE] counter = 1\n"
    "\x1b[0m[ INFO] [1650283862.487859902]: [SPINNER CPP NODE] counter = 2\x1b[0m\n"
    "[INFO] [1650283863.193749]: [SPINNER PY NODE] counter = 2\n"
    "\x1b[33m[ WARN] [1650283863.2]: slow\x1b[0m\n"
    "\x1b[31m[ERROR] [1650283863.3, 12.500000]: on simulated time\x1b[0m\n"
    "[INFO] [1650283863.693749123] [mrp.spinner_py_node]: [SPINNER PY NODE 2] counter = 1\n"
    "a line of another kind, counter = 7\n"
)


def test_lines_of_cpp_and_python() -> None:
    lines = list(read_lines(LAUNCHED))
    assert len(lines) == 8
    assert lines[0] == Line("INFO", 1650283861.4829136, "[SPINNER CPP NODE] namespace of nh = /mrp/spinner_cpp_node")
    assert lines[2] == Line("INFO", 1650283862.694406, "[SPINNER PY NODE] counter = 1")
    assert lines[5] == Line("WARN", 1650283863.2, "slow")
    assert lines[6] == Line("ERROR", 12.5, "on simulated time")
    assert lines[7] == Line("INFO", 1650283863.693749123, "[SPINNER PY NODE 2] counter = 1")  # ROS 2


@pytest.mark.parametrize("text", ["a\x0cb", "a\u2028b", "a\x85b"])
@pytest.mark.parametrize("end", ["\n", "\r\n", ""])
def test_a_text_is_kept_to_the_end_of_its_line(text: str, end: str) -> None:
    assert list(read_lines(f"[INFO] [1.500000]: {text}{end}")) == [Line("INFO", 1.5, text)]


def test_ticks_by_their_tag_on_the_grid_of_the_period() -> None:
    ticks = read_ticks(LAUNCHED, period=0.5, start=1650283861.0)
    assert [(tick.source, tick.number) for tick in ticks] == [
        ("SPINNER CPP NODE", 1),
        ("SPINNER PY NODE", 1),
        ("SPINNER CPP NODE", 2),
        ("SPINNER PY NODE", 2),
        ("SPINNER PY NODE 2", 1),
    ]
    assert [tick.real for tick in ticks] == pytest.approx([0.989005528, 1.694406, 1.487859902, 2.193749, 2.693749123])
    assert [tick.expected for tick in ticks] == pytest.approx(
        [0.989005528, 1.694406, 1.489005528, 2.194406, 2.693749123]
    )
    assert all(math.isnan(tick.duration) for tick in ticks)


def test_without_a_period_the_median_one_is_taken() -> None:
    text = "".join(f"[INFO] [{time:.6f}]: [A] counter = {n}\n" for n, time in enumerate([1.0, 1.5, 2.1, 2.5, 3.0], 1))
    assert [tick.expected for tick in read_ticks(text)] == pytest.approx([1.0, 1.5, 2.0, 2.5, 3.0])


def test_counters_that_are_missing_leave_their_place_on_the_grid() -> None:
    text = "[INFO] [1.0]: [A] counter = 3\n[INFO] [2.1]: [A] counter = 5\n"
    assert read_ticks(text, period=0.5)[1][:4] == ("A", 5, 2.0, 2.1)


def test_one_tick_and_none() -> None:
    (tick,) = read_ticks("[INFO] [1.0]: [A] counter = 1\n")
    assert tick[:4] == ("A", 1, 1.0, 1.0)
    assert read_ticks("") == read_ticks("[INFO] [1.0]: hello\n") == ()


def test_the_console_of_a_simulated_run_gives_its_ticks() -> None:
    run = simulate(TIMER_NODE, 3)
    read = read_ticks(run.console, period=0.5)
    assert [Tick("timerCallback", *tick[1:4], 0.0) for tick in read] == list(run.ticks)
