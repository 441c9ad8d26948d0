"""The lists ``notebooks/exercises.md`` and ``notebooks/ros2-exercises.md``, and the exercises without a file.

A test compares the right numbers of a prediction with a run of the node on its page.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import NamedTuple

from . import judges as by
from .judging import Judge
from .predictions import chosen, predicted

__all__ = ["PARTS", "QUESTIONS", "Exercise"]


class Exercise(NamedTuple):
    """An exercise of the site.

    ``name`` stays, whatever comes before it: answers, files and links know it. ``number`` is what is shown, and
    ``part`` the heading below which it stands, such as "Predict". ``needs`` are the pages to read first, as paths
    without a suffix. ``reveals`` is the misconception that a wrong answer gives away, as its holder would put it.
    ``hint`` is for answers about which there is nothing more to say. ``ros`` is 1 or 2: each has a page of
    exercises.
    """

    title: str
    needs: tuple[str, ...]
    reveals: str
    hint: str
    judge: Judge
    name: str = ""
    part: str = ""
    ros: int = 0
    number: int = 0


# --- ROS 1: predict ---------------------------------------------------------------------------------------------------


_PREDICT = {
    "first-ticks": Exercise(
        title="The first ticks",
        needs=("notebooks/timer", "notebooks/rate"),
        reveals="A timer calls back immediately. A duration is a frequency. A rate sleeps for a whole period after the "
        "work.",
        hint="When does the first tick come: at the start, or one period later? How far apart are the ticks?",
        judge=predicted("first-ticks"),
    ),
    "after-a-slow-callback": Exercise(
        title="The ticks after a slow callback",
        needs=("notebooks/slow-callback", "docs/how-timing-works"),
        reveals="A timer calls back on time, whatever its callback does. Ticks that are due meanwhile all wait in a "
        "queue.",
        hint="The callback ends at 1.2 s plus the time for which it blocks. Which ticks were due by then?",
        judge=predicted("after-a-slow-callback"),
    ),
    "cpp-ticks": Exercise(
        title="The ticks of a C++ node",
        needs=("docs/tutorial", "docs/how-timing-works"),
        reveals="roscpp and rospy time their timers alike. A ros::Timer that nobody keeps goes on calling back.",
        hint="The callback ends at 1.2 s plus the time for which it blocks. Is the call after the next one due by "
        "then, too?",
        judge=predicted("cpp-ticks"),
    ),
}

# --- ROS 1: change ----------------------------------------------------------------------------------------------------

_ENDS_ALL = "Stop one timer, and no more: `rospy.signal_shutdown()` ends the whole node."
_PRIVATE = "Does the name begin with `~`? Is it a frequency that you read, and a period that the timer is given?"
_LOCK = "While one callback reads the parts and writes them, the other has to keep away: both need one lock."
_drives_until = partial(
    by.drives_until,
    again="A hook runs in the middle of a pass, which then goes on. Ask `rospy.is_shutdown()` before you drive, or "
    "stop the motor after the loop, in a `finally`.",
    late="An exception that is caught, or that ends a timer alone, does not end the node: no hook is called.",
)

_CHANGE = {
    "ten-hertz": Exercise(
        title="Change the rate",
        needs=("notebooks/timer",),
        reveals="A timer is given a frequency.",
        hint="A timer takes a period in seconds, not a frequency: the period is 1 / frequency.",
        judge=by.run(1.0, by.ticks(0.1)),
    ),
    "fire-once": Exercise(
        title="Fire once",
        needs=("notebooks/timer",),
        reveals="A timer stops when its callback does nothing any more.",
        hint="`rospy.Timer` has a parameter `oneshot`; its period is then the time until the only call.",
        judge=by.run(5.0, by.ticks(at=[1.5]), by.stops(1)),
    ),
    "stop-after-five": Exercise(
        title="Stop after five ticks",
        needs=("notebooks/timer",),
        reveals="To stop a timer is to end its callback, its thread or the node.",
        hint="Keep the timer in `self.timer`, and call its `shutdown()` after counter 5.",
        judge=by.run(
            6.0, by.ticks(0.5, until=2.5), by.ticks(1.0, "The heartbeat", "HEARTBEAT", _ENDS_ALL), by.stops(5)
        ),
    ),
    "loop-to-timer": Exercise(
        title="Turn a loop into a timer",
        needs=("notebooks/timer", "notebooks/rate", "docs/how-to/timer-or-rate"),
        reveals="A timer goes into the loop, or a loop into the callback.",
        hint="What stands in the loop goes into a callback, the loop goes, and `rospy.spin()` takes its place.",
        judge=by.run(3.0, by.ticks(0.5), by.moved_to_a_timer()),
    ),
    "frequency-parameter": Exercise(
        title="Read the frequency from a parameter",
        needs=("notebooks/timer", "docs/how-to/frequency-from-parameter"),
        reveals="A name without ~ is a private one. What is read as a frequency can be used as a period.",
        hint="`rospy.get_param(name, default)`; the name of a private parameter begins with `~`; the default is in Hz, "
        "too.",
        judge=by.every(
            by.run(2.0, by.ticks(0.5), when="Without the parameter"),
            by.run(1.0, by.ticks(0.1, hint=_PRIVATE), by.asks_for_a_parameter(), given="_frequency:=10"),
            by.run(4.0, by.ticks(2.0, hint=_PRIVATE), given="_frequency:=0.5"),
        ),
    ),
    "two-rates": Exercise(
        title="Run at two rates",
        needs=("notebooks/timer", "docs/how-to/timer-or-rate"),
        reveals="Two timers need two nodes. Two loops can follow each other.",
        hint="A node can have as many timers as it likes, each with its own period, callback and counter.",
        judge=by.run(
            2.0,
            by.ticks(0.1, "`[FAST]`", "FAST"),
            by.ticks(0.5, "`[SLOW]`", "SLOW"),
        ),
    ),
    "survive-an-overrun": Exercise(
        title="Survive an overrun",
        needs=("notebooks/rate", "notebooks/drift"),
        reveals="A pass that was lost has to be made up for. After an overrun one may count on from now.",
        hint="Before the loop sleeps, move the deadline on by whole periods until it lies ahead.",
        judge=by.every(
            by.run(5.0, by.ticks(0.5, at=[0.0, 0.5, 1.0], start=2.0, hint=by.overrun), given="_work:=0.7"),
            by.run(5.0, by.ticks(0.5, at=[0.0, 0.5, 1.0], start=3.0, hint=by.overrun), given="_work:=1.7"),
            by.run(5.0, by.ticks(0.5, at=[0.0, 0.5, 1.0], start=1.5, hint=by.overrun), given="_work:=0.1"),
        ),
    ),
    "share-data": Exercise(
        title="Share data between two callbacks",
        needs=("notebooks/timer", "docs/how-to/shared-data"),
        reveals="Callbacks of one node never run at the same time. A single line of Python cannot be interrupted.",
        hint=_LOCK,
        judge=by.until_wrong(
            by.run(5.2, by.parts_add_up(_LOCK)),
            by.shaken(5, 5.2, by.parts_add_up(_LOCK), right="the reports are right as well"),
            by.run(5.2, by.calls_add_up(), when="when the computer is busy for a while", stalls_at=1.22),
        ),
    ),
    "stop-the-motor": Exercise(
        title="Stop the motor",
        needs=("notebooks/rate", "docs/tutorial"),
        reveals="After a shutdown hook nothing else of the node runs. A node ends by Ctrl-C only.",
        hint="`rospy.on_shutdown(function)`: the function is called when the node is shut down, in whatever way.",
        judge=by.every(
            by.run(2.08, _drives_until(2.08), when="Ctrl-C while the loop sleeps"),
            by.run(2.03, _drives_until(2.03), when="Ctrl-C while the sensor is read"),
            by.run(5.0, _drives_until(1.06), given="_fails_at:=1.0", when="The sensor fails", allowed="no sensor"),
        ),
    ),
}

# --- ROS 1: diagnose --------------------------------------------------------------------------------------------------

_DIAGNOSE = {
    "missing-ticks": Exercise(
        title="Count the ticks that are missing",
        needs=("notebooks/slow-callback", "docs/how-timing-works"),
        reveals="A late tick is a missing one. What a timer event says is the same in rospy and roscpp.",
        hint="`event.current_real - event.current_expected` is how late this call is. How many whole periods is that?",
        judge=by.every(
            by.run(5.0, by.missing([0, 0, 0, 3, 3, 3, 3, 3, 3]), given="_blocks_for:=1.8"),
            by.run(5.0, by.missing([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0]), given="_blocks_for:=1.0"),
            by.run(5.0, by.missing([0] * 12), given="_blocks_for:=0.7"),
        ),
    ),
    "name-the-fault": Exercise(
        title="Name the fault",
        needs=("notebooks/rate", "notebooks/slow-callback", "notebooks/drift"),
        reveals="A loop that is slow and a timer that is slow look alike. A traceback means that the node has ended.",
        hint="Look at the first tick, at the distances between the ticks, and at what goes on to the end.",
        judge=chosen("name-the-fault"),
    ),
}

# --- ROS 1: publish ---------------------------------------------------------------------------------------------------


_PUBLISH = {
    "what-is-heard": Exercise(
        title="What the subscriber hears",
        needs=("docs/publish", "notebooks/publish"),
        reveals="What is published waits until somebody subscribes. A latch keeps everything. A queue of 1 makes a "
        "callback wait for the next message.",
        hint="Is the connection there when the message is published? Which message is the newest one when the callback "
        "is free?",
        judge=predicted("what-is-heard", asked="counters"),
    ),
    "publish-the-counter": Exercise(
        title="Publish the counter",
        needs=("docs/publish",),
        reveals="A publisher can be made when it is needed. A topic is found by its type.",
        hint='Make a `rospy.Publisher("counter", UInt32, queue_size=10)` in `__init__`, and let the callback publish.',
        judge=by.published_and_heard,
    ),
    "late-subscriber": Exercise(
        title="Reach a subscriber that comes late",
        needs=("docs/publish", "notebooks/publish"),
        reveals="What is published waits for its subscribers. A longer queue keeps it for them.",
        hint="`rospy.Publisher` has a parameter `latch`.",
        judge=by.every(
            by.run(4.0, by.arrives_once("7", at=1.0), given="_subscribes_at:=1.0"),
            by.run(4.0, by.arrives_once("7", at=2.5), given="_subscribes_at:=2.5"),
        ),
    ),
    "newest-position": Exercise(
        title="Steer by the newest position",
        needs=("docs/publish", "notebooks/publish", "docs/how-to/shared-data"),
        reveals="A subscriber always gets the newest message. It is the publisher's queue that has to be short.",
        hint="The subscriber has a queue, too: `queue_size` says how many messages may wait there.",
        judge=by.run(10.0, by.steers_by_the_newest()),
    ),
    "rostopic-hz": Exercise(
        title="Read rostopic hz",
        needs=("docs/publish", "notebooks/publish", "docs/how-to/irregular-loop"),
        reveals="rostopic hz says what the rate is now. If the average is right, the loop is regular.",
        hint="Compare the average with what was asked for, `min` with `max`, and the first report with the second.",
        judge=chosen("rostopic-hz"),
    ),
}

# --- ROS 2: predict ---------------------------------------------------------------------------------------------------

_PREDICT_2 = {
    "first-call": Exercise(
        title="When the first call comes",
        needs=("notebooks/ros2-timer",),
        reveals="A timer calls back immediately.",
        hint="Does a timer call back before it has waited? What does the loop do before it sleeps?",
        judge=predicted("first-call"),
    ),
    "who-calls": Exercise(
        title="Who calls the callback",
        needs=("notebooks/ros2-timer",),
        reveals="A timer calls back by itself, whether the node spins or not.",
        hint="In ROS 2 a timer has no thread of its own. Who calls the callback?",
        judge=predicted("who-calls"),
    ),
    "slow-timer": Exercise(
        title="When a slow timer ticks again",
        needs=("notebooks/ros2-timer", "docs/ros2/how-timing-works"),
        reveals="Ticks that were lost are made up for, or a timer counts on from a late call.",
        hint="When does the callback return? Which tick is overdue then, and which is the next place of the grid 0.4, "
        "0.8, 1.2?",
        judge=predicted("slow-timer"),
    ),
    "late-listener": Exercise(
        title="What a late subscriber hears",
        needs=("docs/ros2/publish", "notebooks/ros2-publish"),
        reveals="What is published waits for its subscribers.",
        hint="Who keeps a message that was published before anybody subscribed?",
        judge=predicted("late-listener", asked="counters"),
    ),
    "find-the-order": Exercise(
        title="Find the order in which it fails",
        needs=("docs/how-to/find-the-order",),
        reveals="What has never failed in a test has no race.",
        hint="What has each thread looked up when it writes?",
        judge=predicted("find-the-order", asked="numbers"),
    ),
}

# --- all of them ------------------------------------------------------------------------------------------------------

_WAIT_2 = (
    *("starving-neighbour", "ask-without-hanging", "let-a-callback-wait", "slow-service", "cancel-a-goal"),
    "find-the-order",
)
PARTS: Sequence[tuple[int, str, Iterable[str]]] = (
    (
        *(2, "Start"),
        ("make-it-10-hz", "first-call", "two-timers", "call-back-once", "period-parameter", "move-to-ros-2"),
    ),
    (2, "Predict", ("who-calls", "slow-timer")),
    (2, "Publish", ("publish-a-counter", "late-listener", "match-the-qos", "only-the-newest")),
    (2, "Wait", _WAIT_2),
    (2, "End", ("wake-a-rate", "end-without-a-traceback")),
    (1, "Predict", _PREDICT),
    (1, "Change", _CHANGE),
    (1, "Diagnose", _DIAGNOSE),
    (1, "Publish", _PUBLISH),
)
"""The exercises of the two lists, by ROS and part, in their order. Each of the others is a file in ``own``."""

QUESTIONS = {
    name: each._replace(name=name)
    for of in (_PREDICT_2, _PREDICT, _CHANGE, _DIAGNOSE, _PUBLISH)
    for name, each in of.items()
}
