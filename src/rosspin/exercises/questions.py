"""The exercises on ROS 1, ``notebooks/exercises.md``: what each needs and reveals, and how its answer is judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import count, pairwise
from typing import Any

from ..results.roscpp import timer_ticks
from ..run.simulate import simulate
from .exercise import Exercises
from .feedback import Finding
from .judging import CLOSE, Answer, grid, on_time, plain, say
from .predictions import Beliefs, Prediction, as_number, as_whole, choose, compare, same
from .seen import Printed, Seen

__all__ = ["EXERCISES"]

_TIMER = "notebooks/timer"
_RATE = "notebooks/rate"
_SLOW = "notebooks/slow-callback"
_DRIFT = "notebooks/drift"
_TIMING = "docs/how-timing-works"
_TUTORIAL = "docs/tutorial"
_PARAMETER = "docs/how-to/frequency-from-parameter"
_SHARED = "docs/how-to/shared-data"
_TIMER_OR_RATE = "docs/how-to/timer-or-rate"
_PUBLISH = "docs/publish"
_PUBLISHING = "notebooks/publish"
_IRREGULAR = "docs/how-to/irregular-loop"


EXERCISES = Exercises(ros=1, first=1)
"""The exercises of the page, in their order."""

_exercise = EXERCISES.add


# --- predict ----------------------------------------------------------------------------------------------------------


@cache
def simulated(node: Callable[[], None], first: int = 1) -> tuple[float, ...]:
    """When ticks ``first`` and the two after it come, in simulated time (s)."""
    return tuple(tick.real for tick in simulate(node, 6.0).ticks[first - 1 : first + 2])


@cache
def _timer_node(period: float, blocks_for: float = 0.0) -> Callable[[], None]:
    """A timer whose third callback blocks."""

    def node() -> None:
        import rospy  # type: ignore[import-not-found]

        rospy.init_node("spinner_py_node")
        counter = 0

        def callback(event: object) -> None:
            nonlocal counter
            counter += 1
            if counter == 3:
                rospy.sleep(blocks_for)

        rospy.Timer(rospy.Duration(period), callback)
        rospy.spin()

    return node


@cache
def _loop_node(frequency: float, work: float = 0.0) -> Callable[[], None]:
    """A loop whose passes take some time."""

    def node() -> None:
        import rospy

        rospy.init_node("spinner_py_node")
        rate = rospy.Rate(frequency)
        while not rospy.is_shutdown():
            rospy.sleep(work)
            rate.sleep()

    return node


_AT_ONCE = "A loop makes its first pass at once; `rate.sleep()` comes at the end of a pass."


@_exercise(
    "Predict",
    "The first ticks",
    (_TIMER, _RATE),
    "A timer calls back at once. A duration is a frequency. A rate sleeps for a whole period after the work.",
    "When does the first tick come: at the start, or one period later? How far apart are the ticks?",
)
def _first_ticks(answer: Answer) -> Iterator[Finding]:
    timer: Beliefs = {
        (0.0, 0.4, 0.8): "A timer waits for one period before its first call.",
        (2.5, 5.0, 7.5): "This takes 0.4 for a frequency. A timer is given its period, in seconds.",
        (0.0, 2.5, 5.0): "This takes 0.4 for a frequency. A timer is given its period, in seconds.",
    }
    loop: Beliefs = {
        (0.25, 0.5, 0.75): _AT_ONCE,
        (0.0, 4.0, 8.0): "This takes 4 for a period. A rate is given its frequency, in Hz.",
        (4.0, 8.0, 12.0): "This takes 4 for a period. A rate is given its frequency, in Hz.",
    }
    busy: Beliefs = {
        (0.25, 0.5, 0.75): _AT_ONCE,
        (0.0, 0.35, 0.7): "`rate.sleep()` sleeps until the next period begins: the work is a part of the period.",
        (0.1, 0.35, 0.6): "This is when the work ends. The counter is printed before it.",
        (0.1, 0.45, 0.8): "The counter is printed before the work, and the work is a part of the period.",
    }
    predictions = [
        Prediction("timer", "the timer", simulated(_timer_node(0.4)), timer),
        Prediction("loop", "the loop", simulated(_loop_node(4.0)), loop),
        Prediction("busy_loop", "the loop with 0.1 s of work", simulated(_loop_node(4.0, 0.1)), busy),
    ]
    yield from compare(answer, predictions)


_UNMOVED = "The slow callback keeps its timer busy until it returns: no other call of it can begin before."
_KEEPS_TO_THE_GRID = "This is what ROS 2 does: it leaves ticks out and keeps to the grid."


@_exercise(
    "Predict",
    "The ticks after a slow callback",
    (_SLOW, _TIMING),
    "A timer calls back on time, whatever its callback does. Ticks that are due meanwhile all wait in a queue.",
    "The callback ends at 1.2 s plus the time for which it blocks. Which ticks were due by then?",
)
def _after_a_slow_callback(answer: Answer) -> Iterator[Finding]:
    short: Beliefs = {
        (1.6, 2.0, 2.4): _UNMOVED,
        (2.2, 2.6, 3.0): "This is what roscpp does. rospy counts anew only after a longer delay.",
        (2.2, 2.4, 2.8): f"{_KEEPS_TO_THE_GRID} rospy makes up for short delays.",
    }
    long: Beliefs = {
        (1.6, 2.0, 2.4): _UNMOVED,
        (3.0, 3.0, 3.0): "This is what a queue of calls would give. There is none: ticks are lost here.",
        (3.0, 3.2, 3.6): f"{_KEEPS_TO_THE_GRID} rospy counts anew after a long delay.",
        (3.0, 3.0, 3.2): "Calls in a row follow a shorter delay. This one is too long to be made up for.",
        (3.0, 3.0, 3.4): "Calls in a row follow a shorter delay. This one is too long to be made up for.",
    }
    predictions = [
        Prediction("after_1_0_seconds", "blocked for 1.0 s", simulated(_timer_node(0.4, 1.0), 4), short),
        Prediction("after_1_8_seconds", "blocked for 1.8 s", simulated(_timer_node(0.4, 1.8), 4), long),
    ]
    yield from compare(answer, predictions)


def _roscpp(blocks_for: float) -> list[float]:
    """When calls 4, 5 and 6 come in roscpp if the third blocks (s)."""
    return [tick.real for tick in timer_ticks(0.4, lambda number: blocks_for * (number == 3), 6.0)[3:6]]


@_exercise(
    "Predict",
    "The ticks of a C++ node",
    (_TUTORIAL, _TIMING),
    "roscpp and rospy time their timers alike. A ros::Timer that nobody keeps goes on calling back.",
    "The callback ends at 1.2 s plus the time for which it blocks. Is the call after the next one due by then, too?",
)
def _ticks_in_cpp(answer: Answer) -> Iterator[Finding]:
    short: Beliefs = {
        (1.6, 2.0, 2.4): _UNMOVED,
        (1.8, 2.2, 2.6): "roscpp counts anew only if the call after the next one is overdue as well.",
    }
    long: Beliefs = {
        (1.6, 2.0, 2.4): _UNMOVED,
        (2.2, 2.2, 2.4): "This is what rospy does. roscpp never has more than one call of a timer waiting.",
        (2.2, 2.4, 2.8): f"{_KEEPS_TO_THE_GRID} roscpp counts anew.",
    }
    kept: Beliefs = {
        (0.4, 0.8, 1.2): "This is what rospy does. In C++ a timer ends with the last `ros::Timer` that stands for it.",
    }
    predictions = [
        Prediction("after_0_6_seconds", "blocked for 0.6 s", _roscpp(0.6), short),
        Prediction("after_1_0_seconds", "blocked for 1.0 s", _roscpp(1.0), long),
        Prediction("not_kept", "with a timer that nobody keeps", [], kept),
    ]
    yield from compare(answer, predictions)


# --- change -----------------------------------------------------------------------------------------------------------


@_exercise(
    "Change",
    "Change the rate",
    (_TIMER,),
    "A timer is given a frequency.",
    "A timer takes a period in seconds, not a frequency: the period is 1 / frequency.",
)
def _change_the_rate(answer: Answer) -> Iterator[Finding]:
    yield on_time(answer.run(1.0).counters(), grid(0.1, 1.0))


def stopped(seen: Seen, calls: int, timer: str = "a `rospy.Timer`") -> Iterator[Finding]:
    """Whether the timers that printed the counters have stopped, after so many calls; ``timer`` is what they are."""
    counters = seen.counters()
    if not counters:
        return
    timers, others = seen.printers(counters)
    if others:
        text = f"counter {plain(others[0].text)} was not printed by the callback of {timer}."
        yield Finding(False, text, "Let a timer call back, and stop it.")
        return
    states = {timer.state for timer in timers}
    count = sum(len(timer.calls) for timer in timers)
    if "gone" in states:
        hint = "`sys.exit()` in a callback ends the thread that the callback runs in. Ask the timer to stop instead."
        yield Finding(False, "the timer was not stopped: its thread was ended.", hint)
    elif "blocked" in states:
        text = "the timer was not stopped: a call of its callback had not returned in the end."
        yield Finding(False, text, "A callback that never returns keeps a thread for ever. Stop the timer and return.")
    elif count > calls:
        text = f"the callback was called {count} times in {say(seen.seconds)}, where {calls} would do."
        silent = "A callback that returns at once is still called. Stop the timer itself."
        yield Finding(False, text, silent if count > len(counters) else "")
    elif "running" in states:
        yield Finding(False, "the timer still runs.", "Stop the timer itself.")
    else:
        yield Finding(True, "the timer has stopped.")


@_exercise(
    "Change",
    "Fire once",
    (_TIMER,),
    "A timer stops when its callback does nothing any more.",
    "`rospy.Timer` has a parameter `oneshot`; its period is then the time until the only call.",
)
def _fire_once(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(5.0)
    yield on_time(seen.counters(), [1.5])
    yield from stopped(seen, 1)


@_exercise(
    "Change",
    "Stop after five ticks",
    (_TIMER,),
    "To stop a timer is to end its callback, its thread or the node.",
    "Keep the timer in `self.timer`, and call its `shutdown()` after counter 5.",
)
def _stop_after_five(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(6.0)
    yield on_time(seen.counters(), grid(0.5, 2.5))
    stops = "Stop one timer, and no more: `rospy.signal_shutdown()` ends the whole node."
    yield on_time(seen.counters("HEARTBEAT"), grid(1.0, 6.0), "The heartbeat", stops)
    yield from stopped(seen, 5)


@_exercise(
    "Change",
    "Turn a loop into a timer",
    (_TIMER, _RATE, _TIMER_OR_RATE),
    "A timer goes into the loop, or a loop into the callback.",
    "What stands in the loop goes into a callback, the loop goes, and `rospy.spin()` takes its place.",
)
def _loop_to_timer(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(3.0)
    counters = seen.counters()
    timers, others = seen.printers(counters)
    yield on_time(counters, grid(0.5, 3.0))
    if not seen.timers:
        yield Finding(False, "no timer calls back.")
    elif others:
        yield Finding(False, f"counter {plain(others[0].text)} was printed by a loop, not by a timer's callback.")
    elif len(timers) > 1:
        text = f"{len(timers)} timers printed the counters."
        yield Finding(False, text, "A timer that is not one-shot calls back again by itself: one is enough.")
    elif timers and len(timers[0].calls) < len(counters):
        text = "one call of the callback printed several counters: the loop is now in the callback."
        yield Finding(False, text, "A callback does one pass and returns. The timer calls it again.")
    elif seen.loops:
        text = f"there still is a loop, at line {seen.loops[0]}."
        yield Finding(False, text, "`rospy.spin()` waits for the node to be shut down; it needs no loop around it.")
    elif timers:
        yield Finding(True, "a timer calls back, and no loop is left.")


@_exercise(
    "Change",
    "Read the frequency from a parameter",
    (_TIMER, _PARAMETER),
    "A name without ~ is a private one. What is read as a frequency can be used as a period.",
    "`rospy.get_param(name, default)`; the name of a private parameter begins with `~`; the default is in Hz, too.",
)
def _frequency_from_a_parameter(answer: Answer) -> Iterator[Finding]:
    yield on_time(answer.run(2.0).counters(), grid(0.5, 2.0), "Without the parameter")
    private = "Does the name begin with `~`? Is it a frequency that you read, and a period that the timer is given?"
    for frequency, seconds in ((10, 1.0), (0.5, 4.0)):
        word = f"_frequency:={frequency}"
        counters = answer.run(seconds, word).counters()
        yield on_time(counters, grid(1 / frequency, seconds), f"With `{word}`", private)


@_exercise(
    "Change",
    "Run at two rates",
    (_TIMER, _TIMER_OR_RATE),
    "Two timers need two nodes. Two loops can follow each other.",
    "A node can have as many timers as it likes, each with its own period, callback and counter.",
)
def _two_rates(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(2.0)
    for tag, frequency in (("FAST", 10), ("SLOW", 2)):
        counters = seen.counters(tag)
        wanted = grid(1 / frequency, 2.0)
        shared = same([line.time for line in counters], wanted)
        yield on_time(counters, wanted, f"`[{tag}]`", "Give each timer a counter of its own." if shared else "")


@_exercise(
    "Change",
    "Survive an overrun",
    (_RATE, _DRIFT),
    "A pass that was lost has to be made up for. After an overrun one may count on from now.",
    "Before the loop sleeps, move the deadline on by whole periods until it lies ahead.",
)
def _survive_an_overrun(answer: Answer) -> Iterator[Finding]:
    for work in (0.7, 1.7, 0.1):
        word = f"_work:={work}"
        back = math.ceil((1.0 + work) / 0.5) * 0.5
        wanted = [0.0, 0.5, 1.0, *grid(0.5, 5.0, start=back)]
        counters = answer.run(5.0, word).counters()
        hint = ""
        if any(after.time - line.time < 0.5 - CLOSE for line, after in pairwise(counters[2:])):
            hint = "A lost pass is not to be made up for: two passes in a row would send two commands at once."
        if counters and abs(counters[-1].time / 0.5 - round(counters[-1].time / 0.5)) > CLOSE:
            hint = "The loop has left its grid of 0.5 s: count deadlines on from the old one, not from now."
        yield on_time(counters, wanted, f"With `{word}`", hint)


_LOCK = "While one callback reads the parts and writes them, the other has to keep away: both need one lock."


@_exercise(
    "Change",
    "Share data between two callbacks",
    (_TIMER, _SHARED),
    "Callbacks of one node never run at the same time. A single line of Python cannot be interrupted.",
    _LOCK,
)
def _share_data(answer: Answer) -> Iterator[Finding]:
    alone = _count_parts(answer.run(5.2))
    yield alone
    if not alone.right:
        return
    turns = "when the threads take turns at every line"
    for seed in range(5):
        right, text, hint = _count_parts(answer.run(5.2, seed=seed))
        if not right:
            yield Finding(False, f"{turns}: {text}", hint)
            return
    yield Finding(True, f"the reports are right as well {turns}.")
    yield _count_calls(answer.run(5.2, stalls_at=1.22))


def _count_parts(seen: Seen) -> Finding:
    """Whether reports every 0.5 s add up to the parts, one every 0.1 s: the newest may miss the report."""
    reports = seen.values("SPINNER PY NODE", "parts")
    stuck = "Does a callback wait for a lock that nobody releases, or that it has already?"
    total = 0
    for number in range(1, 11):
        due = 0.5 * number
        if len(reports) < number or reports[number - 1].time > due + 0.1:
            return Finding(False, f"the report due at {say(due)} did not come.", stuck)
        time, text, _ = reports[number - 1]
        reported = as_whole(text)
        if reported is None:
            return Finding(False, f"`parts = {plain(text)}` is no number of parts.")
        total += reported
        passed = 5 * number
        if total not in (passed - 1, passed):
            wrong = "some are reported twice" if total > passed else "some are lost"
            sums = f"the reports up to {say(time)} add up to {total}, but {passed} parts have passed"
            return Finding(False, f"{sums}: {wrong}.", _LOCK)
    if len(reports) > 10:
        return Finding(False, f"a report came at {say(reports[10].time)}; it should not have come.")
    return Finding(True, "10 reports came, and they add up to the parts that have passed.")


def _count_calls(seen: Seen) -> Finding:
    """Whether the reports of a node that was held up, and has lost ticks, add up to the calls that it had.

    The callback that counts is the one that is called most often. Its newest call may miss the report.
    """
    busy = "when the computer is busy for a while"
    calls = max((timer.calls for timer in seen.timers), key=len, default=())
    begun = {timer.number: timer.calls for timer in seen.timers}
    total = 0
    for time, text, timer in seen.values("SPINNER PY NODE", "parts"):
        total += as_whole(text) or 0
        began = max((call for call in begun.get(timer, ()) if call <= time), default=time)
        least = sum(call < began - CLOSE for call in calls) - 1
        most = sum(call <= time for call in calls)
        if not least <= total <= most:
            text = f"{busy}: the reports up to {say(time)} add up to {total}, but the parts were counted {most} times."
            return Finding(False, text, "Report what the callback has counted: a tick that is lost counts no part.")
    return Finding(True, f"the reports are right as well {busy}.")


@_exercise(
    "Change",
    "Stop the motor",
    (_RATE, _TUTORIAL),
    "After a shutdown hook nothing else of the node runs. A node ends by Ctrl-C only.",
    "`rospy.on_shutdown(function)`: the function is called when the node is shut down, in whatever way.",
)
def _stop_the_motor(answer: Answer) -> Iterator[Finding]:
    for seconds, where in ((2.08, "while the loop sleeps"), (2.03, "while the sensor is read")):
        seen = answer.run(seconds)
        yield check_motor(seen, seconds, f"Ctrl-C {where}", _ASKS, _CAUGHT)
    seen = answer.run(5.0, "_fails_at:=1.0", allowed="no sensor")
    yield check_motor(seen, 1.06, "The sensor fails", _ASKS, _CAUGHT)


_ASKS = (
    "A hook runs in the middle of a pass, which then goes on. Ask `rospy.is_shutdown()` before you drive, or stop the "
    "motor after the loop, in a `finally`."
)
_CAUGHT = "An exception that is caught, or that ends a timer alone, does not end the node: no hook is called."


def check_motor(seen: Seen, end: float, what: str, again: str, late: str) -> Finding:
    """Whether the motor is driven until the time ``end`` (s), and stands from then on.

    ``again`` is a hint for those who then drive it again, ``late`` for those who do not stop it at once.
    """
    printed = [(line.time, as_number(line.text)) for line in seen.values("MOTOR", "speed")]
    commands = [(time, speed) for time, speed in printed if speed is not None]
    driven = [time for time, speed in commands if speed and time < end]
    paused = [time for time, speed in commands if not speed and time < end - CLOSE]
    stop = next((n for n, (time, speed) in enumerate(commands) if not speed and time >= end - CLOSE), None)
    due = int(end / 0.1)
    if paused or abs(len(driven) - due) > 1:
        told = f"stopped at {say(paused[0])}" if paused else f"told a speed {len(driven)} times, not about {due} times"
        hint = "Until the node ends, the loop has to drive the motor as before."
        return Finding(False, f"{what}: up to then the motor was {told}.", hint)
    if stop is None:
        return Finding(False, f"{what}: nobody stops the motor. It goes on at its last speed.")
    time = commands[stop][0]
    if later := [time for time, speed in commands[stop:] if speed]:
        text = f"{what}: the motor was stopped at {say(time)}, and driven again at {say(later[0])}."
        return Finding(False, text, again)
    if time > end + 0.5:
        text = f"{what} at {say(end)}: the motor was not stopped before {say(time)}."
        return Finding(False, text, late)
    return Finding(True, f"{what}: the motor was stopped at {say(time)}.")


# --- diagnose ---------------------------------------------------------------------------------------------------------


@_exercise(
    "Diagnose",
    "Count the ticks that are missing",
    (_SLOW, _TIMING),
    "A late tick is a missing one. What a timer event says is the same in rospy and roscpp.",
    "`event.current_real - event.current_expected` is how late this call is. How many whole periods is that?",
)
def _count_missing(answer: Answer) -> Iterator[Finding]:
    for blocks_for in (1.8, 1.0, 0.7):
        word = f"_blocks_for:={blocks_for}"
        found = [line for line in answer.run(5.0, word).values("[^]]*", "missing") if line.time <= 5.0]
        yield _compare_missing(f"With `{word}`", found, _missing(blocks_for))


@cache
def _missing(blocks_for: float) -> tuple[int, ...]:
    """How many ticks of a timer whose third callback blocks are missing at each call, up to 5 s."""
    return tuple(int(tick.lateness / 0.4 + 1e-6) for tick in simulate(_timer_node(0.4, blocks_for), 5.0).ticks)


def _compare_missing(what: str, found: Sequence[Printed], wanted: Sequence[int]) -> Finding:
    if not found:
        return Finding(False, f"{what}: no line with `missing = ` was printed.")
    if len(found) != len(wanted):
        return Finding(False, f"{what}: {len(wanted)} callbacks printed {len(found)} lines with `missing = `.")
    for number, (line, missing) in enumerate(zip(found, wanted, strict=True), 1):
        said = as_number(line.text)
        if said != missing:
            whole = said is not None and said == int(said)
            hint = "" if whole else "A tick is missing or not: the number is a whole one."
            text = f"{what}: callback {number} printed `missing = {plain(line.text)}`, but {missing} were missing."
            return Finding(False, text, hint)
    return Finding(True, f"{what}: the callbacks printed {', '.join(line.text for line in found)}.")


# The faults to choose from, and what a console would show of each.
FAULTS = {
    "A": "Then the ticks would come at a steady 2 s, or 0.5 Hz: 1 divided by what was asked for, and never late.",
    "B": "A loop makes its first pass at once; then each pass takes the work and the sleep together.",
    "C": "After one slow call the ticks are a period apart again.",
    "D": "A timer makes its first call after one period; from then on each call begins when the last one ends.",
    "E": "Then a traceback would name a thread, one counter would end there, and whatever else there is would go on.",
    "F": "Then a traceback would be the last thing on the console: nothing of the node goes on.",
    "G": "Then each number would be printed once, by one tag or by the other.",
}

# Which of them each console shows.
_LOGS = {"log_1": "B", "log_2": "E", "log_3": "D", "log_4": "C"}


@_exercise(
    "Diagnose",
    "Name the fault",
    (_RATE, _SLOW, _DRIFT),
    "A loop that is slow and a timer that is slow look alike. A traceback means that the node has ended.",
    "Look at the first tick, at the distances between the ticks, and at what goes on to the end.",
)
def _name_the_fault(answer: Answer) -> Iterator[Finding]:
    yield from choose(answer, _LOGS, FAULTS)


# --- publish ----------------------------------------------------------------------------------------------------------


@cache
def _heard(latch: bool = False, timer: bool = True, together: int = 1) -> tuple[float, ...]:
    """The first counters that a node hears from itself: it publishes some at once, and then one every 0.5 s."""
    heard: list[float] = []

    def node() -> None:
        import rospy
        from std_msgs.msg import UInt32

        rospy.init_node("pubsub_py_node")
        counts = count(1)
        publisher = rospy.Publisher("counter", UInt32, latch=latch, queue_size=10)
        rospy.Subscriber("counter", UInt32, lambda message: heard.append(message.data))
        for _ in range(together):
            publisher.publish(next(counts))
        if timer:
            rospy.Timer(rospy.Duration(0.5), lambda event: publisher.publish(next(counts)))
        rospy.spin()

    simulate(node, 3.0)
    return tuple(heard[:3])


@cache
def _heard_by_a_slow_callback(queue_size: int) -> tuple[float, ...]:
    """The first counters of those published each 0.1 s, 0 first, that a callback hears that takes 0.33 s."""
    heard: list[float] = []

    def node() -> None:
        import rospy
        from std_msgs.msg import UInt32

        def callback(message: Any) -> None:
            heard.append(message.data)
            rospy.sleep(0.33)

        rospy.init_node("pubsub_py_node")
        counts = count()
        publisher = rospy.Publisher("counter", UInt32, queue_size=10)
        rospy.Subscriber("counter", UInt32, callback, queue_size=queue_size)
        rospy.sleep(0.5)
        rospy.Timer(rospy.Duration(0.1), lambda event: publisher.publish(next(counts)))
        rospy.spin()

    simulate(node, 3.0)
    return tuple(heard[:3])


@_exercise(
    "Publish",
    "What the subscriber hears",
    (_PUBLISH, _PUBLISHING),
    "What is published waits until somebody subscribes. A latch keeps everything. A queue of 1 makes a callback wait "
    "for the next message.",
    "Is the connection there when the message is published? Which message is the newest one when the callback is free?",
)
def _what_is_heard(answer: Answer) -> Iterator[Finding]:
    plain_: Beliefs = {
        (1, 2, 3): "When 1 is published, the subscriber is not connected yet: nobody keeps it for later.",
    }
    latched: Beliefs = {
        (2, 3, 4): "A publisher that latches keeps its last message for whoever connects later.",
    }
    together: Beliefs = {
        (1, 2, 3): "A publisher that latches keeps one message only, the last.",
        (1,): "It is the last message that is kept, not the first.",
        (): "A publisher that latches keeps its last message for whoever connects later.",
    }
    slow: Beliefs = {
        (0, 1, 2): "This is what happens without a `queue_size`. With 1, all but the newest are dropped.",
        (0, 4, 8): "The callback does not wait for the next message: the newest one is there already.",
        (0, 1, 4): "The message that waits is replaced by each newer one.",
    }
    predictions = [
        Prediction("without_latch", "without `latch`", _heard(), plain_, "counters"),
        Prediction("with_latch", "with `latch`", _heard(latch=True), latched, "counters"),
        Prediction("three_at_once", "three at once", _heard(True, False, 3), together, "counters"),
        Prediction("slow_callback", "the slow callback", _heard_by_a_slow_callback(1), slow, "counters"),
    ]
    yield from compare(answer, predictions)


_NOT_CONNECTED = "A publisher that was made just now is not connected to anyone. Make it once, before the timer."


@_exercise(
    "Publish",
    "Publish the counter",
    (_PUBLISH,),
    "A publisher can be made when it is needed. A topic is found by its type.",
    'Make a `rospy.Publisher("counter", UInt32, queue_size=10)` in `__init__`, and let the callback publish.',
)
def _publish_the_counter(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(2.0)
    wanted = grid(0.2, 2.0)
    sent = [message for message in seen.sent if message.topic == "/counter"]
    heard = seen.values("LISTENER", "counter")
    if not sent:
        others = dict.fromkeys(f"`{plain(message.topic)}`" for message in seen.sent)
        text = f"it was published on {', '.join(others)}" if others else "the node published nothing"
        yield Finding(False, f"nothing was published on `/counter`: {text}.")
        return
    if wrong := {message.type for message in sent} - {"std_msgs/UInt32"}:
        text = f"the messages on `/counter` are of the type {plain(', '.join(sorted(wrong)))}, not std_msgs/UInt32."
        yield Finding(False, text, "Both ends of a topic have to name the same type: otherwise they do not connect.")
        return
    published = [Printed(message.time, message.data) for message in sent]
    on_topic = on_time(published, wanted, "On `/counter`")
    yield on_topic
    yield on_time(heard, wanted, "The listener", _NOT_CONNECTED if on_topic.right else "")


@_exercise(
    "Publish",
    "Reach a subscriber that comes late",
    (_PUBLISH, _PUBLISHING),
    "What is published waits for its subscribers. A longer queue keeps it for them.",
    "`rospy.Publisher` has a parameter `latch`.",
)
def _reach_a_late_subscriber(answer: Answer) -> Iterator[Finding]:
    for comes in (1.0, 2.5):
        word = f"_subscribes_at:={comes}"
        heard = answer.run(4.0, word).values("LISTENER", "goal")
        what = f"With `{word}`"
        if not heard:
            yield Finding(False, f"{what}: the goal did not arrive.")
        elif wrong := [line.text for line in heard if line.text != "7"]:
            yield Finding(False, f"{what}: the goal {plain(wrong[0])} arrived, not 7.")
        elif len(heard) > 1:
            text = f"{what}: the goal arrived {len(heard)} times; a robot would start anew each time."
            yield Finding(False, text, "Publish once, and let the publisher keep the message.")
        elif not comes <= heard[0].time <= comes + 0.5:
            yield Finding(False, f"{what}: the goal arrived only at {say(heard[0].time)}.")
        else:
            yield Finding(True, f"{what}: the goal arrived once, at {say(heard[0].time)}.")


@_exercise(
    "Publish",
    "Steer by the newest position",
    (_PUBLISH, _PUBLISHING, _SHARED),
    "A subscriber always gets the newest message. It is the publisher's queue that has to be short.",
    "The subscriber has a queue, too: `queue_size` says how many messages may wait there.",
)
def _steer_by_the_newest(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(10.0)
    sent = {as_whole(message.data): message.time for message in seen.sent if message.topic == "/position"}
    steps = [line for line in seen.values("CONTROLLER", "position") if line.time <= seen.seconds]
    if len(sent) < 99:
        text = f"the sensor published {len(sent)} positions in {say(seen.seconds)}, not one every 0.1 s."
        yield Finding(False, text, "The sensor is as it is: change how the controller listens to it.")
        return
    if len(steps) < 20:
        yield Finding(
            False, f"the controller steered {len(steps)} times in {say(seen.seconds)}; it can do so 20 times."
        )
        return
    if short := [after for line, after in pairwise(steps) if after.time - line.time < 0.33 - CLOSE]:
        text = f"the controller steered again at {say(short[0].time)}, less than 0.33 s after the last time."
        yield Finding(False, text, "Its computation takes 0.33 s, and nothing else can be done about that.")
        return
    for time, text, _ in steps:
        number = as_whole(text)
        made = None if number is None else sent.get(number)
        if made is None:
            yield Finding(False, f"`position = {plain(text)}` is no position that the sensor has published.")
            return
        if time - made > 0.1 + CLOSE:
            said = f"at {say(time)} the controller steered by position {text}, which was {say(time - made)} old."
            yield Finding(False, f"{said} A newer one had arrived.")
            return
    yield Finding(True, f"the controller steered {len(steps)} times, by the newest position each time.")


# What each report could be explained by, and what rostopic would show of it.
CAUSES = {
    "A": "Then the average would be as asked for, and `min` and `max` equal to the period.",
    "B": "Then there would be twice as many messages as asked for.",
    "C": "Then the average would have been right at first, and `max` would be the period that it has now.",
    "D": "Then the average would be right, `min` 0 and `max` many periods.",
    "E": "Then the average would be too low from the start, and `min` and `max` nearly equal.",
}

# Which of them each report shows.
_REPORTS = {"report_1": "C", "report_2": "D", "report_3": "E", "report_4": "B"}


@_exercise(
    "Publish",
    "Read rostopic hz",
    (_PUBLISH, _PUBLISHING, _IRREGULAR),
    "rostopic hz says what the rate is now. If the average is right, the loop is regular.",
    "Compare the average with what was asked for, `min` with `max`, and the first report with the second.",
)
def _read_rostopic_hz(answer: Answer) -> Iterator[Finding]:
    yield from choose(answer, _REPORTS, CAUSES)
