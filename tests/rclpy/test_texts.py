"""What rclpy's C part makes of texts and numbers, and what of its values cannot be copied. Each was tried on Jazzy."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any

import pytest

from rosspin import rclpy, simulate


@pytest.mark.parametrize(
    "given, printed",
    [
        (b"T=21\r\n", "T=21\r\n"),
        (bytearray(b"x"), "x"),
        (b"\xff", "\ufffd"),
        ("a\0b", "a"),
        (b"a\0b", "a"),
        (None, "(null)"),
    ],
)
def test_a_log_takes_bytes_and_ends_at_a_null(given: Any, printed: str) -> None:
    def node() -> None:
        rclpy.init()
        rclpy.create_node("node").get_logger().info(given)

    assert simulate(node, 1).console == f"[INFO] [0.000000000] [node]: {printed}\n"


@pytest.mark.parametrize("given", [memoryview(b"x"), "\ud800", 5])
def test_a_log_refuses_what_is_no_text(given: Any) -> None:
    def node() -> None:
        rclpy.init()
        with pytest.raises(TypeError, match="incompatible function arguments"):
            rclpy.create_node("node").get_logger().info(given)

    assert simulate(node, 1).status == 0


@pytest.mark.parametrize(
    "value, error",
    [(2**63, SystemError), (-(2**63) - 1, SystemError), ([2**63], OverflowError), ("\ud800", UnicodeEncodeError)],
)
def test_a_parameter_that_no_message_can_hold_is_refused(value: Any, error: type[Exception]) -> None:
    def node() -> None:
        rclpy.init()
        made = rclpy.create_node("node")
        assert made.declare_parameter("most", 2**63 - 1).value == 2**63 - 1
        with pytest.raises(error):
            made.declare_parameter("more", value)

    assert simulate(node, 1).status == 0


def test_a_message_may_be_given_for_its_class_until_something_is_published() -> None:
    def node() -> None:
        from std_msgs.msg import String

        rclpy.init()
        made = rclpy.create_node("node")
        made.create_subscription(String(), "topic", lambda message: print(repr(message.data)), 10)
        with pytest.raises(TypeError, match="isinstance"):
            made.create_publisher(String(), "topic", 10).publish(String())
        made.create_publisher(String, "topic", 10).publish(String(data="a\0b"))
        rclpy.spin_once(made)

    assert simulate(node, 1).console == "'a'\n"


def test_times_and_profiles_are_copied_neither_deeply_nor_by_pickle() -> None:
    values = [rclpy.time.Time(seconds=1), rclpy.duration.Duration(seconds=1), rclpy.qos.QoSProfile(depth=1)]
    for value in values:
        assert copy.copy(value) == value
        for way in (copy.deepcopy, pickle.dumps):
            with pytest.raises(TypeError, match=r"cannot pickle 'rclpy._rclpy_pybind11.rcl_\w+_t' object"):
                way(value)


PARTS = """
import copy, pickle, rclpy
from std_msgs.msg import String
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("node")
publisher, subscription = node.create_publisher(String, "a", 1), node.create_subscription(String, "a", print, 1)
client, service = node.create_client(Trigger, "t"), node.create_service(Trigger, "t", print)
for part in (node.get_clock(), publisher, subscription, service, client):
    print(type(copy.copy(part)) is type(part))
    try:
        pickle.dumps(part)
    except TypeError as error:
        print(error)
try:
    node.create_service(Trigger.Request(), "b", print)
except RuntimeError as error:
    print(error)
"""


def test_parts_of_a_node_cannot_be_pickled(write: Any) -> None:
    """As the real one prints it."""
    parts = [f"rclpy._rclpy_pybind11.{name}" for name in ("Clock", "Publisher", "Subscription", "Service")]
    assert simulate(write(PARTS), 1).console.splitlines() == [
        *(line for part in (*parts, "_thread.lock") for line in ("True", f"cannot pickle '{part}' object")),
        "The service type provided is not valid (std_srvs.srv.Trigger_Request()), this might be a message or action",
    ]


NAMING = """
from rclpy.node import Node
import rclpy.qos
def look(function):
    try:
        function()
    except Exception as error:
        print(str(error).partition(" (")[0])
def node():
    from rclpy.node import Depth
def executors():
    from rclpy.executors import Depth
def tf2():
    from tf2_ros import Depth
for each in Node.get_parameter, lambda: rclpy.qos.Depth, node, executors, tf2:
    look(each)
"""


@pytest.mark.parametrize(("ros", "name"), [("rospy", "Rate"), ("rclpy.timer", "Rate"), ("rclpy.node", "Node")])
def test_a_node_can_read_the_source_of_a_class(tmp_path: Path, ros: str, name: str) -> None:
    """It names another module than its file has."""
    path = tmp_path / "reading.py"
    path.write_text(f"import inspect\nimport {ros}\nprint(inspect.getsource({ros}.{name}).splitlines()[0])\n")
    assert simulate(path, 1).console.startswith(f"class {name}")


def test_errors_name_modules_and_methods_as_rclpy_does(tmp_path: Path) -> None:
    path = tmp_path / "naming.py"
    path.write_text(NAMING)
    assert simulate(path, 1).console.splitlines() == [
        "Node.get_parameter() missing 2 required positional arguments: 'self' and 'name'",
        "module 'rclpy.qos' has no attribute 'Depth'",
        "cannot import name 'Depth' from 'rclpy.node'",
        "cannot import name 'Depth' from 'rclpy.executors'",
        "cannot import name 'Depth' from 'tf2_ros'",
    ]
