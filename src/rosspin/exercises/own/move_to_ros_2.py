"""A node is moved by renaming what it imports: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Sequence

from .. import judges as by
from ..observed import Printed

TITLE = "Move a node to ROS 2"
TEXT = """
**You need**: the [tutorial on ROS 2](../docs/ros2/tutorial.rst) and [From ROS 1 to ROS 2](../docs/ros2/from-ros-1.rst).

Write this ROS 1 node for ROS 2: the same counters at the same times, and a parameter `frequency`, as in
`--ros-args -p frequency:=10.0`. If you have never met ROS 1, skip this exercise.
"""
REVEALS = "A node is moved by renaming what it imports. A timer passes its callback an event in ROS 2, too."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        frequency_in_hz = rospy.get_param("~frequency", 2.0)
        rospy.Timer(rospy.Duration(1 / frequency_in_hz), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

HINTS = [
    "Begin with `import rclpy` and `from rclpy.node import Node`. The class becomes a `Node`, and "
    'gets its name by `super().__init__("spinner_py_node")`.',
    "The node has what was in the module `rospy`: `self.create_timer`, `self.declare_parameter`, "
    "`self.get_logger()`. The name of a parameter has no `~` in ROS 2.",
    "The period is a number, and the callback gets no event. Call `rclpy.init()` before you make "
    "the node, and give the node to `rclpy.spin`.",
]
_PERIOD = "A timer is given a period, which is 1 / frequency. Without the parameter the frequency is 2 Hz."
_DECLARED = 'The parameter is called "frequency". Its name has no `~` in ROS 2, and it is declared before it is read.'
HINT = (
    "A class of `Node` makes the timer: `self.create_timer(period, callback)`. `rclpy.init()` comes first, "
    "`rclpy.spin(node)` last."
)


def _ignored(counters: Sequence[Printed]) -> str:
    """Return a hint on counters that come as without the parameter; empty for others."""
    return _DECLARED if counters and abs(counters[0].time - 0.5) < by.CLOSE else "Is the period 1 / frequency?"


check = by.every(
    by.run(2.0, by.ticks(0.5, hint=by.unless_first_at(0.5, _PERIOD)), when="Without the parameter"),
    by.run(1.0, by.ticks(0.1, hint=_ignored), by.declares("frequency"), given="frequency:=10.0"),
    by.run(4.0, by.ticks(1.25, hint=_ignored), given="frequency:=0.8"),
)

SOLUTION = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        frequency_in_hz = self.declare_parameter("frequency", 2.0).value
        self.create_timer(1 / frequency_in_hz, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""
AFTER = """
Moved line by line, the node ends with a traceback at Ctrl-C. The last exercise is about that.
"""

SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
PLAIN = """import sys
import rclpy
rclpy.init()
node = rclpy.create_node("n")
count = 0
def callback():
    global count
    count += 1
    node.get_logger().info("[SPINNER PY NODE] counter = %d" % count)
MADE
rclpy.spin(node)
"""
FREQUENCY = 'self.declare_parameter("frequency", 2.0).value'

RIGHT = [
    PLAIN.replace("MADE", f"node.create_timer(1 / {FREQUENCY.replace('self', 'node')}, callback)"),
    {FREQUENCY: 'float(self.declare_parameter("frequency", 2.0).value)'},
    {FREQUENCY: 'self.declare_parameter("frequency", value=2.0).get_parameter_value().double_value'},
    {SPIN: "        while rclpy.ok():\n            rclpy.spin_once(spinner_py_node, timeout_sec=1.0)\n"},
    {TRY: "    rclpy.spin(spinner_py_node)\n    spinner_py_node.destroy_node()\n    rclpy.shutdown()\n"},
    {
        "class SpinnerPyNode(Node):\n    def __init__(self):\n        super()": "class SpinnerPyNode(Node):\n"
        "    def __init__(self, **kwargs):\n        super()",
        "    rclpy.init()\n": "    rclpy.init(args=None)\n",
    },
]
WRONG = [
    ({"self.get_logger().info(": "self.get_logger.info("}, "no attribute 'info'", "be called first, with `()`"),
    ({"self.get_logger().info(": "rclpy.loginfo("}, "no attribute 'loginfo'", "In ROS 2 it is `self.get_logger()"),
    ({FREQUENCY: FREQUENCY.replace(".value", "")}, "and 'Parameter'", "which is its `.value`"),
    ({"SpinnerPyNode(Node):": "SpinnerPyNode:", '("spinner_py_node")': "()"}, "attribute '", "(Node)`?"),
    ("import rospy, rclpy\n", "imports both", "This exercise is on ROS 2"),
    ({"timer_callback(self)": "timer_callback(self, event)"}, "missing 1 required positional", "no argument"),
    ({FREQUENCY: "2.0"}, "With `frequency:=10.0`: counter 1 came at 0.5 s", "is called"),
    ({'"frequency"': '"~frequency"'}, "With `frequency:=10.0`: counter 1 came at 0.5 s", "has no `~` in ROS 2"),
    ({FREQUENCY: 'self.get_parameter("frequency").value'}, "ParameterNotDeclared", "before you read it"),
    (
        {"create_timer(1 / frequency": "create_timer(frequency"},
        "Without the parameter: counter 1 came at 2 s",
        "which is 1 / frequency",
    ),
    ({SPIN: "        rclpy.spin()\n"}, "missing 1 required positional argument: 'node'", "`rclpy.spin(node)`:"),
    ({SPIN: "        pass\n"}, "no counter was printed", "Does its main part come to `rclpy.spin(node)`?"),
    ({'        super().__init__("spinner_py_node")\n': ""}, "AttributeError", "begins its __init__"),
    ({"    rclpy.init()\n": ""}, "NotInitialized", "Call rclpy.init() before"),
    ({"self.get_logger().info": "self.loginfo"}, "has no attribute 'loginfo'", "Python names what"),
    (
        {FREQUENCY: FREQUENCY.replace("2.0", "2")},
        "Started with `--ros-args -p frequency:=10.0`",
        "keeps the type with which it was declared",
    ),
]
