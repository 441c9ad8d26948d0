"""rospy.Rate, rospy.Timer and rospy.sleep: when they tick, compared with a plain model."""

from __future__ import annotations

import copy
import pickle
import re
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin import Run, TimeStandsStill, rospy, simulate
from rosspin.rospy import rostime
from tests.helpers.python_texts import of_any_python

NS = 10**9
some = settings(max_examples=100, deadline=None)

periods = st.integers(1000, 10 * NS)
# Work in periods, mostly around the limits of 1, 2 and 3 periods.
works = st.lists(
    st.one_of(st.floats(0, 5), st.sampled_from([0, 1, 2, 3, 4, 0.999999, 1.000001, 2.999999, 3.000001])),
    min_size=1,
    max_size=12,
)


def ends(period: int, begin: int, lengths: list[int]) -> list[int]:
    """When ``sleep`` returns after passes of these lengths: at the end of the pass's slot, or at once if that is over.

    Slots follow one another without a gap, until a pass has taken more than three of them: the next one starts at its
    end then.
    """
    slot, now, returns = begin, begin, []
    for length in lengths:
        asked = now + length
        now = max(asked, slot + period)
        slot = asked if asked - slot > 3 * period else slot + period
        returns.append(now)
    return returns


def rate_returns(hz: float, lengths: list[int]) -> list[int]:
    returns = []

    def node() -> None:
        rospy.init_node("node")
        rate = rospy.Rate(hz)
        for length in lengths:
            rospy.sleep(rospy.Duration(0, length))
            rate.sleep()
            returns.append(rospy.Time.now().to_nsec())

    run = simulate(node, 10_000)
    assert (run.status, run.console) == (0, "")
    return returns


@some
@given(periods, works)
def test_rate_returns_when_the_model_says(period: int, works: list[float]) -> None:
    lengths = [int(work * period) for work in works]
    assert rate_returns(1e9 / period, lengths) == ends(int(1e9 / (1e9 / period)), 0, lengths)


def start_timer_that_works(
    period: rospy.Duration, lengths: list[int], events: list[Any], began: list[int], ended: list[int]
) -> None:
    """A timer whose callbacks work for these lengths; when they did, and the events that they were given."""

    def callback(event: Any) -> None:
        events.append(event)
        began.append(rospy.Time.now().to_nsec())
        rospy.sleep(rospy.Duration(0, lengths.pop(0) if lengths else 0))
        ended.append(rospy.Time.now().to_nsec())

    rospy.Timer(period, callback)


