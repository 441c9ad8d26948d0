"""rclpy's timers, Rates and clocks: when they tick, compared with a plain model and with the real one."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin import Run, rclpy, simulate

NS = 10**9
some = settings(max_examples=60, deadline=None)

Spun = Callable[[Any], object]


def spun(
    prepare: Spun,
    seconds: float,
    executor: Callable[[], Any] | None = None,
    args: tuple[str, ...] = (),
    console: str = "",
) -> Run:
    """A node that ``prepare(node)`` makes something of, and that is spun until it is shut down at the end."""

    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")
        kept = prepare(node)
        try:
            rclpy.spin(node, executor() if executor else None)
        except KeyboardInterrupt:
            pass
        del kept

    run = simulate(node, seconds, args)
    assert (run.status, run.console.partition("\n")[0]) == (0, console)
    return run


def times(run: Run, source: str) -> list[float]:
    return [tick.real for tick in run.ticks if tick.source == source]


def works(*seconds: float) -> Callable[[], None]:
    """A callback that takes so long, one time after the other, and then no time."""
    left = list(seconds)

    def callback() -> None:
        time.sleep(left.pop(0) if left else 0)

    return callback


# --- one timer --------------------------------------------------------------------------------------------------------


@some
@given(st.integers(1000, 10 * NS), st.lists(st.integers(0, 50 * NS), min_size=1, max_size=10))
def test_a_timer_keeps_its_grid_whatever_its_callback_takes(period: int, lengths: list[int]) -> None:
    calls = []

    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")

        def callback() -> None:
            clock = node.get_clock()
            calls.append(clock.now().nanoseconds)
            clock.sleep_for(rclpy.duration.Duration(nanoseconds=lengths[len(calls) - 1]))
            if len(calls) == len(lengths):
                rclpy.shutdown()

        timer = node.create_timer(1.0, callback)
        timer.timer_period_ns = period
        timer.reset()
        rclpy.spin(node)

    assert simulate(node, 10_000).status == 0
    due, free, expected = period, 0, []
    for length in lengths:
        call = max(due, free)
        expected.append(call)
        due += period
        if due <= call:
            due = call + period - (call - due) % period
        free = call + length
    assert calls == expected


@pytest.mark.parametrize(
    ("blocks", "expected"),
    [
        (0.7, [0.5, 1.0, 1.5, 2.2, 2.5, 3.0]),
        (1.2, [0.5, 1.0, 1.5, 2.7, 3.0, 3.5]),
        (2.2, [0.5, 1.0, 1.5, 3.7, 4.0, 4.5]),
        (1.0, [0.5, 1.0, 1.5, 2.5, 3.0, 3.5]),  # the end falls on the grid: that call is the late one
    ],
)
def test_after_a_long_callback_one_call_is_late(blocks: float, expected: list[float]) -> None:
    def prepare(node: Any) -> None:
        node.create_timer(0.5, works(0, 0, blocks))

    assert times(spun(prepare, expected[-1]), "callback") == expected


def test_a_tick_says_when_it_was_due() -> None:
    run = spun(lambda node: node.create_timer(0.5, works(0, 1.2)), 2.5)
    assert [(tick.number, tick.expected, tick.real, tick.duration) for tick in run.ticks] == [
        (1, 0.5, 0.5, 0.0),
        (2, 1.0, 1.0, 1.2),
        (3, 1.5, 2.2, 0.0),
        (4, 2.5, 2.5, 0.0),
    ]


def test_a_timer_that_nobody_spins_ticks_once_when_somebody_does() -> None:
    def prepare(node: Any) -> None:
        node.create_timer(0.5, works())
        time.sleep(2.2)

    assert times(spun(prepare, 3), "callback") == [2.2, 2.5, 3.0]


def test_cancel_and_reset() -> None:
    def prepare(node: Any) -> None:
        timer = node.create_timer(0.5, works())
        other = node.create_timer(0.3, lambda: None, autostart=False)
        assert (timer.is_canceled(), other.is_canceled(), other.time_until_next_call()) == (False, True, None)
        for when, do in ((0.7, timer.cancel), (1.8, timer.reset), (2.5, timer.reset), (2.8, timer.reset)):
            threading.Timer(when, do).start()

    assert times(spun(prepare, 4), "callback") == [0.5, 2.3, 3.3, 3.8]


def test_a_new_period_counts_from_the_call_that_is_due() -> None:
    def prepare(node: Any) -> None:
        timer = node.create_timer(0.5, works())

        def change() -> None:
            timer.timer_period_ns = 200_000_000

        threading.Timer(1.1, change).start()

    assert times(spun(prepare, 2), "callback") == [0.5, 1.0, 1.5, 1.7, 1.9]


@pytest.mark.parametrize("period", [0, 1e-9])
def test_a_period_of_nothing_calls_as_often_as_a_real_machine_does(period: float) -> None:
    ticks = times(spun(lambda node: node.create_timer(period, works()), 0.1), "callback")
    assert 800 < len(ticks) < 1100


def test_a_loop_that_looks_at_a_coroutine_takes_a_little_time() -> None:
    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")
        future = rclpy.task.Future()

        async def callback() -> None:
            print(await future, round(time.time(), 2))
            rclpy.shutdown()

        node.create_timer(0.5, callback)
        threading.Timer(0.6, future.set_result, ["done"]).start()
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=10 - time.time())

    assert simulate(node, 5).console == "done 0.6\n"


def test_calls_without_a_pause_between_them_cost_nothing() -> None:
    run = spun(lambda node: node.create_timer(0.01, works(*[0.02] * 2000)), 30)
    assert len(run.ticks) == 1500
    assert run.ticks[-1].real == 29.99


def test_a_callback_that_asks_for_it_is_told_when_it_was_due() -> None:
    told = []

    def callback(info: Any) -> None:
        told.append((info.expected_call_time.nanoseconds, info.actual_call_time.nanoseconds))
        time.sleep(0.8)

    callback.__annotations__["info"] = rclpy.timer.TimerInfo
    spun(lambda node: node.create_timer(0.5, callback), 2.1)
    assert told == [(5 * 10**8, 5 * 10**8), (10**9, 13 * 10**8), (15 * 10**8, 21 * 10**8)]


@pytest.mark.parametrize(
    ("period", "error", "text"),
    [
        (-1, rclpy.exceptions.RCLError, "failed to create timer: timer period must be non-negative"),
        (float("nan"), ValueError, "cannot convert float NaN to integer"),
        (float("inf"), OverflowError, "cannot convert float infinity to integer"),
        (1e10, TypeError, "incompatible constructor arguments"),
    ],
)
def test_periods_that_no_timer_has(period: float, error: type[Exception], text: str) -> None:
    def prepare(node: Any) -> None:
        with pytest.raises(error, match=text):
            node.create_timer(period, print)

    spun(prepare, 0)


def test_a_destroyed_timer() -> None:
    def prepare(node: Any) -> None:
        timer = node.create_timer(0.5, works())
        assert (node.destroy_timer(timer), node.destroy_timer(timer), list(node.timers)) == (True, False, [])
        for do in (timer.cancel, timer.reset, timer.is_ready, timer.time_until_next_call):
            with pytest.raises(rclpy.exceptions.InvalidHandle, match="destruction was requested"):
                do()

    assert not spun(prepare, 2).ticks


# --- several, and executors -------------------------------------------------------------------------------------------


def two_timers(group: Callable[[], Any] | None) -> Spun:
    """The first one takes 0.8 s, and both have a period of 0.5 s."""

    def prepare(node: Any) -> None:
        def slow() -> None:
            time.sleep(0.8)

        def fast() -> None:
            pass

        shared = group() if group is rclpy.callback_groups.ReentrantCallbackGroup else None
        node.create_timer(0.5, slow, shared or (group() if group else None))
        node.create_timer(0.5, fast, shared or (group() if group else None))

    return prepare


def grid(step: float, end: float, first: float = 0.5) -> list[float]:
    return [round(first + step * count, 9) for count in range(int((end - first) / step + 1e-9) + 1)]


@pytest.mark.parametrize(
    ("executor", "group", "slow", "fast"),
    [
        ("Single", None, grid(0.8, 5), [1.3, 2.9, 4.5]),
        ("Multi", None, grid(0.8, 5), []),
        ("Multi", rclpy.callback_groups.MutuallyExclusiveCallbackGroup, grid(0.8, 5), grid(0.5, 5)),
        ("Multi", rclpy.callback_groups.ReentrantCallbackGroup, grid(0.5, 5), grid(0.5, 5)),
    ],
)
def test_what_a_slow_timer_does_to_its_neighbour(
    executor: str, group: Any, slow: list[float], fast: list[float]
) -> None:
    make = getattr(rclpy.executors, f"{executor}ThreadedExecutor")
    run = spun(two_timers(group), 5, make)
    assert (times(run, "slow"), times(run, "fast")) == (slow, fast)


def test_a_timeout_that_changes_starves_the_second_timer() -> None:
    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")
        two_timers(None)(node)
        while (now := node.get_clock().now().nanoseconds / NS) < 5:
            rclpy.spin_once(node, timeout_sec=5 - now)

    run = simulate(node, 10)
    assert (times(run, "slow"), times(run, "fast")) == (grid(0.8, 5), [])


def test_a_timer_whose_callback_overlaps_itself_needs_threads() -> None:
    def prepare(node: Any) -> None:
        group = rclpy.callback_groups.ReentrantCallbackGroup()
        node.create_timer(0.5, works(*[1.2] * 10), group)

    run = spun(prepare, 3, lambda: rclpy.executors.MultiThreadedExecutor(2))
    assert times(run, "callback")[:5] == [0.5, 1.0, 1.7, 2.2, 2.9]


def test_a_round_is_used_up_before_the_next_one() -> None:
    order = []

    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")
        for name in "ab":
            node.create_timer(0.5, lambda name=name: order.append(name))
        for _ in range(2):
            time.sleep(0.6)
            for _ in range(4):
                rclpy.spin_once(node, timeout_sec=0)
                order.append(".")

    simulate(node, 5)
    assert "".join(order) == "a.b...a.b..."


def test_looking_in_vain_takes_a_little_time() -> None:
    looks = 0

    def node() -> None:
        nonlocal looks
        rclpy.init()
        node = rclpy.create_node("node")
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0)
            looks += 1

    assert simulate(node, 0.001).status == 130
    assert 900 < looks < 2100


# --- Rate -------------------------------------------------------------------------------------------------------------


def rate_in_a_thread(*lengths: float) -> Spun:
    def prepare(node: Any) -> None:
        rate = node.create_rate(2)

        def loop() -> None:
            for length in (*lengths, *[0.0] * 20):
                time.sleep(length)
                rate.sleep()

        threading.Thread(target=loop, daemon=True).start()

    return prepare


@pytest.mark.parametrize(
    ("length", "passes"),
    [
        (0.7, [0, 0.5, 1.0, 1.7, 2.0, 2.5]),
        (1.2, [0, 0.5, 1.0, 2.2, 2.5, 3.0]),
        (2.2, [0, 0.5, 1.0, 3.2, 3.5, 4.0]),
    ],
)
def test_a_rate_makes_up_for_one_pass_and_keeps_its_grid(length: float, passes: list[float]) -> None:
    run = spun(rate_in_a_thread(0, 0, length), passes[-1] + 0.6)
    assert times(run, "Rate")[: len(passes)] == passes
    assert [tick.number for tick in run.ticks] == list(range(1, len(run.ticks) + 1))


def test_a_late_pass_says_since_when_it_was_due() -> None:
    run = spun(rate_in_a_thread(0, 0, 1.2), 3.1)
    assert [tick.expected for tick in run.ticks] == [0, 0.5, 1.0, 1.5, 2.5, 3.0]


@pytest.mark.parametrize(
    "keeps, advice", [(True, "rosspin: Spin the node meanwhile"), (False, "rosspin: Keep the node in a variable")]
)
def test_a_rate_that_nobody_spins_hangs_until_ctrl_c(keeps: bool, advice: str) -> None:
    def node() -> None:
        rclpy.init()
        made = rclpy.create_node("node")
        rate = made.create_rate(2)
        if not keeps:
            del made
        try:
            rate.sleep()
        except KeyboardInterrupt:
            print("hung", time.time())

    *why, hung = simulate(node, 3).console.splitlines()
    assert why[1] == "rosspin:   the thread MainThread waits for its Rate"
    assert why[-1].startswith(advice)
    assert hung == "hung 3.0"


def test_the_second_sleep_in_a_callback_hangs_under_one_thread() -> None:
    def callbacks(make: Any, console: str = "") -> int:
        passes = []

        def prepare(node: Any) -> None:
            rate = node.create_rate(4)

            def callback() -> None:
                for _ in range(2):
                    rate.sleep()
                    passes.append(time.time())

            node.create_timer(1.0, callback)

        spun(prepare, 2.9, make, console=console)
        return len(passes)

    assert callbacks(rclpy.executors.SingleThreadedExecutor, "rosspin: deadlock. This can never continue:") == 1
    assert callbacks(rclpy.executors.MultiThreadedExecutor) > 2


def test_shutdown_and_destruction_wake_a_rate() -> None:
    ends: list[tuple[str, str, float]] = []

    def node() -> None:
        rate: Any
        rclpy.init()
        node = rclpy.create_node("node")
        threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
        for do, delay in ((lambda: node.destroy_rate(rate), 0.3), (rclpy.shutdown, 0.7)):
            rate = node.create_rate(2)
            threading.Timer(delay, do).start()
            try:
                while True:
                    rate.sleep()
            except Exception as error:
                ends.append((type(error).__name__, str(error), round(time.time(), 3)))

    assert simulate(node, 5).status == 0
    assert ends == [
        ("RuntimeError", "Rate cannot sleep because it has been destroyed", 0.3),
        ("ROSInterruptException", "rclpy.shutdown() has been called", 1.0),
    ]


@pytest.mark.parametrize("sleeps", ["rate.sleep()", "time.sleep(0.5)"])
def test_a_node_that_a_thread_keeps_is_told_why(write: Any, sleeps: str) -> None:
    """Real nodes are kept in the same way: a Rate's thread never wakes, another that does not ask continues."""
    path = write(
        f"""
        import threading, time
        import rclpy

        rclpy.init()
        node = rclpy.create_node("node")
        rate = node.create_rate(2)

        def loop():
            while True:
                {sleeps}

        threading.Thread(target=loop, name="loop").start()
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            pass
        """
    )
    first, *others = simulate(path, 1.2).console.splitlines()
    why = (
        "After Ctrl-C nothing wakes a Rate any more" if sleeps == "rate.sleep()" else "Does its loop check rclpy.ok()?"
    )
    assert first.startswith(f"rosspin: Ctrl-C at 1.2 s did not end the node; it was killed 17 s later. {why}")
    assert others == [
        "rosspin: MainThread had done its work and waited for other threads",
        f"rosspin: loop was at {path}:11: {sleeps}",
    ]


