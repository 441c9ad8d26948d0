"""A run is processes on one clock: the first import says for which ROS each is, and each has what is its own."""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import Any

import pytest

from rosspin import Node, NodeFailed, simulate, start
from rosspin.__main__ import main

TIMER = """
import rclpy
from rclpy.node import Node

def main(period=0.5):
    rclpy.init()
    node = Node("timer")
    node.create_timer(period, lambda: print("tick"))
    rclpy.spin(node)
"""


def timer(period: float = 0.5) -> None:
    """A node of ROS 2 that does not show it at first sight."""
    rclpy = __import__("rclpy")
    rclpy.init()
    node = rclpy.create_node("timer")
    node.create_timer(period, lambda: print("tick"))
    rclpy.spin(node)


class Callable:
    def __call__(self) -> None:
        timer(0.5)


def decorated(function: Any) -> Any:
    @functools.wraps(function)
    def call() -> Any:
        return function()

    return call


# --- which ROS --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "node", [timer, lambda: timer(0.5), functools.partial(timer, 0.5), Callable(), decorated(timer)]
)
def test_a_function_is_for_the_ros_that_it_imports_wherever_that_is(node: Any) -> None:
    run = simulate(node, 1)
    assert run.console.startswith("tick\ntick\nTraceback") and run.status == 130
    assert [tick.real for tick in run.ticks] == [0.5, 1.0]


def test_a_node_in_the_layout_of_ament_is_for_the_ros_that_a_module_deep_in_it_imports(tmp_path: Path) -> None:
    package = tmp_path / "mypkg" / "mypkg"
    package.mkdir(parents=True)
    (package.parent / "package.xml").write_text("<package><name>mypkg</name></package>\n")
    (package / "__init__.py").write_text("")
    (package / "base.py").write_text(TIMER)
    (package / "middle.py").write_text("from mypkg.base import main\n")
    (package / "node.py").write_text("from mypkg.middle import main\nmain()\n")
    assert simulate(package / "node.py", 1).console.startswith("tick\ntick\n")


def test_a_node_that_is_being_migrated_takes_what_it_finds_first(write: Any) -> None:
    both = "try:\n    import {}\nexcept ImportError:\n    import {}\nimport sys\nprint('rclpy' in sys.modules)\n"
    assert simulate(write(both.format("rclpy", "rospy")), 1).console == "True\n"
    assert simulate(write(both.format("rospy", "rclpy")), 1).console == "False\n"


@pytest.mark.parametrize("first", ["rospy", "rclpy"])
def test_a_process_has_one_ros(write: Any, first: str) -> None:
    other = {"rospy": "rclpy", "rclpy": "rospy"}[first]
    run = simulate(write(f"import {first}\nprint('so far')\nimport {other}\n"), 1)
    ros = 1 if first == "rospy" else 2
    said = f"ImportError: this process has imported ROS {ros}: a process is one of ROS 1 (rospy) or of ROS 2 (rclpy)\n"
    assert run.status == 1 and run.console.startswith("so far\n") and run.console.endswith(said)
    caught = f"import {first}\ntry:\n    import {other}\nexcept ImportError:\n    print(1)\n"
    assert simulate(write(caught), 1).console == "1\n"


def test_messages_before_the_ros_are_those_that_the_code_names() -> None:
    def node() -> None:
        import rclpy  # type: ignore[import-not-found]
        from std_msgs.msg import String

        print(String(data=rclpy.__name__[-5:]))

    assert simulate(lambda: node(), 1).console == "std_msgs.msg.String(data='rclpy')\n"


def test_a_submodule_can_be_what_is_imported_first() -> None:
    def node() -> None:
        from rclpy.impl.logging_severity import LoggingSeverity  # type: ignore[import-not-found]

        print(int(LoggingSeverity.INFO))

    before = set(sys.modules)
    assert simulate(node, 1).console == "20\n"
    assert not any(name.startswith("rclpy") for name in sys.modules.keys() - before)


# --- several processes ------------------------------------------------------------------------------------------------

TALKER = """
import sys
import rclpy
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
numbers = iter(range(1000))
node.create_timer(0.1, lambda: publisher.publish(UInt32(data=next(numbers))))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
"""
LISTENER = """
import rclpy
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
node.create_subscription(UInt32, "numbers", lambda message: print(node.get_name(), "heard", message.data), 10)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
"""


@pytest.fixture
def pair(write: Any) -> tuple[str, str]:
    return str(write(TALKER, "talker.py")), str(write(LISTENER, "listener.py"))


def test_processes_of_ros_2_find_each_other_and_miss_what_was_before(pair: tuple[str, str]) -> None:
    run = simulate(pair, 0.5)
    assert run.console == "".join(f"listener heard {number}\n" for number in range(1, 5))
    assert run.status == 0
    assert [(message.topic, message.node, message.time) for message in run.messages][:1] == [
        ("/numbers", "/talker", 0.1)
    ]
    assert {tick.source for tick in run.ticks} == {"/talker <lambda>"}