@some
@given(periods, works, st.integers(0, NS))
def test_a_timer_ticks_when_the_model_says(period: int, works: list[float], start: int) -> None:
    lengths = [int(work * period) for work in works]
    began: list[int] = []
    ended: list[int] = []
    events: list[Any] = []

    def node() -> None:
        rospy.init_node("node")
        rospy.sleep(rospy.Duration(0, start))
        start_timer_that_works(rospy.Duration(0, period), lengths[:], events, began, ended)
        rospy.spin()

    # Long enough for all of the work, and not much longer.
    simulate(node, (start + sum(lengths) + period * (len(lengths) + 2)) / NS)
    # The thread paces itself by a Rate made from the period in seconds, whose first pass has no work to do.
    paced = int(1e9 / (1.0 / rospy.Duration(0, period).to_sec()))
    expected = ends(paced, start, [0, *lengths])
    count = len(expected)
    assert began[:count] == expected

    # Every field of every event.
    for number, event in enumerate(events[:count]):
        assert event.current_expected.to_nsec() == start + (number + 1) * period
        assert event.current_real.to_nsec() == expected[number]
        if number == 0:
            assert (event.last_expected, event.last_real, event.last_duration) == (None, None, None)
        else:
            assert event.last_expected.to_nsec() == start + number * period
            assert event.last_real.to_nsec() == expected[number - 1]
            assert event.last_duration == (ended[number - 1] - began[number - 1]) / 1e9
            assert type(event.last_duration) is float
        assert type(event.current_expected) is type(event.current_real) is rospy.Time


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.integers(1, 20), works), min_size=2, max_size=4))
def test_timers_do_not_disturb_each_other(timers: list[tuple[int, list[float]]]) -> None:
    """Periods in ms, so that many ticks of different timers fall due together and blocked ones overlap."""
    ms = 1_000_000
    plans = [(period * ms, [int(work * period) * ms for work in works]) for period, works in timers]
    began: list[list[int]] = [[] for _ in plans]

    def node() -> None:
        rospy.init_node("node")
        for number, (period, lengths) in enumerate(plans):
            start_timer_that_works(rospy.Duration(0, period), lengths[:], [], began[number], [])
        rospy.spin()

    simulate(node, 0.2)
    for number, (period, lengths) in enumerate(plans):
        paced = int(1e9 / (1.0 / rospy.Duration(0, period).to_sec()))
        expected = ends(paced, 0, [0, *lengths, *[0] * (200 * ms // period)])
        assert began[number] == [time for time in expected if time <= 200 * ms]


# --- the facts, literally ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("blocks", "ticks"),
    [
        (0.7, [0.5, 1.0, 1.5, 2.2, 2.5, 3.0]),
        (1.2, [0.5, 1.0, 1.5, 2.7, 2.7, 3.0, 3.5]),
        (2.2, [0.5, 1.0, 1.5, 3.7, 4.2, 4.7]),
    ],
)
def test_one_slow_callback(blocks: float, ticks: list[float]) -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), callback)
        rospy.spin()

    calls: list[Any] = []

    def callback(event: Any) -> None:
        calls.append(event)
        if len(calls) == 3:
            rospy.sleep(blocks)

    run = simulate(node, ticks[-1])
    assert [tick.real for tick in run.ticks] == pytest.approx(ticks)
    assert [tick.expected for tick in run.ticks] == [0.5 * n for n in range(1, len(ticks) + 1)]
    assert run.ticks[2].duration == pytest.approx(blocks)
    if blocks == 2.2:
        late = calls[3]
        assert (late.current_expected.to_sec(), late.current_real.to_sec()) == (2.0, 3.7)


@pytest.mark.parametrize(
    ("blocks", "returns"),
    [(0.7, [0.5, 1.0, 1.5, 2.2, 2.5]), (1.2, [0.5, 1.0, 1.5, 2.7, 2.7, 3.0]), (2.2, [0.5, 1.0, 1.5, 3.7, 4.2])],
)
def test_one_slow_pass_of_a_rate(blocks: float, returns: list[float]) -> None:
    lengths = [0, 0, 0, int(blocks * NS), *[0] * (len(returns) - 4)]
    assert [time / NS for time in rate_returns(2.0, lengths)] == pytest.approx(returns)


def test_work_longer_than_the_period_runs_back_to_back() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), lambda event: rospy.sleep(0.8))
        rospy.spin()

    real = [tick.real for tick in simulate(node, 8.5).ticks]
    assert real == pytest.approx([0.5 + 0.8 * n for n in range(11)])


def test_a_rate_gives_its_period_and_what_is_left_of_it() -> None:
    def node() -> None:
        rospy.init_node("node")
        rate = rospy.Rate(4)
        assert rate.sleep_dur == rospy.Duration(0.25)
        rospy.sleep(0.1)
        assert rate.remaining() == rospy.Duration(0.15)
        assert type(rate.remaining()) is rospy.Duration
        rospy.sleep(0.2)
        assert rate.remaining() == rospy.Duration(-0.05)
        assert rate.last_time == rospy.Time(0)
        rate.sleep()
        assert rate.last_time == rospy.Time(0.25)

    assert simulate(node, 1).status == 0