def test_frequencies_that_no_rate_has() -> None:
    def prepare(node: Any) -> None:
        for frequency in (0, -1):
            with pytest.raises(ValueError, match="frequency must be > 0"):
                node.create_rate(frequency)

    spun(prepare, 0)


# --- clocks -----------------------------------------------------------------------------------------------------------


def test_clocks_sleep_exactly() -> None:
    def prepare(node: Any) -> None:
        Duration, ClockType = rclpy.duration.Duration, rclpy.clock.ClockType
        for clock in (node.get_clock(), rclpy.clock.Clock(), rclpy.clock.Clock(clock_type=ClockType.STEADY_TIME)):
            begin = clock.now()
            assert clock.sleep_for(Duration(seconds=0.3))
            assert (clock.now() - begin).nanoseconds == 300_000_000
            assert clock.sleep_until(begin)
        with pytest.raises(ValueError, match="until's clock type does not match this clock's type"):
            node.get_clock().sleep_until(rclpy.clock.Clock().now())

    spun(prepare, 5)


def test_a_signal_does_not_wake_a_sleeping_clock_and_shutdown_does() -> None:
    def node() -> None:
        rclpy.init()
        clock = rclpy.create_node("node").get_clock()
        try:
            clock.sleep_for(rclpy.duration.Duration(seconds=3))
        except KeyboardInterrupt:
            print("interrupted", time.time())
        rclpy.try_shutdown()
        rclpy.init()
        threading.Timer(0.5, rclpy.shutdown).start()
        print(clock.sleep_for(rclpy.duration.Duration(seconds=3)), time.time())

    assert simulate(node, 1).console == "interrupted 3.0\nFalse 3.5\n"