def test_they_have_names_and_command_lines_of_their_own(pair: tuple[str, str]) -> None:
    talker, listener = pair
    left = Node(listener, name="left", namespace="/here")
    right = Node(listener, ["--ros-args", "-r", "__node:=right", "-r", "numbers:=nothing"])
    run = simulate([talker, left, Node(talker, namespace="/here"), right], 0.4)
    assert run.console == "left heard 1\nleft heard 2\nleft heard 3\n"


def test_the_command_line_takes_several_files(pair: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", *pair, "--simulated", "--seconds", "0.3"]) == 0
    assert capsys.readouterr().out == "listener heard 1\nlistener heard 2\n"
    assert main(["run", *pair, "--seconds", "0.3"]) == 1
    assert "several nodes run in simulated time only: --simulated\n" in capsys.readouterr().err


def test_they_can_be_run_in_steps_with_a_test_as_another_node(pair: tuple[str, str]) -> None:
    with start(pair) as node:
        assert node.advance(0.2).console == "listener heard 1\n"
        node.publish("numbers", 77)
        node.publish("numbers", node.message("std_msgs/UInt32", data=78))
        assert node.advance(0.0).console == "listener heard 77\nlistener heard 78\n"
        assert [message.message.data for message in node.messages("numbers")] == [0, 1]
        assert node.status is None
    assert node.status == 0


def test_who_fails_is_told_and_its_status_is_that_of_the_run(pair: tuple[str, str], write: Any) -> None:
    bad = write(LISTENER.replace("print(", "int("), "bad.py")
    run = simulate([pair[0], bad, pair[1]], 0.4)
    assert run.status == 1 and "rosspin: bad ended with status 1\n" in run.console
    assert "listener heard 3\n" in run.console
    with pytest.raises(TypeError) as caught, start([pair[0], bad]) as node:
        node.advance(1.0)
    assert caught.value.__notes__ == ["raised in bad.py at 0.2 s"]
    with pytest.raises(NodeFailed, match="exits.py ended with status 3 at 0.0 s"):
        start([pair[0], write("import sys, rclpy\nsys.exit(3)\n", "exits.py")])


def test_nodes_of_both_roses_run_together_and_do_not_hear_each_other(pair: tuple[str, str], write: Any) -> None:
    one = write(
        """
        import rospy
        from std_msgs.msg import UInt32

        rospy.init_node("one")
        rospy.Subscriber("numbers", UInt32, lambda message: print("one heard", message.data))
        publisher = rospy.Publisher("numbers", UInt32, queue_size=1)
        rate = rospy.Rate(2)
        while not rospy.is_shutdown():
            publisher.publish(100)
            rate.sleep()
        """,
        "one.py",
    )
    run = simulate([*pair, one], 1.2)
    heard = run.console.splitlines()
    assert [line for line in heard if line.startswith("one")] == ["one heard 100", "one heard 100"]
    assert [line for line in heard if line.startswith("listener")] == [
        f"listener heard {each}" for each in range(1, 12)
    ]
    assert run.status == 0


def test_one_that_ignores_ctrl_c_is_killed(pair: tuple[str, str], write: Any) -> None:
    deaf = write(
        "import signal, time, rclpy\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\ntime.sleep(100)\n", "deaf.py"
    )
    run = simulate([pair[1], deaf], 1)
    assert run.status == 137
    assert "did not end the node; it was killed 17 s later. The node ignores Ctrl-C: signal.signal(" in run.console


def fails() -> None:
    __import__("rclpy").init()
    sys.exit(3)


def test_several_run_as_the_ros_does_that_they_import_whatever_their_code_names(write: Any) -> None:
    run = simulate([lambda: timer(0.5), lambda: fails()], 1)
    assert run.status == 3 and run.console.startswith("rosspin: <lambda> ended with status 3\ntick\ntick\nTraceback")
    migrating = write("try:\n    import rclpy\nexcept ImportError:\n    import rospy\n" + TALKER, "migrating.py")
    run = simulate([Node(migrating, name="left"), Node(lambda: timer(0.5), name="right")], 1)
    assert {tick.source for tick in run.ticks} == {"/left <lambda>", "/right <lambda>"}
    assert run.status == 0 and "killing on exit" not in run.console


def test_only_roslaunch_starts_nodes_again(pair: tuple[str, str]) -> None:
    with pytest.raises(ValueError, match="required and respawn are for nodes of ROS 1 only"):
        simulate([Node(pair[0], respawn=True)], 1)
    with pytest.raises(ValueError, match="required and respawn are for nodes of ROS 1 only"):
        simulate([Node(lambda: timer(0.5), required=True)], 1)