# --- bad values -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("hz", "error", "text"),
    [
        (0, ZeroDivisionError, "division by zero"),
        ("2", TypeError, "unsupported operand type(s) for /: 'float' and 'str'"),
        (None, TypeError, "unsupported operand type(s) for /: 'float' and 'NoneType'"),
        (float("nan"), ValueError, "cannot convert float NaN to integer"),
    ],
)
def test_what_is_no_rate(hz: Any, error: type[Exception], text: str) -> None:
    def node() -> None:
        rospy.init_node("node")
        with pytest.raises(error) as caught:
            rospy.Rate(hz)
        assert of_any_python(str(caught.value)) == text

    assert simulate(node, 1).status == 0


def test_a_negative_rate_never_sleeps() -> None:
    assert rate_returns(-2.0, [0, 0, 5, 0]) == [0, 0, 5, 5]


@pytest.mark.parametrize(
    ("length", "text"),
    [
        (None, "'<' not supported between instances of 'NoneType' and 'int'"),
        ("1", "'<' not supported between instances of 'str' and 'int'"),
        (float("nan"), "Invalid value NaN (not a number)"),
    ],
)
def test_what_is_no_length_of_sleep(length: Any, text: str) -> None:
    def node() -> None:
        rospy.init_node("node")
        with pytest.raises((TypeError, ValueError)) as caught:
            rospy.sleep(length)
        assert of_any_python(str(caught.value)) == text

    assert simulate(node, 1).status == 0


def test_sleep_takes_seconds_or_a_duration_and_returns_at_once_if_negative() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.sleep(0.5)
        rospy.sleep(rospy.Duration(1, 5))
        rospy.sleep(2)
        rospy.sleep(-1)
        rospy.sleep(rospy.Duration(-1))
        assert rospy.Time.now() == rospy.Time(3, 500_000_005)

    assert simulate(node, 10).status == 0


def dies(period: Any) -> Run:
    def node() -> None:
        rospy.init_node("node")
        timer = rospy.Timer(period, lambda event: rospy.loginfo("must not be called"))
        rospy.sleep(1)
        assert not timer.is_alive()

    return simulate(node, 10)


@pytest.mark.parametrize(
    ("period", "last_line"),
    [
        (rospy.Duration(0), "ZeroDivisionError: division by zero"),
        (0.5, "AttributeError: 'float' object has no attribute 'to_sec'"),
    ],
)
def test_a_timer_with_a_bad_period_dies_alone(period: Any, last_line: str) -> None:
    run = dies(period)
    assert run.status == 0
    assert run.console.startswith("Exception in thread Thread-1:\nTraceback")
    assert re.search(r'  File ".*", line \d+, in node, which made this timer\n    timer = rospy.Timer\(', run.console)
    assert of_any_python(run.console).endswith(last_line + "\n")


def test_a_timer_with_a_negative_period_is_a_busy_loop() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(-0.5), lambda event: None)
        rospy.spin()

    with pytest.raises(TimeStandsStill):
        simulate(node, 10)


# --- the life of a timer ----------------------------------------------------------------------------------------------


def real_times(setup: Callable[[], Any], seconds: float) -> tuple[list[tuple[str, float]], str]:
    """The ticks of the timers that ``setup`` makes, with their sources, and the console."""

    def node() -> None:
        rospy.init_node("node")
        setup()
        rospy.spin()

    run = simulate(node, seconds)
    return [(tick.source, tick.real) for tick in run.ticks], run.console


def test_a_oneshot_timer_ticks_once() -> None:
    def once(event: Any) -> None:
        pass

    ticks, _ = real_times(lambda: rospy.Timer(rospy.Duration(0.5), once, oneshot=True), 5)
    assert ticks == [("once", 0.5)]


def test_shutdown_in_the_callback_is_the_end_of_the_timer() -> None:
    timers: list[rospy.Timer] = []

    def callback(event: Any) -> None:
        if event.current_real >= rospy.Time(1.5):
            timers[0].shutdown()

    ticks, console = real_times(lambda: timers.append(rospy.Timer(rospy.Duration(0.5), callback)), 5)
    assert ticks == [("callback", 0.5), ("callback", 1.0), ("callback", 1.5)]
    assert console == ""