def test_time_that_is_told_jumps() -> None:
    """Forward: one tick, then the grid. Back: the next tick is one period later."""
    ticked: list[tuple[float, int]] = []

    def node() -> None:
        rclpy.init()
        clock = rclpy.clock.ROSClock()
        clock._set_ros_time_is_active(True)
        node = rclpy.create_node("node")
        node.create_timer(1.0, lambda: ticked.append((now, clock.now().nanoseconds // NS)), clock=clock)
        for now in (100, 100.5, 101, 107.5, 108, 50, 50.5, 51):
            clock.set_ros_time_override(rclpy.time.Time(seconds=now))
            for _ in range(4):
                rclpy.spin_once(node, timeout_sec=0.01)

    simulate(node, 5)
    assert [now for now, _ in ticked] == [100, 101, 107.5, 108, 51]


def test_fractions_of_a_nanosecond_are_cut_off() -> None:
    """4.1 * 10**9 is a little less than 4100000000."""
    assert rclpy.duration.Duration(seconds=4.1).nanoseconds == 4_099_999_999
    assert rclpy.duration.Duration(seconds=-4.1).nanoseconds == -4_099_999_999
    assert rclpy.time.Time(seconds=4.1).nanoseconds == 4_099_999_999


def test_a_timer_that_was_cancelled_in_the_same_round_is_not_called() -> None:
    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")
        made: list[Any] = []
        made.append(node.create_timer(0.5, lambda: (print("first"), made[1].cancel())))
        made.append(node.create_timer(0.5, lambda: print("second")))
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            pass

    run = simulate(node, 1.2)
    assert (run.status, run.console) == (0, "first\nfirst\n")
