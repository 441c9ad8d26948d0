"""Nodes of ROS 2 in steps: their parameters, messages and errors."""

from __future__ import annotations

import math
import signal
import sys
import time
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from rosspin import start


def controller() -> None:
    """Answers on /command, in a period of its parameter, the last number that it has heard on /a."""
    import rclpy  # type: ignore[import-not-found]
    from geometry_msgs.msg import PointStamped, Twist
    from std_msgs.msg import UInt32

    def hear(heard: Any) -> None:
        numbers.append(heard.data)
        if heard.data == 13:
            raise ZeroDivisionError("thirteen")

    def tick() -> None:
        command = Twist()
        command.linear.x = float(numbers[-1])
        publisher.publish(command)

    numbers = [0]
    rclpy.init()
    node = rclpy.create_node("controller")
    names = node.declare_parameter("names", ["none"]).value
    period = node.declare_parameter("period", 0.5).value
    publisher = node.create_publisher(Twist, "command", 1)
    node.create_subscription(UInt32, "a", hear, 10)
    node.create_subscription(PointStamped, "point", lambda point: print(point.header.stamp.nanosec, point.point.x), 10)
    node.create_timer(period, tick)
    print(names, publisher.get_subscription_count())
    rclpy.spin(node)


def test_a_node_of_ros_2_is_connected_and_has_its_parameters() -> None:
    with start(controller, parameters={"period": 0.25, "names": ["a b", "yes"]}) as node:
        assert node.run.console == "['a b', 'yes'] 1\n"
        node.publish("a", 5)
        node.publish("point", header={"stamp": 0.25}, point={"x": 2.0})
        run = node.advance(0.5)
        assert run.console == "250000000 2.0\n"
        node.publish("/a", data=6)
        node.publish("a", node.message("std_msgs/UInt32", data=7))
        node.advance(0.25)
        node.publish("a", {"data": 8})
        node.publish("point", {"header": {"stamp": 0.5}, "point": {"x": 3.0}})
        assert node.advance(0.25).console == "500000000 3.0\n"
        assert [message.message.linear.x for message in node.messages("command")] == [5.0, 5.0, 7.0, 8.0]
        assert node.message("std_msgs/msg/UInt32") == node.message("std_msgs/UInt32", data=0)
    assert node.status == 128 + signal.SIGINT  # of the KeyboardInterrupt that it does not catch
    assert "KeyboardInterrupt" in node.run.console


@pytest.mark.parametrize(
    ("value", "name", "shown"),
    [
        (1e-7, "float", "1e-07"),
        (float("-inf"), "float", "-inf"),
        (3, "int", "3"),
        ("3", "str", "'3'"),
        ("a: 'b' \"c\"", "str", None),
        (True, "bool", "True"),
        ([1.5, 2e300], "list", "[1.5, 2e+300]"),
    ],
)
def test_a_parameter_of_ros_2_has_the_value_that_is_given(value: object, name: str, shown: str | None) -> None:
    def node() -> None:
        import rclpy

        rclpy.init()
        options = {"automatically_declare_parameters_from_overrides": True}
        found = rclpy.create_node("n", **options).get_parameter("value").value
        print(type(found).__name__ if name != "list" else "list", list(found) if name == "list" else repr(found))

    with start(node, parameters={"value": value}) as started:
        assert started.run.console == f"{name} {shown or repr(value)}\n"


def test_the_command_line_of_a_node_of_ros_2_goes_before_its_parameters() -> None:
    args = ["word", "--ros-args", "-p", "period:=0.125"]
    with start(controller, args, parameters={"period": 0.25}) as node:
        assert [tick.real for tick in node.advance(0.25).ticks] == [0.125, 0.25]


@pytest.mark.parametrize("value", [None, {"a": 1}, [1, None], object()])
def test_what_no_parameter_can_be_is_an_error(value: object) -> None:
    with pytest.raises(TypeError, match="the parameter period can be"):
        start(controller, parameters={"period": value})


@pytest.mark.parametrize("parameters", [[("period", 1)], "period:=1", 3])
def test_parameters_are_given_by_name(parameters: Any) -> None:
    with pytest.raises(TypeError, match="parameters are given by name, as in {'rate': 10.0}, not as "):
        start(controller, parameters=parameters)