def test_a_sleeping_timer_sees_its_shutdown_when_it_wakes_up() -> None:
    alive: list[object] = []

    def setup() -> None:
        timer = rospy.Timer(rospy.Duration(0.5), lambda event: None)
        rospy.sleep(0.6)
        timer.shutdown()
        rospy.sleep(0.3)
        alive.append(timer.is_alive())
        timer.join()
        alive.append((timer.is_alive(), rospy.get_time()))

    ticks, _ = real_times(setup, 5)
    assert [real for _, real in ticks] == [0.5]
    assert alive == [True, (False, 1.0)]


def test_join_waits_no_longer_than_it_is_told() -> None:
    def setup() -> None:
        timer = rospy.Timer(rospy.Duration(5), lambda event: None)
        timer.join(0.25)
        assert timer.is_alive() and rospy.get_time() == 0.25

    assert real_times(setup, 2) == ([], "")


def test_an_exception_in_a_callback_ends_that_timer_alone() -> None:
    def fails(event: Any) -> None:
        raise RuntimeError("too hot")

    def goes_on(event: Any) -> None:
        pass

    def setup() -> None:
        rospy.Timer(rospy.Duration(0.5), fails)
        rospy.Timer(rospy.Duration(0.5), goes_on)

    ticks, console = real_times(setup, 1.5)
    assert ticks == [("fails", 0.5), ("goes_on", 0.5), ("goes_on", 1.0), ("goes_on", 1.5)]
    assert console.startswith("Exception in thread Thread-1:\nTraceback (most recent call last):\n")
    assert console.endswith("RuntimeError: too hot\n")
    # The node's own frames only.
    assert console.count("  File ") == 1


@pytest.mark.parametrize("error", [SystemExit, KeyboardInterrupt])
def test_a_callback_that_exits_ends_its_timer_only(error: type[BaseException]) -> None:
    def leaves(event: Any) -> None:
        raise error

    def setup() -> None:
        rospy.Timer(rospy.Duration(0.5), leaves)

    ticks, console = real_times(setup, 2)
    assert ticks == [("leaves", 0.5)]
    # As for any thread: SystemExit is silent.
    assert console.endswith("KeyboardInterrupt\n") if error is KeyboardInterrupt else console == ""


def test_a_timer_can_start_timers() -> None:
    def inner(event: Any) -> None:
        pass

    def outer(event: Any) -> None:
        rospy.Timer(rospy.Duration(0.2), inner, oneshot=True)

    ticks, _ = real_times(lambda: rospy.Timer(rospy.Duration(0.5), outer), 1.0)
    assert ticks == [("outer", 0.5), ("inner", 0.7), ("outer", 1.0)]


def test_a_timer_ticks_whoever_holds_it_and_without_spin() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), lambda event: None)
        rospy.sleep(1.2)

    assert [tick.real for tick in simulate(node, 10).ticks] == [0.5, 1.0]


def test_two_timers_on_one_callback_are_two_sources() -> None:
    def callback(event: Any) -> None:
        pass

    def setup() -> None:
        rospy.Timer(rospy.Duration(0.5), callback)
        rospy.Timer(rospy.Duration(0.5), callback)

    ticks, _ = real_times(setup, 0.5)
    assert ticks == [("callback", 0.5), ("callback 2", 0.5)]


# --- ROS time that is told, as from /clock ----------------------------------------------------------------------------


def tell(*times: float) -> None:
    """Tell the ROS time, ten times a second."""
    for told in times:
        rostime._set_rostime(rospy.Time.from_sec(told))
        rostime.wallsleep(0.1)


def tell_later(*times: float) -> None:
    """As tell, once the others are asleep."""
    rostime.wallsleep(0.05)
    tell(*times)


