"""A timer goes into the loop, or a loop into the callback: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import plain
from ..observed import ObservedRun
from ..odd_nodes import CAUGHT, HEAD, LAMBDA, PLAIN, SLEEPS_FIRST, THREAD, at, say

TITLE = "Turn a loop into a timer"
TEXT = """
**You need**: [the timer node](timer.md), [the Rate node](rate.md) and [Choose Timer or
Rate](../docs/how-to/timer-or-rate.rst).

Turn this Rate node into a timer node of the same frequency, without a loop. Counter 1 then comes one period later.
"""
REVEALS = "A timer goes into the loop, or a loop into the callback."

NODE = """
import rospy


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    loop_frequency_in_hz = 2.0
    loop_rate = rospy.Rate(loop_frequency_in_hz)
    counter = 0
    while not rospy.is_shutdown():
        counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
        loop_rate.sleep()
"""

HINTS = [
    "Which lines run in each pass? They go into the callback.",
    "Where does a timer node keep its counter between calls?",
    "The timer replaces the `Rate`, and `rospy.spin()` the loop.",
]
HINT = "Move the body of the loop into a callback, remove the loop, and put `rospy.spin()` in its place."


def _moved_to_a_timer(run: ObservedRun, when: str) -> Finding | None:
    """Whether one timer printed all counters, and the node has no loop left."""
    counters = run.counters()
    timers, others = run.printers(counters)
    if not run.timers:
        return Finding(False, "no timer calls back.")
    if others:
        return Finding(False, f"counter {plain(others[0].text)} was printed by a loop, not by a timer's callback.")
    if len(timers) > 1:
        text = f"{len(timers)} timers printed the counters."
        return Finding(False, text, "A timer that is not one-shot calls back again by itself: one is enough.")
    if run.loops:
        text = f"there still is a loop, at line {run.loops[0]}."
        return Finding(False, text, "`rospy.spin()` waits for the node to be shut down; it needs no loop around it.")
    if run.naps:
        text = f"the callback sleeps, at line {run.naps[0]}."
        return Finding(False, text, "The timer waits from one call to the next: a callback does its work and returns.")
    return Finding(True, "a timer calls back, and no loop is left.") if timers else None


check = by.run(3.0, by.ticks(0.5), _moved_to_a_timer)

SOLUTION = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        frequency_in_hz = 2.0
        rospy.Timer(
            rospy.Duration(1.0 / frequency_in_hz), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

DO_SPIN = "    rospy.spin()"

RIGHT = [
    *at("0.5", PLAIN, LAMBDA, CAUGHT),
    *at(
        "0.5",
        PLAIN.replace(
            "rospy.spin()",
            "import threading\nthread = threading.Thread(target=rospy.spin)\nthread.start()\nthread.join()",
        ),
    ),
    *at("0.5", PLAIN.replace("rospy.spin()", "def main():\n    rospy.spin()\nmain()")),
    {"        frequency_in_hz = 2.0\n": "        frequency_in_hz = rospy.get_param('~frequency', 2.0)\n"},
]
WRONG = [
    (
        {"str(self.counter))\n": "str(self.counter))\n        rospy.Rate(2.0).sleep()\n"},
        "the callback sleeps, at line 14",
        "The timer waits from one call to the next",
    ),
    ({DO_SPIN: ""}, "no counter was printed", "The node ended by itself"),
    (
        {"self.timerCallback)": "self.timerCallback())"},
        "missing 1 required positional argument: 'event'",
        "Pass the function on without calling it:",
    ),
    ({"(self, event)": "(self)"}, "takes 1 positional argument but 2 were given", "one argument, the event"),
    ({"1.0 / frequency_in_hz": "frequency_in_hz"}, "counter 1 came at 2 s, not at 0.5 s", "into a callback"),
    (
        {DO_SPIN: "    rate = rospy.Rate(2.0)\n    while not rospy.is_shutdown():\n        rate.sleep()"},
        "there still is a loop, at line 21",
        "it needs no loop around it",
    ),
    (
        {DO_SPIN: "    while not rospy.is_shutdown():\n        rospy.sleep(0.5)\n"},
        "there still is a loop, at line 20",
        "it needs no loop around it",
    ),
    (at("0.5", SLEEPS_FIRST)[0], "no timer calls back", "into a callback"),
    (at("0.5", THREAD)[0], "no timer calls back", "into a callback"),
    (
        at("0.5", THREAD.replace("rospy.spin()", "rospy.Timer(rospy.Duration(1), print)\nrospy.spin()"))[0],
        "was printed by a loop",
        "into a callback",
    ),
    (
        f"""{HEAD}def callback(event):
    for count in range(1, 1000):
        {say("count")}
        rospy.sleep(0.5)
rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.spin()
""",
        "one call of a timer's callback printed counters 1 to 6: a loop is in it",
        by.RETURNS,
    ),
    (
        f"""{HEAD}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
    rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
callback(None)
rospy.spin()
""",
        "counter 1 came at 0 s, not at 0.5 s",
        "A timer waits for one period before its first call",
    ),
    (
        f"""{HEAD}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
    rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.spin()
""",
        "6 timers printed the counters",
        "calls back again by itself",
    ),
]
