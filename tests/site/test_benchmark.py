"""The parts of the benchmark run, at tiny sizes; what they measure is no success or failure."""

from __future__ import annotations

import runpy
from itertools import count
from pathlib import Path
from typing import Any

import pytest

from benchmarks import day, ratios, ros2, site_build, threads, ticks, topics
from benchmarks.rclpy_oracle import real_rclpy
from rosspin import Run

pytestmark = pytest.mark.shares(3)


@pytest.fixture(autouse=True)
def _counted_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """A second passes with each look at the time: on a busy machine, none may pass while little is measured."""
    monkeypatch.setattr("time.process_time", count().__next__)


def test_the_three_runtimes_make_the_same_ticks() -> None:
    periods = [5_000_000, 6_000_000, 7_000_000]
    assert ticks.in_simpy(periods, 4) == ticks.on_the_clock(periods, 4) == 12
    assert ticks.with_timers([5_000_000] * 3, 4) == 12


def test_ticks_are_compared_for_each_number_of_timers() -> None:
    title, *lines = ticks.report(sizes=(1, 3), ticks=30, rounds=1)
    assert [line.count("at most") for line in lines] == [1] * 5
    assert "3 timers, the bare clock / SimPy" in lines[2] and "3 timers / 1" in lines[4]


def test_threads_and_locks_are_compared() -> None:
    title, lock, thread = threads.report(pairs=100, few=2, many=4, rounds=1)
    assert "simulated / real" in lock and "at most 10" in lock
    assert "4 in one run / 2" in thread and "at most 2" in thread


def test_threads_that_do_not_end_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(threads, "simulate", lambda node, seconds: Run("", (), 0, "simulated", seconds))
    with pytest.raises(AssertionError, match="not 2 threads that ended at 1 s"):
        threads.start_threads(2)


def test_topics_are_compared() -> None:
    title, message, many, among = topics.report(messages=50, topics=3, seconds=1.0, nodes=2, rounds=1)
    assert "a timer's tick" in message and "at most 6" in message
    assert "3 topics at 10 Hz" in many and "at least 20" in many
    assert "3 topics at 10 Hz among 2 nodes" in among and "at least 30" in among


def test_messages_that_do_not_arrive_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(topics, "simulate", lambda node, seconds: Run("", (), 0, "simulated", seconds))
    for function in (
        topics.tick,
        topics.publish,
        lambda number: topics.many(number, 1.0),
        lambda number: topics.among(2, number, 1.0),
    ):
        with pytest.raises(AssertionError, match="for "):
            function(5)


def test_ros_2_is_compared() -> None:
    title, tick, *oracle, day = ros2.report(hours=0.1, ticks=30, rounds=1)
    assert "rospy's" in tick and "at most 4.5" in tick
    assert all("its own Python's" in line for line in oracle) and len(oracle) == bool(real_rclpy())
    assert "at least 10,000" in day


def test_ticks_of_ros_2_that_are_missing_are_an_error() -> None:
    with pytest.raises(AssertionError, match="0 ticks for 3"):
        ros2.run(lambda: None, 3)


def test_a_day_is_complete_and_leaves_no_memory() -> None:
    title, speed, memory = day.report(hours=0.1, rounds=1)
    assert "720 counters" in title
    assert "at least 20,000" in speed
    assert "at most 0.01" in memory
    held, left = day.memory(360.0)
    assert left < held / 10


def test_a_process_that_a_part_spawns_measures_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    """It imports the file that was started."""
    runpy.run_module("benchmarks.__main__", run_name="__mp_main__")
    assert capfd.readouterr().out == ""


def test_a_day_that_lacks_a_counter_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(day, "PERIOD", 0.25)
    with pytest.raises(AssertionError, match="not 8 counters"):
        day.spin(2.0)


def test_the_build_is_compared_with_its_notebooks(tmp_path: Path) -> None:
    source, folder = tmp_path / "source", tmp_path / "built"
    source.mkdir()
    (source / "conf.py").write_text("extensions = ['myst_nb']\nnb_execution_mode = 'force'\n")
    (source / "index.md").write_text(
        "---\nfile_format: mystnb\nkernelspec: {name: python3}\n---\n# A notebook\n\n```{code-cell}\n1 + 1\n```\n"
    )
    took = site_build.build(source, folder)
    executed = site_build.execution_times(folder)
    assert list(executed) == ["index"]
    assert 0 < executed["index"] < took


@pytest.mark.parametrize(
    ("value", "goal", "expected"),
    [
        (0.5, {"most": 1}, "0.50   at most 1: holds"),
        (1.5, {"most": 1}, "1.50   at most 1: MISSED"),
        (30_000.0, {"least": 20_000}, "30,000   at least 20,000: holds"),
        (7.0, {"least": 20_000}, "7.00   at least 20,000: MISSED"),
        (2.0, {}, "2.00"),
    ],
)
def test_a_line_says_whether_its_goal_holds(value: float, goal: Any, expected: str) -> None:
    assert ratios.line("what", value, **goal).endswith(expected)