def on_ros_time(setup: Callable[[], Any], *times: float) -> tuple[list[float], str]:
    """When, in ROS time, the timers that ``setup`` makes tick, while the time is told; and the console."""

    def node() -> None:
        rospy.init_node("node")
        tell(0)
        setup()
        tell(0, *times)

    run = simulate(node, 1000)
    assert run.status == 0
    return [tick.real for tick in run.ticks], run.console


def timer(event: Any) -> None:
    pass


def steps(first: float, last: float) -> list[float]:
    return [round(first + 0.1 * n, 1) for n in range(round((last - first) * 10) + 1)]


def start_timer(reset: bool = False) -> rospy.Timer:
    return rospy.Timer(rospy.Duration(0.5), timer, reset=reset)


def test_without_a_time_a_timer_waits_in_silence() -> None:
    assert on_ros_time(start_timer, *[0] * 50) == ([], "")


def test_the_first_times_bring_two_ticks_at_once() -> None:
    ticks, _ = on_ros_time(start_timer, *steps(100, 101.5))
    assert ticks == [100.5, 100.5, 101.0, 101.5]


def test_a_jump_forward_brings_two_ticks_and_the_rest_are_lost() -> None:
    ticks, _ = on_ros_time(start_timer, *steps(0.1, 1.2), *steps(50, 51))
    assert ticks == [0.6, 1.0, 50.0, 50.0, 50.5, 51.0]


def test_a_jump_back_ends_a_timer_unless_it_resets() -> None:
    times = [*steps(10.0, 11.2), *steps(5.0, 6.0)]
    ticks, console = on_ros_time(start_timer, *times)
    assert ticks == [10.5, 10.5, 11.0]
    assert console.endswith("rospy.exceptions.ROSTimeMovedBackwardsException: ROS time moved backwards\n")
    ticks, console = on_ros_time(lambda: start_timer(reset=True), *times)
    # The rate restarts at 5.0: one call at once, as sleep has returned.
    assert ticks == [10.5, 10.5, 11.0, 5.0, 5.5, 6.0]
    assert console == ""


@pytest.mark.parametrize(
    ("sleep", "raises"),
    [
        (lambda: rospy.Rate(2).sleep(), True),
        (lambda: rospy.Rate(2, reset=True).sleep(), False),
        (lambda: rospy.sleep(1), True),
    ],
    ids=["Rate", "Rate with reset", "sleep"],
)
def test_a_jump_back_ends_a_sleep(sleep: Callable[[], None], raises: bool) -> None:
    def node() -> None:
        rospy.init_node("node")
        tell(20)
        threading.Thread(target=lambda: tell_later(20.1, 18), daemon=True).start()
        try:
            sleep()
        except rospy.ROSTimeMovedBackwardsException as error:
            assert raises
            assert str(error) == "ROS time moved backwards"
            assert error.time == pytest.approx(2)
        else:
            assert not raises
        assert rospy.get_time() == 18

    assert simulate(node, 100).console == ""


def test_a_jump_back_between_two_sleeps_begins_a_period() -> None:
    def node() -> None:
        rospy.init_node("node")
        tell(20)
        rate = rospy.Rate(2)
        tell(5)
        threading.Thread(target=lambda: tell_later(*steps(5, 6)), daemon=True).start()
        rate.sleep()
        assert rospy.get_time() == 5.5

    assert simulate(node, 100).console == ""


def test_a_rate_that_resets_begins_a_period_at_the_jump() -> None:
    def node() -> None:
        rospy.init_node("node")
        tell(20)
        rate = rospy.Rate(2, reset=True)
        threading.Thread(target=lambda: tell_later(20, *steps(5, 6)), daemon=True).start()
        rate.sleep()
        rospy.sleep(0.2)  # work in the new period
        rate.sleep()
        assert rospy.get_time() == 5.5

    assert simulate(node, 100).console == ""


