"""What is said to beginners of their errors with rclpy; for rospy see page/test_sentences.py, rospy/test_topics.py."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from rosspin.clocks.simulation import Simulation
from rosspin.exercises.advice import advice
from rosspin.run.simulate import run_node
from rosspin.run.source import load
from rosspin.run.streams import capture

# A node's class around some lines of its __init__, with callbacks to choose from.
NODE = """
import rclpy
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):
        super().__init__("a")
        {}

    def nothing(self):
        pass

    def one(self, event):
        pass

    def wrong():
        pass

    def mine(self):
        self.one()

    def uses_none(self):
        self.create_timer(0.1, print)()


rclpy.init()
node = A()
rclpy.spin(node)
"""

TIMER = (
    "A timer passes its callback no argument: def timer_callback(), or (self) in a class. Is it the one that should be "
    "called?"
)
SELF = "Its first parameter is the node, since it is a method: def timer_callback(self)."
MESSAGE = "A subscription passes its callback the message: def callback(message), or (self, message) in a class."
NUMBER = "The period of a timer comes first and is a number of seconds: create_timer(0.5, self.timer_callback)"
NEGATIVE = "The period of a timer cannot be negative: give create_timer the seconds from one call to the next."
DECLARE = 'Declare a parameter before you read it: self.declare_parameter("frequency", ...), with its default.'
ITSELF = "Pass the callback itself, without calling it: self.timer_callback, not self.timer_callback()."


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("self.create_timer(0.5, self.one)", TIMER),
        ("self.create_timer(0.5, self.wrong)", SELF),
        ("self.create_timer(0.5, self.nothing())", ITSELF),
        ("self.create_timer(Duration(seconds=0.5), self.nothing)", NUMBER),
        ("self.create_timer(self.nothing, 0.5)", NUMBER),
        ("self.create_timer(-0.5, self.nothing)", NEGATIVE),
        ('self.create_subscription(String, "topic", self.nothing, 1)', MESSAGE),
        ("self.get_parameter('frequency')", DECLARE),
        ("Node('another name')", ""),
        ("1 / 0", ""),
        # What the node's own lines do wrong is for Python to say.
        ("self.create_timer(0.5, self.mine)", ""),
        ("self.create_timer(0.5, self.uses_none)", ""),
    ],
)
@pytest.mark.parametrize("executor", ["SingleThreadedExecutor", "MultiThreadedExecutor"])
def test_advice(write: Callable[[str], Any], line: str, said: str, executor: str) -> None:
    text = NODE.replace("spin(node)", f"spin(node, rclpy.executors.{executor}())")
    assert _said(write(text.format(line))) == said


def test_parameter_of_another_type(write: Callable[[str], Any]) -> None:
    path = write(NODE.format("self.declare_parameter('frequency', 2.0)"))
    assert _said(path, "--ros-args", "-p", "frequency:=5").startswith("A parameter keeps the type")
    assert _said(path, "--ros-args", "-p", "frequency:=5.0") == ""


def test_node_before_init(write: Callable[[str], Any]) -> None:
    path = write("import rclpy.node\nrclpy.node.Node('a')\n")
    assert _said(path) == "Call rclpy.init() before you make a node, and rclpy.shutdown() only at the end."


def _said(path: Any, *args: str) -> str:
    """What is said of the errors in a node; Ctrl-C, which ends it, is none."""
    with capture():
        errors = run_node(load(path), 5, args, Simulation()).world.errors
    assert errors
    return "".join(dict.fromkeys(map(advice, errors)))
