"""A name without ~ is a private one: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import Judge, plain
from ..observed import ObservedRun
from ..odd_nodes import PLAIN, SLEEPS_FIRST, at

TITLE = "Read the frequency from a parameter"
TEXT = """
**You need**: [the timer node](timer.md) and [how to set the frequency from a
parameter](../docs/how-to/frequency-from-parameter.rst).

Read this node's frequency, in Hz, from the private parameter `frequency`: with `_frequency:=10` on its command line it
counts ten times a second, without it twice. Replace the gap.
"""
REVEALS = "A name without ~ is a private one. What is read as a frequency can be used as a period."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        timer_delta_t_in_seconds = ...
        rospy.Timer(
            rospy.Duration(timer_delta_t_in_seconds), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

HINTS = [
    "`rospy.get_param(name, default)` reads a parameter, or returns the default.",
    "The name of a private parameter begins with `~`.",
    "You read a frequency; the timer is given a period.",
]
HINT = "`rospy.get_param(name, default)`; the name of a private parameter begins with `~`; the default is in Hz, too."


_PERIOD = "A timer is given a period, which is 1 / frequency. Without the parameter the frequency is 2 Hz."
_ASK = "`rospy.get_param` finds a parameter wherever it was set, in a launch file as well."


def _follows(seconds: float, period: float, given: str) -> Judge:
    """Whether the node ticks with the period (s) of the frequency that it is given, and has asked for a parameter."""

    def look(run: ObservedRun, when: str) -> Finding | None:
        hint = _ASK
        if any(name.count("/") > 1 and name.endswith("/frequency") for name in run.parameters):
            hint = "The parameter is read, but the timer has another period than 1 / frequency."
        elif run.parameters:
            hint = f"It asked for `{plain(run.parameters[0])}`. The private parameter is `~frequency`."
        return by.ticks(period, hint=hint)(run, when)

    return by.run(seconds, look, _asks_for_a_parameter, given=given)


def _asks_for_a_parameter(run: ObservedRun, when: str) -> Finding | None:
    """Whether the node has asked for a parameter. Nothing is said of one that has."""
    if run.parameters or not run.interrupted:
        return None
    text = f"{when}: the node asked for no parameter."
    return Finding(False, text, _ASK)


check = by.every(
    by.run(2.0, by.ticks(0.5, hint=by.unless_first_at(0.5, _PERIOD)), when="Without the parameter"),
    _follows(1.0, 0.1, "_frequency:=10"),
    _follows(4.0, 2.0, "_frequency:=0.5"),
)

SOLUTION = {
    "        timer_delta_t_in_seconds = ...\n": (
        '        frequency_in_hz = rospy.get_param("~frequency", 2.0)\n'
        "        timer_delta_t_in_seconds = 1.0 / frequency_in_hz\n"
    )
}

PARAMETER = "frequency_in_hz = rospy.get_param"

RIGHT = [
    {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = float(rospy.get_param("~frequency", 2))'},
    {"~frequency": "/spinner_py_node/frequency"},
    {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = rospy.get_param(rospy.get_name() + "/frequency", 2.0)'},
    {
        PARAMETER + '("~frequency", 2.0)': "try:\n            frequency_in_hz = rospy.get_param('~frequency')\n"
        "        except KeyError:\n            rospy.logwarn('no frequency', exc_info=True)\n"
        "            frequency_in_hz = 2.0"
    },
    {
        PARAMETER + '("~frequency", 2.0)': "frequency_in_hz = 2.0\n        if rospy.has_param('~frequency'):\n"
        "            frequency_in_hz = rospy.get_param('~frequency')"
    },
    *at("(1 / rospy.get_param('~frequency', 2))", PLAIN, SLEEPS_FIRST),
]
WRONG = [
    ({'"~frequency"': '"frequency"'}, "With `_frequency:=10`: counter 1 came at 0.5 s", "It asked for `/frequency`."),
    ({", 2.0)": ")"}, "KeyError", "the default is in Hz"),
    (
        {"1.0 / frequency_in_hz": "frequency_in_hz"},
        "Without the parameter: counter 1 came at 2 s",
        "which is 1 / frequency",
    ),
    ({"1.0 / frequency_in_hz": "1 // frequency_in_hz"}, "stopped with `ZeroDivisionError", "a period of 0 s"),
    ({", 2.0)": ", 0.5)"}, "Without the parameter: counter 1 came at 2 s", "the frequency is 2 Hz"),
    ({'rospy.get_param("~frequency", 2.0)': "2.0"}, "the node asked for no parameter", "in a launch file as well"),
    (
        {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = str(rospy.get_param("~frequency", 2.0))'},
        "TypeError: unsupported operand",
        "in Hz",
    ),
    (
        {"1.0 / frequency_in_hz": "1.0 / int(frequency_in_hz)"},
        "With `_frequency:=0.5`, the node stopped",
        "This line divides by 0.",
    ),
    ({'"~frequency"': "~frequency"}, "NameError: name 'frequency' is not defined", "Python names"),
    ({'"~frequency"': '"~period"'}, "With `_frequency:=10`: counter 1 came at 0.5 s", "parameter is `~frequency`"),
    ({'"~frequency"': '"~/frequency"'}, "counter 1 came at 0.5 s", "It asked for `/frequency`."),
    (
        {'get_param("~f': 'set_param("~frequency", 2.0) or rospy.get_param("~f'},
        "counter 1 came at 0.5 s",
        "The parameter is read",
    ),
    (
        {"        timer_": "        frequency_in_hz = 2.0\n        timer_"},
        "counter 1 came at 0.5 s",
        "The parameter is read",
    ),
    ({"1.0 / frequency_in_hz": "1.0 / max(frequency_in_hz, 1)"}, "counter 1 came at 1 s", "than 1 / frequency"),
    (
        {
            'rospy.get_param("~frequency", 2.0)': "float(dict(map(lambda each: each.split(':='), sys.argv[1:]))"
            ".get('_frequency', 2))",
            "import rospy\n": "import sys\n\nimport rospy\n",
        },
        "With `_frequency:=10`: the node asked for no parameter",
        "in a launch file as well",
    ),
]
