"""The exercises on ROS 2, ``notebooks/ros2-exercises.md``, which go on where those on ROS 1 end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from itertools import pairwise

from . import questions
from .exercise import Exercises
from .feedback import Finding
from .judging import CLOSE, Answer, grid, on_time, plain, say
from .predictions import Beliefs, Prediction, compare
from .questions import check_motor, simulated, stopped
from .seen import Seen

__all__ = ["EXERCISES"]

_TUTORIAL = "docs/ros2/tutorial"
_TIMING = "docs/ros2/how-timing-works"
_FROM_ROS_1 = "docs/ros2/from-ros-1"
_TIMER = "notebooks/ros2-timer"
_RATE = "notebooks/ros2-rate"
_EXECUTORS = "notebooks/ros2-executors"
_PARAMETER = "docs/how-to/frequency-from-parameter"

EXERCISES = Exercises(ros=2, first=len(questions.EXERCISES) + 1)
"""The exercises of the page, in their order."""

_exercise = EXERCISES.add


# --- predict ----------------------------------------------------------------------------------------------------------


@cache
def _node(blocks_for: float, always: bool = False, spins: bool = True) -> Callable[[], None]:
    """A timer of 0.4 s whose third callback blocks (s), or each."""

    def node() -> None:
        import time

        import rclpy  # type: ignore[import-not-found]

        counter = 0

        def callback() -> None:
            nonlocal counter
            counter += 1
            if counter == 3 or always:
                time.sleep(blocks_for)

        rclpy.init()
        node = rclpy.create_node("spinner_py_node")
        node.create_timer(0.4, callback)
        if spins:
            rclpy.spin(node)
        while rclpy.ok():
            time.sleep(0.1)

    return node


_BUSY = "While the callback runs, the executor calls nothing: no other call can begin before it returns."
_ROSPY = "This is what rospy does. In ROS 2 a timer always keeps to its grid, however late it was."


@_exercise(
    "Predict",
    "When a slow timer ticks again",
    (_TIMER, _TIMING),
    "ROS 2 makes up for ticks that were lost, or counts anew. A timer calls back by itself, whether anybody spins or "
    "not.",
    "When does the callback return? Which tick is overdue then, and which is the next place of the grid 0.4, 0.8, 1.2?",
)
def _after_a_slow_callback(answer: Answer) -> Iterator[Finding]:
    short: Beliefs = {
        (1.6, 2.0, 2.4): _BUSY,
        (2.2, 2.2, 2.4): _ROSPY,
        (2.2, 2.6, 3.0): "This is what roscpp does: it counts anew. In ROS 2 a timer goes back to its grid.",
        (2.4, 2.8, 3.2): "One tick is overdue when the callback returns, and it comes at once.",
    }
    long: Beliefs = {
        (1.6, 2.0, 2.4): _BUSY,
        (3.0, 3.4, 3.8): _ROSPY,
        (3.0, 3.0, 3.0): "There is no queue of calls. However many ticks are overdue, one of them comes.",
        (3.2, 3.6, 4.0): "One overdue tick still comes, as soon as the callback returns.",
    }
    always: Beliefs = {
        (0.4, 0.8, 1.2): _BUSY,
        (
            0.4,
            1.2,
            2.0,
        ): "When the callback returns, a tick is overdue, and it does not wait any longer.",
        (0.4, 1.4, 2.4): "The timer does not count from the end of a callback.",
    }
    unspun: Beliefs = {
        (0.4, 0.8, 1.2): "This is what rospy does, where each timer has a thread. In ROS 2 only spin calls callbacks.",
    }
    predictions = [
        Prediction("after_1_0_seconds", "blocked for 1.0 s", simulated(_node(1.0), 4), short),
        Prediction("after_1_8_seconds", "blocked for 1.8 s", simulated(_node(1.8), 4), long),
        Prediction("always_slow", "each callback takes 0.6 s", simulated(_node(0.6, always=True)), always),
        Prediction("without_spin", "without spin", simulated(_node(0.0, spins=False)), unspun),
    ]
    yield from compare(answer, predictions)


# --- change -----------------------------------------------------------------------------------------------------------


@_exercise(
    "Change",
    "Call back once",
    (_TIMER,),
    "A timer stops when its callback returns early. `rclpy.shutdown()` stops a timer.",
    "Keep the timer in `self.timer`, and call its `cancel()` in the callback.",
)
def _call_back_once(answer: Answer) -> Iterator[Finding]:
    seen = answer.run(6.0)
    yield on_time(seen.counters(), [1.5])
    stops = "Stop one timer, and no more: what ends the node, or keeps its callback from returning, stops them all."
    yield on_time(seen.counters("HEARTBEAT"), grid(1.0, 6.0), "The heartbeat", stops)
    yield from stopped(seen, 1, "a timer of the node")


def _with(name: str, value: float) -> tuple[str, ...]:
    """The command line that gives a parameter a value."""
    return ("--ros-args", "-p", f"{name}:={value}")


@_exercise(
    "Change",
    "Take the period from a parameter",
    (_TUTORIAL, _TIMER, _PARAMETER),
    "A parameter can be read without being declared. A timer refuses a period of 0.",
    "`self.declare_parameter(name, default).value` is a parameter's value. Look at it before you make the timer.",
)
def _period_from_a_parameter(answer: Answer) -> Iterator[Finding]:
    yield on_time(answer.run(2.0).counters(), grid(0.5, 2.0), "Without the parameter")
    declared = 'The parameter is called "period". Is it what the timer is given, in seconds?'
    for period, seconds in ((0.1, 1.0), (2.0, 5.0)):
        counters = answer.run(seconds, *_with("period", period)).counters()
        finding = on_time(counters, grid(period, seconds), f"With `period:={period}`", declared)
        yield finding
        if not finding.right:
            return
    for period in (0.0, -1.0):
        yield _refusal(answer, answer.ending(1.0, *_with("period", period)), f"With `period:={period}`")


def _refusal(answer: Answer, seen: Seen, what: str) -> Finding:
    """Whether a node has refused its parameter: in words, with a status other than 0, without a traceback."""
    look = "Look at the period before you make the timer: write an error line, and end with `sys.exit(1)`."
    if counters := seen.counters():
        text = f"{what}: the node ticked all the same, {len(counters)} times in {say(seen.seconds)}."
        return Finding(False, text, f"A timer takes a period of 0, and then calls back without a pause. {look}")
    if seen.errors:
        return Finding(False, f"{what}: the {answer.say_error(seen.errors[-1])}", look)
    if seen.interrupted:
        return Finding(False, f"{what}: the node neither ticked nor ended.", look)
    if not seen.status:
        ends = "What started the node learns from its status whether all is well: end it with `sys.exit(1)`."
        return Finding(False, f"{what}: the node ended with status 0, as if all were well.", ends)
    said = [line.text.strip() for line in seen.printed if "period" in line.text.lower()]
    if not said:
        return Finding(False, f"{what}: no line says that it is the period that is wrong.", look)
    return Finding(True, f"{what}: the node said `{plain(said[0])}`, and ended with status {seen.status}.")


@_exercise(
    "Change",
    "Move a node to ROS 2",
    (_TUTORIAL, _FROM_ROS_1),
    "To move a node is to rename what it imports. A timer passes its callback an event in ROS 2, too.",
    "A class of `Node` makes the timer: `self.create_timer(period, callback)`. `rclpy.init()` comes first, "
    "`rclpy.spin(node)` last.",
)
def _move_a_node(answer: Answer) -> Iterator[Finding]:
    yield on_time(answer.run(2.0).counters(), grid(0.5, 2.0), "Without the parameter")
    declared = 'The parameter is called "frequency", without `~`, and is declared before it is read.'
    for frequency, seconds in ((10.0, 1.0), (0.8, 4.0)):
        counters = answer.run(seconds, *_with("frequency", frequency)).counters()
        yield on_time(counters, grid(1 / frequency, seconds), f"With `frequency:={frequency}`", declared)


# --- repair -----------------------------------------------------------------------------------------------------------


@_exercise(
    "Repair",
    "Free a starving neighbour",
    (_EXECUTORS,),
    "Timers of one node do not disturb each other. A MultiThreadedExecutor alone lets callbacks run at the same time.",
    "It takes two things: a `MultiThreadedExecutor`, and a callback group of its own for each timer.",
)
def _free_a_neighbour(answer: Answer) -> Iterator[Finding]:
    for takes in (0.6, 1.3):
        seen = answer.run(5.0, *_with("takes", takes))
        findings = [_motor_on_time(seen, f"With `takes:={takes}`"), _one_image_at_a_time(seen, takes)]
        yield from findings
        if not all(finding.right for finding in findings):
            return
    turns = "when the threads take turns at every line"
    for seed in range(2):
        seen = answer.run(5.0, *_with("takes", 0.6), seed=seed)
        for finding in (_motor_on_time(seen, turns), _one_image_at_a_time(seen, 0.6)):
            if not finding.right:
                yield finding
                return


def _motor_on_time(seen: Seen, what: str) -> Finding:
    starved = (
        "While the camera's callback runs, a single-threaded executor calls nothing, and no executor calls what is in "
        "the same mutually exclusive group. A node's timers are in one such group unless you give them others."
    )
    return on_time(seen.counters("MOTOR"), grid(0.1, seen.seconds), f"{what}, the motor", starved)


def _one_image_at_a_time(seen: Seen, takes: float) -> Finding:
    """Whether the camera takes its images one after the other, each in its time, as often as that allows."""
    begun = [line for line in seen.values("CAMERA", "image") if line.time <= seen.seconds]
    done = seen.values("CAMERA", "done")
    what = f"With `takes:={takes}`, the camera"
    least = 5 if takes < 1 else 3
    if len(begun) < least:
        text = f"{what} took {len(begun)} images in {say(seen.seconds)}; it can take {least}."
        return Finding(False, text, "The camera is to work as before: each second, as far as its work allows.")
    for image, later in pairwise(begun):
        if not any(image.time <= line.time <= later.time for line in done):
            text = f"{what} began image {later.text} at {say(later.time)}, while it still took image {image.text}."
            reentrant = "In a `ReentrantCallbackGroup` calls of one timer may overlap; in the other kind they may not."
            return Finding(False, text, reentrant)
    for number, image in enumerate(begun, 1):
        end = next((line for line in done if line.text == image.text), None)
        if image.text != str(number):
            return Finding(False, f"{what}: where image {number} was due, image {plain(image.text)} began.")
        if image.time + takes > seen.seconds:
            continue
        if end is None or abs(end.time - image.time - takes) > CLOSE:
            after = f"done after {say(end.time - image.time)}" if end else "never done"
            text = f"{what}: image {number} was {after}, not after {say(takes)}."
            return Finding(False, text, "An image takes its time, and nothing can be done about that.")
    if takes < 1 and (late := [line for n, line in enumerate(begun, 1) if abs(line.time - n) > CLOSE]):
        text = f"{what} began image {late[0].text} at {say(late[0].time)}, not at {say(float(late[0].text))}."
        return Finding(False, text, "The camera is to work as before: each second.")
    return Finding(True, f"{what} took {len(begun)} images, one after the other.")


def _ends_well(answer: Answer, seen: Seen, what: str) -> Finding:
    """Whether a signal has ended the node with status 0, without a traceback."""
    if seen.killed:
        return Finding(False, f"{what}: the node did not end: {answer.say_kept(seen)}", answer.hint_for_kept(seen))
    if seen.errors:
        error = seen.errors[-1]
        caught = (
            "In the main part, Ctrl-C raises `KeyboardInterrupt`. SIGTERM ends what spins with "
            "`ExternalShutdownException`. Catch both around `spin`, in whichever thread it is."
        )
        again = "After a signal `rclpy.shutdown()` raises an error; `rclpy.try_shutdown()` does not."
        hint = again if error.type == "RCLError" else caught
        return Finding(False, f"{what}: the {answer.say_error(error)}", hint)
    if seen.status:
        return Finding(False, f"{what}: the node ended with status {seen.status} instead of 0.")
    return Finding(True, f"{what}: the node ended with status 0, without a traceback.")


_NOT_WOKEN = (
    "SIGTERM raises nothing in the main part and wakes no Rate. Let the main part spin: `spin` notices it. The loop "
    "can be in a thread."
)


def _terminated(answer: Answer, at: float, *args: str) -> tuple[Seen, Finding]:
    """What is seen when SIGTERM comes, and whether the node ends well."""
    seen = answer.ending(at + 3.0, *args, terminated_at=at)
    if seen.interrupted:
        return seen, Finding(False, f"SIGTERM at {say(at)}: the node did not end.", _NOT_WOKEN)
    return seen, _ends_well(answer, seen, "SIGTERM")


@_exercise(
    "Repair",
    "Wake a Rate that sleeps for ever",
    (_RATE, _TIMING),
    "A Rate needs nobody, as in ROS 1. Ctrl-C wakes everybody who sleeps.",
    "A Rate is a timer that wakes whoever is asleep in `sleep()`: while one thread sleeps, another has to spin.",
)
def _wake_a_rate(answer: Answer) -> Iterator[Finding]:
    endings = []
    for work, seconds in ((0.1, 3.3), (0.4, 3.05)):
        what = f"With `work:={work}`"
        seen = answer.run(seconds, *_with("work", work), has_to_end=False)
        counters = seen.counters()
        hint = ""
        if len(counters) == 1 and seen.interrupted:
            hint = "The first `sleep()` never returned. A Rate is a timer: who calls it back while the loop sleeps?"
        elif len(counters) > 1 and abs(counters[1].time - 0.5 - work) < CLOSE:
            hint = "The work is a part of the period: shorten the pause by the time that the work takes."
        finding = on_time(counters, grid(0.5, seconds, start=0.0), what, hint)
        yield finding
        endings.append(_ends_well(answer, seen, f"{what}, Ctrl-C"))
        if not finding.right or seen.killed:
            yield from endings
            return
    # SIGTERM first: where the loop is in the main part, nothing that is caught there helps.
    yield _terminated(answer, 3.3)[1]
    yield from endings
    for seed in range(2):
        counters = answer.run(3.3, seed=seed).counters()
        finding = on_time(counters, grid(0.5, 3.3, start=0.0), "When the threads take turns at every line")
        if not finding.right:
            yield finding
            return


_SWALLOWED = "Catch what a signal raises, and nothing else: an error is to end the node with its traceback."
_DRIVEN_AGAIN = "Stop the motor last, when no callback can run any more: after `spin`, in a `finally`."


@_exercise(
    "Repair",
    "End without a traceback",
    (_TUTORIAL, _TIMING),
    "Ctrl-C makes `rclpy.spin` return. What stands after `spin` is done in any case.",
    "`try:` around `spin`, `except (KeyboardInterrupt, ExternalShutdownException): pass`, and in a `finally:` what has "
    "to be done in any case.",
)
def _end_without_a_traceback(answer: Answer) -> Iterator[Finding]:
    for seconds, where in ((2.08, "while the node waits"), (2.03, "while the sensor is read")):
        seen = answer.run(seconds)
        what = f"Ctrl-C {where}"
        yield check_motor(seen, seconds, what, _DRIVEN_AGAIN, _SWALLOWED)
        yield _ends_well(answer, seen, what)
    seen, ending = _terminated(answer, 2.08)
    yield check_motor(seen, 2.08, "SIGTERM", _DRIVEN_AGAIN, _SWALLOWED)
    yield ending
    seen = answer.ending(5.0, *_with("fails_at", 10))
    yield check_motor(seen, 1.06, "The sensor fails", _DRIVEN_AGAIN, _SWALLOWED)
    if seen.status:
        yield Finding(True, f"The sensor fails: the node ended with status {seen.status}.")
    else:
        went_on = "went on" if seen.interrupted else "ended with status 0, as if all were well"
        yield Finding(False, f"The sensor fails: the node {went_on}.", _SWALLOWED)