def test_shutdown_ends_a_sleep_on_ros_time_only() -> None:
    def told() -> None:
        rospy.init_node("node")
        tell(20)
        rospy.sleep(1000)

    run = simulate(told, 2)
    assert run.console.endswith("rospy.exceptions.ROSInterruptException: ROS shutdown request\n")
    assert run.status == 1

    def own() -> None:
        rospy.init_node("node")
        rospy.sleep(5)
        print("slept until", rospy.get_time(), rospy.is_shutdown())

    assert simulate(own, 2).console == "slept until 5.0 True\n"


def test_only_a_time_is_taken_for_one() -> None:
    def node() -> None:
        rospy.init_node("node")
        with pytest.raises(ValueError, match="^must be Time instance: <class 'int'>$"):
            rostime._set_rostime(5)  # type: ignore[arg-type]
        rostime._set_rostime(rospy.Time(7))
        assert rospy.get_time() == 7 and not rostime.is_wallclock()
        rostime.switch_to_wallclock()
        assert rospy.get_time() == 0 and rostime.is_wallclock()

    assert simulate(node, 1).status == 0


# --- the event --------------------------------------------------------------------------------------------------------


def event_seen(look: Callable[[Any], object]) -> list[object]:
    """What ``look`` finds in the first event of a timer, and in the second, after a call of 0.1 s."""
    found: list[object] = []

    def callback(event: rospy.timer.TimerEvent) -> None:
        found.append(look(event))
        rospy.sleep(0.1)

    real_times(lambda: rospy.Timer(rospy.Duration(0.5), callback), 1.0)
    return found


FIRST = dict(
    last_expected=None,
    last_real=None,
    current_expected=rospy.Time(0.5),
    current_real=rospy.Time(0.5),
    last_duration=None,
)
SECOND = dict(
    last_expected=rospy.Time(0.5),
    last_real=rospy.Time(0.5),
    current_expected=rospy.Time(1),
    current_real=rospy.Time(1),
    last_duration=0.1,
)


@pytest.mark.parametrize(
    "look",
    [
        lambda event: {name: getattr(event, name) for name in FIRST},
        lambda event: {name: getattr(event, name) for name in reversed(FIRST)},
        lambda event: dict(vars(event)),
        lambda event: vars(copy.copy(event)),
        lambda event: vars(pickle.loads(pickle.dumps(event))),
    ],
)
def test_an_event_has_its_attributes_however_they_are_asked_for(look: Callable[[Any], object]) -> None:
    assert event_seen(look) == [FIRST, SECOND]


def test_the_attributes_of_an_event_are_listed_in_their_order() -> None:
    assert event_seen(lambda event: list(vars(event))) == [list(FIRST)] * 2
    assert event_seen(lambda event: [name for name in dir(event) if not name.startswith("__")]) == [sorted(FIRST)] * 2


def test_what_a_callback_sets_of_an_event_stays() -> None:
    def look(event: Any) -> dict[str, Any]:
        event.current_real, event.note = 7, "mine"
        return dict(vars(event))

    assert event_seen(look) == [each | dict(current_real=7, note="mine") for each in (FIRST, SECOND)]


def test_what_an_event_has_not_is_an_error() -> None:
    def look(event: Any) -> str:
        with pytest.raises(AttributeError) as caught:
            event.real
        return str(caught.value)

    assert event_seen(look) == ["'TimerEvent' object has no attribute 'real'"] * 2


def test_the_time_that_is_told_wakes_all_who_sleep_by_it() -> None:
    """At once, and a sleep ends with the very time at which it should end."""

    def node() -> None:
        rospy.init_node("node")
        tell(1)

        def sleeper(name: str) -> None:
            rospy.sleep(1.0)
            print(name, time.time())

        for name in "abc":
            threading.Thread(target=sleeper, args=(name,)).start()
        tell(1, 2)

    assert simulate(node, 10).console == "a 0.2\nb 0.2\nc 0.2\n"