def test_wrong_messages_to_a_node_of_ros_2_are_errors_and_do_nothing() -> None:
    with start(controller) as node:
        with pytest.raises(LookupError, match=r"no node subscribes to /b; .* /a \(std_msgs/msg/UInt32\)"):
            node.publish("b", 1)
        with pytest.raises(LookupError, match="no node publishes /a; published are: /command"):
            node.messages("a")
        with pytest.raises(LookupError, match="there is no message std_msgs/Nothing"):
            node.message("std_msgs/Nothing")
        with pytest.raises(AssertionError, match="Invalid arguments passed to constructor: date"):
            node.publish("a", date=1)
        with pytest.raises(AssertionError, match="must be an unsigned integer"):
            node.publish("a", -1)
        with pytest.raises(TypeError, match="UInt32 has the fields data"):
            node.publish("a", 1, 2)
        with pytest.raises(TypeError, match="Expected .*UInt32.*, got .*String"):
            node.publish("a", node.message("std_msgs/String"))
        node.advance(0.5)
        assert node.messages("command")[0].message.linear.x == 0


def asker() -> None:
    """Says what /drive is told; once a second asks /sum for 1 + 2, if it is there, and waits 0.5 s for it."""
    import rclpy
    from example_interfaces.srv import AddTwoInts  # type: ignore[import-not-found]
    from rclpy.callback_groups import ReentrantCallbackGroup  # type: ignore[import-not-found]
    from std_srvs.srv import SetBool  # type: ignore[import-not-found]

    def drive(request: Any, response: Any) -> Any:
        response.message = f"drives: {request.data}"
        return response

    def tick() -> None:
        if client.service_is_ready():
            answer = client.call(AddTwoInts.Request(a=1, b=2), timeout_sec=0.5)
            print(node.get_clock().now().nanoseconds, answer and answer.sum)

    rclpy.init()
    node = rclpy.create_node("asker")
    node.declare_parameter("period", 1.0)
    node.create_service(SetBool, "drive", drive)
    client = node.create_client(AddTwoInts, "sum")
    node.create_timer(1.0, tick, ReentrantCallbackGroup())
    rclpy.spin(node, rclpy.executors.MultiThreadedExecutor(2))


def test_a_service_of_ros_2_is_called_in_the_next_step() -> None:
    with start(asker) as node:
        node.call("drive", data=True)
        node.call("/drive", True)
        node.call("/drive", {"data": False})
        assert not node.run.calls
        run = node.advance(0)
        assert [call.response.message for call in run.calls] == ["drives: True", "drives: True", "drives: False"]
        assert {call[:3] + call[4:6] for call in run.calls} == {("/drive", "/tester", 0.0, "/asker", 0.0)}
        assert not node.advance(0.5).calls


def test_the_parameters_of_a_node_of_ros_2_can_be_asked_for() -> None:
    with start(asker) as node:
        node.call("/asker/set_parameters", parameters=[{"name": "period", "value": {"type": 3, "double_value": 0.5}}])
        node.call("/asker/get_parameters", names=["period"])
        set_, get = node.advance(0).calls
        assert set_.response.results[0].successful
        assert get.response.values[0].double_value == 0.5


def test_a_test_offers_a_service_of_ros_2() -> None:
    """Its function takes simulated time, for each request by itself, and may give no response."""
    waits = iter([0.25, 0.75, None, None])

    def add(request: Any) -> dict[str, Any] | None:
        wait = next(waits)
        time.sleep(wait or 0)
        return {"sum": request.a + request.b} if wait else None

    with start(asker) as node:
        node.serve("sum", "example_interfaces/srv/AddTwoInts", add)
        run = node.advance(4)
        assert run.console == "1250000000 3\n2500000000 None\n3500000000 None\n"
        first, second, third, _ = run.calls
        assert first[:3] + first[4:6] == ("/sum", "/asker", 1.0, "/tester", 1.25)
        assert (second.answered, second.response.sum) == (2.75, 3)
        assert math.isnan(third.answered)


def test_a_node_of_ros_2_that_waits_for_a_service_of_the_test_for_ever_is_ended() -> None:
    def waits() -> None:
        import rclpy
        from std_srvs.srv import Trigger

        rclpy.init()
        node = rclpy.create_node("waits")
        client = node.create_client(Trigger, "never")
        client.wait_for_service()
        rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))

    with start(waits) as node:
        node.serve("/never", "std_srvs/Trigger", lambda request: None)
        assert [call.asked for call in node.advance(1).calls] == [0.25]


