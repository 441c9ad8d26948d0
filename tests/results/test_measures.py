"""Figures of merit, and the sentences made from them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin import FaultEvent, Tick, simulate
from rosspin.measures import (
    describe_faults,
    describe_lateness,
    describe_pace,
    describe_periods,
    describe_timeline,
    lost,
    periods,
    quantile,
    say_time,
    side_by_side,
    verdict,
)
from tests.helpers.tree import ROOT


def ticks(*reals: float, period: float = 0.5) -> list[Tick]:
    return [Tick("A", n, n * period, real, 0.0) for n, real in enumerate(reals, 1)]


def test_periods_are_between_neighbours() -> None:
    assert periods(ticks(0.5, 1.0, 1.75)) == [0.5, 0.75]
    assert periods(ticks(0.5)) == periods([]) == []


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(-10, 10), min_size=1, max_size=150), st.integers(0, 1000))
def test_a_quantile_is_the_smallest_value_that_is_no_less_than_its_share(values: list[float], permille: int) -> None:
    enough = [value for value in values if 1000 * sum(other <= value for other in values) >= permille * len(values)]
    assert quantile(values, permille / 1000) == min(enough)


def test_a_share_counts_as_it_is_written() -> None:
    # 0.07 * 100 is 7.000000000000001 in floats, 0.58 * 50 is 28.999999999999996.
    assert [quantile(range(1, 101), percent / 100) for percent in range(1, 101)] == list(range(1, 101))
    assert quantile(range(1, 51), 0.58) == 29
    assert quantile(range(1, 101), 0) == 1


@pytest.mark.parametrize("share", [-0.1, 1.01, 7, float("nan")])
def test_a_share_is_from_0_to_1(share: float) -> None:
    with pytest.raises(ValueError, match="a share is from 0 to 1, not"):
        quantile([1.0], share)


def test_no_values_have_no_quantile() -> None:
    with pytest.raises(ValueError, match="no values"):
        quantile([], 0.5)


@pytest.mark.parametrize(
    ("reals", "gone"),
    [
        ([0.5, 1.0, 1.5, 2.2, 2.5, 3.0], []),
        ([0.5, 1.0, 1.5, 2.7, 2.7, 3.0], []),  # caught up
        ([0.5, 1.0, 1.5, 3.7, 4.2, 4.7], [2.5, 3.0, 3.5]),  # at 3.7 the tick due at 2.0, and then a new grid
        ([0.5, 1.3, 2.1, 2.9, 3.7, 4.5], [3.0, 3.5]),  # 1.2 s late at last: too late
        ([], []),
    ],
)
def test_ticks_that_rospy_loses(reals: list[float], gone: list[float]) -> None:
    assert lost(ticks(*reals), 0.5) == gone


@pytest.mark.parametrize("period", [0, -0.5, math.inf, math.nan])
def test_no_tick_is_lost_of_what_is_no_period(period: float) -> None:
    with pytest.raises(ValueError, match="^a period is above 0 s, not "):
        lost(ticks(0.5, 1.0), period)


@pytest.mark.parametrize(
    ("times", "gone"),
    [
        ([(1.5, 1.5), (2.7, 2.7), (3.2, 3.2), (3.7, 3.7)], [2.0]),
        ([(1.5, 1.5), (3.7, 3.7), (4.2, 4.2)], [2.0, 2.5, 3.0]),
        ([(0.5, 1.3), (1.0, 2.1), (2.1, 2.9), (2.6, 3.7), (3.7, 4.5)], [1.5, 3.0]),  # queued behind another timer
        ([(0.5, 5.5), (5.5, 10.5), (10.5, 15.5)], [*(n / 2 for n in range(2, 11)), *(n / 2 for n in range(12, 21))]),
    ],
)
def test_ticks_that_roscpp_loses(times: list[tuple[float, float]], gone: list[float]) -> None:
    assert lost([Tick("A", n, *pair, 0.0) for n, pair in enumerate(times, 1)], 0.5) == gone


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (2, "2 s"),
        (0.5, "0.5 s"),
        (0.0999, "0.0999 s"),
        (0.05, "50 ms"),
        (0.00131, "1.31 ms"),
        (85e-6, "85 µs"),
        (-0.002, "-2 ms"),
        (1e-9, "0.001 µs"),
        (0, "0 s"),
        (1e-12, "0 s"),
    ],
)
def test_times_in_words(seconds: float, words: str) -> None:
    assert say_time(seconds) == words


def test_lateness_in_words() -> None:
    assert describe_lateness([]) == "There were no ticks."
    assert describe_lateness(ticks(0.5)) == "The only tick was on time."
    assert describe_lateness(ticks(0.7)) == "The only tick was 0.2 s late."
    assert describe_lateness(ticks(0.5, 1.0)) == "All 2 ticks were on time."
    assert describe_lateness(ticks(0.5, 1.0, 1.7)) == (
        "At least half of the 3 ticks were on time; the latest was 0.2 s late."
    )
    assert describe_lateness(ticks(0.501, 1.002, 1.503)) == (
        "Half of the 3 ticks were at most 2 ms late; the latest was 3 ms late."
    )
    assert describe_lateness(ticks(*(n * 0.502 for n in range(1, 202)))) == (
        "Half of the 201 ticks were at most 0.202 s late and 99% at most 0.398 s; the latest was 0.402 s late."
    )


def test_periods_in_words() -> None:
    assert describe_periods(ticks(0.5)) == "There was no second tick, and so no period."
    assert describe_periods(ticks(0.5, 1.0, 1.5)) == "Every period was 0.5 s; there was no jitter."
    assert describe_periods(ticks(0.5, 1.0, 1.51)) == (
        "The median period was 505.000 ms; all 2 periods lay between 500.000 ms and 510.000 ms: a jitter of 10 ms."
    )
    assert describe_periods(ticks(*(n * 0.5 + 0.01 * (n == 50) for n in range(1, 151)))) == (
        "The median period was 500.000 ms; "
        "98% of the 149 periods lay between 500.000 ms and 500.000 ms: a jitter of 0 s."
    )


def test_the_pace_in_words() -> None:
    assert describe_pace([]) == "no ticks"
    assert describe_pace(ticks(0.5)) == "1 tick"
    assert describe_pace(ticks(0.5, 1.0, 1.5)) == "3 ticks, one every 0.5 s"
    assert describe_pace(ticks(0.5, 1.0, 1.75)) == "3 ticks, 0.5 s to 0.75 s apart"


@pytest.mark.parametrize(
    ("block", "every", "words"),
    [
        (0.7, False, "keeps its grid, no tick lost"),
        (1.2, False, "starts a new grid, 1 tick lost"),
        (2.2, False, "starts a new grid, 3 ticks lost"),
        (0.4, True, "keeps its grid, no tick lost"),
        (0.8, True, "back to back, every 0.8 s, 3 ticks lost"),
    ],
)
def test_the_verdict_on_a_slow_callback(block: float, every: bool, words: str) -> None:
    args = [f"_block:={block}", f"_block_call:={0 if every else 3}"]
    assert verdict(simulate(ROOT / "examples/timing_probes/src/timer_probe.cpp", 6.0, args).ticks, 0.5) == words


def test_the_verdict_where_ticks_are_dropped_and_the_grid_is_kept() -> None:
    """As in ROS 2."""
    times = {0.5: 0.5, 1.0: 1.0, 1.5: 2.7, 3.0: 3.0, 3.5: 3.5}
    dropped = [Tick("A", n, expected, real, 0.0) for n, (expected, real) in enumerate(times.items(), 1)]
    assert verdict(dropped, 0.5) == "keeps its grid, 2 ticks lost"
    assert verdict([], 0.5) == "no ticks"
    # Dropped to the end of the run as well.
    assert verdict(dropped, 0.5, due=7) == verdict(dropped, 0.5, due=8) == "keeps its grid, 2 ticks lost"
    assert verdict(dropped, 0.5, due=12) == "keeps its grid, 5 of 12 ticks came"
    assert verdict([], 0.5, due=12) == "never called (0 of 12)"


def test_rounded_times_lose_no_tick() -> None:
    """The real rclpy rounds when a tick was expected, by microseconds."""
    assert lost([Tick("A", n, n * 0.02 - 5e-5 * (n % 2), n * 0.02, 0.0) for n in range(2, 9)], 0.02) == []


def test_times_beside_short_ones_are_in_their_unit() -> None:
    late = [Tick("A", n, n * 0.5, n * 0.5 + lateness, 0.0) for n, lateness in enumerate((0.002, 0.03, 0.109), 1)]
    assert describe_lateness(late) == "Half of the 3 ticks were at most 30 ms late; the latest was 109 ms late."


@pytest.mark.parametrize(
    ("times", "duration", "words"),
    [
        ({0.5: 0.7, 1.0: 1.2, 1.5: 1.7}, 0.0, "0.2 s late, no tick lost"),
        ({0.5: 1.3, 1.5: 2.9, 3.0: 4.5}, 0.0, "up to 1.5 s late, 3 ticks lost"),
        ({0.5: 0.5, 1.5: 1.5, 2.0: 2.0}, 0.8, "keeps its grid, overlaps itself, 1 tick lost"),
        ({0.5: 0.5, 1.0: 1.0, 1.5: 1.5}, 0.8, "keeps its grid, overlaps itself"),
    ],
)
def test_the_verdict_on_a_timer_beside_a_slow_one(times: dict[float, float], duration: float, words: str) -> None:
    """As in ROS 2."""
    found = [Tick("A", n, expected, real, duration) for n, (expected, real) in enumerate(times.items(), 1)]
    assert verdict(found, 0.5) == words


def test_calls_at_once_are_counted() -> None:
    def calls(*durations: float) -> list[Tick]:
        return [Tick("A", n, n * 0.5, n * 0.5, duration) for n, duration in enumerate(durations, 1)]

    assert side_by_side([]) == 0
    assert [side_by_side(calls(*each)) for each in ((0.5, 0.5), (0.5005, 0.1), (math.nan, 0.1))] == [1, 1, 1]
    assert [side_by_side(calls(*each)) for each in ((0.6, 0.1), (1.2, 1.2, 1.2), (2.0, 0.1, 0.1))] == [2, 3, 2]
    assert describe_timeline("A", calls(0.6, 0.6)).endswith(" were on time. Up to 2 calls ran side by side.")


def test_what_faults_did_is_said() -> None:
    assert describe_faults([]) == ""
    assert describe_faults([FaultEvent(2.0, "killed", "/camera")]) == "Faults: /camera killed at 2.000 s."
    dropped = [FaultEvent(time, "dropped", "/scan from /a to /b") for time in (0.1, 0.4, 2.0)]
    slowed = [FaultEvent(time, "slowed", "/b on_scan", 0.05) for time in (1.0, 3.0)]
    assert describe_faults([dropped[0], *slowed, *dropped[1:]]) == (
        "Faults: /scan from /a to /b dropped 3 times from 0.100 s to 2.000 s; "
        "/b on_scan slowed by 50 ms 2 times from 1.000 s to 3.000 s."
    )