@pytest.mark.parametrize("handler", [lambda request: 1 // 0, lambda request: 3, lambda request: {"sun": 3}])
def test_an_error_in_a_service_of_the_test_is_the_test_s(handler: Any) -> None:
    node = start(asker)
    node.serve("sum", "example_interfaces/AddTwoInts", handler)
    with pytest.raises((ZeroDivisionError, TypeError, AssertionError), match="zero|a dict of the response|sun"):
        node.advance(2)
    assert not node.run.console


def test_wrong_calls_to_a_node_of_ros_2_are_errors_and_do_nothing() -> None:
    with start(asker) as node:
        with pytest.raises(LookupError, match=r"no node offers /drvie; offered are: /drive \(std_srvs/srv/SetBool\)"):
            node.call("drvie", data=True)
        with pytest.raises(AssertionError, match="Invalid arguments passed to constructor: date"):
            node.call("drive", date=True)
        with pytest.raises(LookupError, match="there is no service std_srvs/Nothing in the common packages"):
            node.serve("drive", "std_srvs/Nothing", lambda request: None)
        with pytest.raises(LookupError, match="no node offers /drive/_action/send_goal"):
            node.send_goal("drive", order=3)
        node.serve("drive", "std_srvs/SetBool", lambda request: None)  # as well as the node's own
        node.call("drive", data=True)
        assert [call.server for call in node.advance(0.5).calls] == ["/asker"]


def test_a_goal_is_sent_to_an_action() -> None:
    def count() -> None:
        import rclpy
        from example_interfaces.action import Fibonacci  # type: ignore[import-not-found]
        from rclpy.action import ActionServer, GoalResponse  # type: ignore[import-not-found]

        def execute(goal: Any) -> Any:
            for number in range(goal.request.order):
                time.sleep(0.1)
                goal.publish_feedback(Fibonacci.Feedback(sequence=[number]))
            goal.succeed()
            return Fibonacci.Result(sequence=[goal.request.order])

        def accept(goal: Any) -> Any:
            return GoalResponse.ACCEPT if goal.order < 5 else GoalResponse.REJECT

        rclpy.init()
        node = rclpy.create_node("count")
        ActionServer(node, Fibonacci, "count", execute, goal_callback=accept)
        rclpy.spin(node)

    with start(count) as node:
        node.send_goal("count", order=3)
        accepted, result = node.advance(0.5).calls
        assert (accepted.service, accepted.answered) == ("/count/_action/send_goal", 0.0)
        assert (result.service, result.answered) == ("/count/_action/get_result", 0.3)
        assert list(result.response.result.sequence) == [3]
        feedback = node.messages("/count/_action/feedback")
        assert [(sent.time, list(sent.message.feedback.sequence)) for sent in feedback] == [
            (0.1, [0]),
            (0.2, [1]),
            (0.3, [2]),
        ]
        node.send_goal("/count", order=5)
        (refused,) = node.advance(0.5).calls
        assert not refused.response.accepted


def test_an_error_in_a_callback_of_ros_2_is_raised_and_ends_the_node() -> None:
    node = start(controller)
    node.publish("a", 13)
    with pytest.raises(ZeroDivisionError, match="thirteen"):
        node.advance(1)
    assert (node.time, node.status) == (0, 1)
    assert not node.advance(1).ticks
    node.close()


def test_what_it_imports_in_a_later_step_is_its_own(
    write: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Though the test, or an earlier one, has modules of these names."""
    for name in ("builtin_interfaces", "builtin_interfaces.msg", "helper_of_somebody"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    sys.modules["builtin_interfaces.msg"].Time = object  # type: ignore[attr-defined]
    sys.modules["helper_of_somebody"].__file__ = str(tmp_path / "elsewhere" / "helper_of_somebody.py")
    before = sys.modules["builtin_interfaces"]
    (tmp_path / "pkg").mkdir()
    write("whose = 'the node'\n", "pkg/helper_of_somebody.py")
    text = """
        import rclpy
        from std_msgs.msg import Header

        def callback():
            import helper_of_somebody

            header = Header(stamp=node.get_clock().now().to_msg())
            print(header.stamp.nanosec, helper_of_somebody.whose)

        rclpy.init()
        node = rclpy.create_node("node")
        node.create_timer(0.5, callback)
        rclpy.spin(node)
    """
    with start(write(text, "pkg/node.py")) as node:
        node.advance(0.1)
        node.advance(0.5)
        assert node.run.console == "500000000 the node\n"
        assert sys.modules["builtin_interfaces"] is before
