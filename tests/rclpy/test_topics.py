"""rclpy's topics: who receives what, in which order, and what is lost. Expected is what was measured on Jazzy."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from rosspin import Run, rclpy, simulate
from rosspin.rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor

Body = Callable[[Any, Any], object]


def run(body: Body, seconds: float = 10, *args: str) -> Run:
    """A node with the message UInt32 that does something and ends."""

    def node() -> None:
        from std_msgs.msg import UInt32

        rclpy.init()
        body(rclpy.create_node("node"), UInt32)
        rclpy.try_shutdown()

    return simulate(node, seconds, args)


def spin_until(node: Any, seconds: float, executor: Any = None) -> None:
    threading.Timer(seconds - time.time(), rclpy.shutdown).start()
    try:
        rclpy.spin(node, executor)
    except rclpy.exceptions.ExternalShutdownException:
        assert executor  # the one that rclpy makes is shut down with the context


def test_published_bytes_are_recorded_as_the_message_that_they_hold() -> None:
    seen: list[Any] = []

    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", 10)
        node.create_subscription(UInt32, "topic", lambda message: seen.append(message.data), 10)
        publisher.publish(b"\0\1\0\0\7\0\0\0")
        publisher.publish(b"no message")
        spin_until(node, 2)

    done = run(body)
    assert seen == [7]
    assert [message.message.data for message in done.messages] == [7]


def test_within_a_process_nothing_is_lost_and_only_spin_calls() -> None:
    seen: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", 10)
        node.create_subscription(UInt32, "topic", lambda message: seen.append(message.data), 10)
        for number in range(5):
            publisher.publish(UInt32(data=number))
        time.sleep(1)
        assert not seen
        spin_until(node, 2)

    done = run(body)
    assert (done.status, done.console) == (0, "")
    assert seen == [0, 1, 2, 3, 4]
    assert [(message.topic, message.node, message.time, message.message.data) for message in done.messages] == [
        ("/topic", "/node", 0.0, number) for number in range(5)
    ]


def slow_callback(depth: int) -> list[int]:
    seen: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        def callback(message: Any) -> None:
            seen.append(message.data)
            time.sleep(0.8)

        publisher = node.create_publisher(UInt32, "topic", 10)
        node.create_subscription(UInt32, "topic", callback, depth)

        def publish() -> None:
            for number in range(30):
                publisher.publish(UInt32(data=number))
                time.sleep(0.1)

        threading.Thread(target=publish, daemon=True).start()
        spin_until(node, 20)

    assert run(body, 30).status == 0
    return seen


@pytest.mark.parametrize(
    ("depth", "seen"),
    [
        (1, [0, 8, 16, 24, 29]),
        (3, [0, 6, 14, 22, 27, 28, 29]),
        (10, [0, 1, 7, 15, *range(20, 30)]),
    ],
)
def test_the_newest_are_kept_and_the_oldest_of_them_is_given(depth: int, seen: list[int]) -> None:
    assert slow_callback(depth) == seen


def test_a_round_takes_timers_first_then_one_message_of_each() -> None:
    order: list[str] = []

    def body(node: Any, UInt32: Any) -> None:
        publishers = [node.create_publisher(UInt32, topic, 10) for topic in "ab"]
        for topic in "ab":
            node.create_subscription(UInt32, topic, lambda m, topic=topic: order.append(f"{topic}{m.data}"), 10)
        for number in range(2):
            for publisher in publishers:
                publisher.publish(UInt32(data=number))

        def callback() -> None:
            order.append("T")
            time.sleep(0.5)

        node.create_timer(0.5, callback)
        time.sleep(0.7)
        spin_until(node, 2)

    run(body)
    assert order[:6] == ["T", "a0", "b0", "T", "a1", "b1"]


@pytest.mark.parametrize(("depth", "seen"), [(3, [7, 8, 9]), (1, [9]), (0, [])])
def test_who_comes_late_is_given_what_is_kept(depth: int, seen: list[int]) -> None:
    received: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        qos = rclpy.qos
        durability = qos.DurabilityPolicy.TRANSIENT_LOCAL if depth else qos.DurabilityPolicy.VOLATILE
        profile = qos.QoSProfile(depth=depth or 5, durability=durability)
        publisher = node.create_publisher(UInt32, "topic", profile)
        for number in range(10):
            publisher.publish(UInt32(data=number))
        node.create_subscription(UInt32, "topic", lambda message: received.append(message.data), profile)
        spin_until(node, 1)

    assert run(body).status == 0
    assert received == seen


def test_ends_that_do_not_match_say_so_when_they_are_spun() -> None:
    def body(node: Any, UInt32: Any) -> None:
        qos = rclpy.qos
        best = qos.QoSProfile(depth=1, reliability=qos.ReliabilityPolicy.BEST_EFFORT)
        publisher = node.create_publisher(UInt32, "topic", best)
        subscription = node.create_subscription(UInt32, "topic", print, 1)
        assert (publisher.get_subscription_count(), subscription.get_publisher_count()) == (0, 0)
        publisher.publish(UInt32())
        time.sleep(1)
        spin_until(node, 2)

    assert run(body).console == (
        "[WARN] [1.000000000] [node]: New subscription discovered on topic 'topic', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: RELIABILITY\n"
        "[WARN] [1.000000000] [node]: New publisher discovered on topic 'topic', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: RELIABILITY\n"
    )


def test_a_message_is_a_copy_of_what_was_published() -> None:
    seen: list[Any] = []

    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", 10)
        node.create_subscription(UInt32, "topic", seen.append, 10)
        node.create_subscription(UInt32, "topic", lambda message, info: seen.append(sorted(info)), 10)
        message = UInt32(data=1)
        publisher.publish(message)
        message.data = 2
        seen.append(message)
        spin_until(node, 1)

    run(body)
    sent, received, info = seen
    assert (sent.data, received.data) == (2, 1)
    assert info[0] == "publication_sequence_number"


def test_what_topics_refuse() -> None:
    def body(node: Any, UInt32: Any) -> None:
        from std_msgs.msg import String

        def refused(error: type[Exception], text: str, do: Callable[[], object]) -> None:
            with pytest.raises(error, match=text):
                do()

        RCLError = rclpy.exceptions.RCLError
        publisher = node.create_publisher(UInt32, "topic", 10)
        refused(
            TypeError,
            r"Expected <class 'std_msgs.msg._u_int32.UInt32'>, got <class 'int'>",
            lambda: publisher.publish(5),
        )
        refused(TypeError, "Expected QoSProfile or int, but", lambda: node.create_publisher(UInt32, "topic", "x"))
        refused(ValueError, "history depth must be greater", lambda: node.create_publisher(UInt32, "topic", -1))
        refused(AttributeError, "This might be a ROS 1 message type", lambda: node.create_publisher(int, "topic", 1))
        refused(
            RuntimeError, "callable with one argument", lambda: node.create_subscription(UInt32, "topic", lambda: 0, 1)
        )
        refused(
            RCLError,
            "existing topic name rt/topic with incompatible",
            lambda: node.create_publisher(String, "topic", 1),
        )
        other = node.create_publisher(UInt32, "topic", 10)
        assert (node.count_publishers("topic"), node.destroy_publisher(other), node.count_publishers("topic")) == (
            2,
            True,
            1,
        )
        refused(rclpy.exceptions.InvalidHandle, "destruction was requested", lambda: other.publish(UInt32()))
        rclpy.shutdown()
        refused(RCLError, "publisher's context is invalid", lambda: publisher.publish(UInt32()))

    done = run(body)
    assert (done.status, done.console) == (0, "")


def test_wait_for_message() -> None:
    found: list[Any] = []

    def body(node: Any, UInt32: Any) -> None:
        wait = rclpy.topics.wait_for_message
        found.append((*wait(UInt32, node, "topic", time_to_wait=0.3), time.time()))
        publisher = node.create_publisher(UInt32, "topic", 10)
        threading.Timer(0.5, lambda: publisher.publish(UInt32(data=7))).start()
        there, message = wait(UInt32, node, "topic")
        found.append((there, getattr(message, "data", None), time.time()))

    assert run(body).status == 0
    assert found == [(False, None, 0.3), (True, 7, 0.8)]


@pytest.mark.parametrize("executor", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_the_executor_that_spins_meanwhile_leaves_the_message_to_the_one_who_waits(executor: Any) -> None:
    found: list[Any] = []

    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", 10)
        node.create_timer(0.5, lambda: publisher.publish(UInt32(data=7)))
        spinner = executor()
        spinner.add_node(node)
        threading.Thread(target=spinner.spin, daemon=True).start()
        for seconds in (0.3, 2, -1):
            there, message = rclpy.topics.wait_for_message(UInt32, node, "topic", time_to_wait=seconds)
            found.append((there, getattr(message, "data", None), time.time()))

    assert run(body).status == 0
    assert found == [(False, None, 0.3), (True, 7, 0.5), (True, 7, 1.0)]


def test_a_message_of_the_instant_in_which_a_callback_ends_has_arrived() -> None:
    assert slow_callback(1)[1] == 8


@pytest.mark.parametrize(("end", "expected"), [(2.5, []), (4.0, [100.0, 101.0, 102.0, 103.0, 104.0])])
def test_the_clock_of_a_topic_drives_timers(end: float, expected: list[float]) -> None:
    """With use_sim_time nothing ticks until /clock says something; then timers go by it."""
    ticks: list[float] = []

    def body(node: Any, UInt32: Any) -> None:
        from builtin_interfaces.msg import Time
        from rosgraph_msgs.msg import Clock

        teller = node.create_publisher(Clock, "/clock", 10)
        node.create_timer(1.0, lambda: ticks.append(node.get_clock().now().nanoseconds / 1e9))

        def tell() -> None:
            time.sleep(3)
            for second in range(5):
                teller.publish(Clock(clock=Time(sec=100 + second)))
                time.sleep(0.1)

        threading.Thread(target=tell, daemon=True).start()
        spin_until(node, end)

    assert run(body, 10, "--ros-args", "-p", "use_sim_time:=true").status == 0
    assert ticks == expected


def test_several_nodes_in_one_process() -> None:
    seen: list[tuple[str, int]] = []

    def body(node: Any, UInt32: Any) -> None:
        other = rclpy.create_node("other", namespace="ns")
        publisher = other.create_publisher(UInt32, "/topic", 10)
        node.create_subscription(UInt32, "topic", lambda message: seen.append(("node", message.data)), 10)
        other.create_timer(0.5, lambda: publisher.publish(UInt32(data=len(seen))))
        executor = rclpy.executors.SingleThreadedExecutor()
        executor.add_node(node)
        assert sorted(node.get_fully_qualified_node_names()) == ["/node", "/ns/other"]
        assert dict(node.get_topic_names_and_types())["/topic"] == ["std_msgs/msg/UInt32"]
        spin_until(other, 1.7, executor)

    done = run(body)
    assert (done.status, done.console) == (0, "")
    assert seen == [("node", 0), ("node", 1), ("node", 2)]
    assert [message.node for message in done.messages] == ["/ns/other"] * 3


def test_a_depth_of_0_keeps_one_message() -> None:
    seen: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        with pytest.warns(UserWarning, match="A zero depth with KEEP_LAST doesn't make sense"):
            node.create_subscription(UInt32, "topic", lambda message: seen.append(message.data), 0)
        publisher = node.create_publisher(UInt32, "topic", 10)
        for number in (1, 2):
            publisher.publish(UInt32(data=number))
        spin_until(node, 1)

    run(body)
    assert seen == [2]


def test_each_subscription_has_a_copy_of_its_own() -> None:
    seen: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        def callback(message: Any) -> None:
            message.data += 1
            seen.append(message.data)

        for _ in range(2):
            node.create_subscription(UInt32, "topic", callback, 10)
        node.create_publisher(UInt32, "topic", 10).publish(UInt32(data=1))
        spin_until(node, 1)

    run(body)
    assert seen == [2, 2]


def test_what_was_logged_before_is_kept_on_rosout_for_those_who_ask_for_it(write: Any) -> None:
    """As on the real one, which has kept the same lines."""
    node = write("""
        import time
        import rclpy
        from rcl_interfaces.msg import Log
        from rclpy.qos import DurabilityPolicy, QoSProfile

        rclpy.init()
        first, quiet = rclpy.create_node("first"), rclpy.create_node("quiet", enable_rosout=False)
        gone = rclpy.create_node("gone")
        for each in (first, quiet, gone, first):
            each.get_logger().info("early")
        gone.destroy_node()
        time.sleep(0.5)
        node = rclpy.create_node("node")
        kept = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for who, qos in (("volatile", 10), ("late", kept)):
            def hear(message, who=who):
                print(who, message.name, message.msg, message.line, message.stamp.nanosec)

            node.create_subscription(Log, "/rosout", hear, qos)
        for _ in range(5):
            rclpy.spin_once(node, timeout_sec=0.1)
    """)
    heard = [line for line in simulate(node, 5).console.splitlines() if not line.startswith("[")]
    assert heard == ["late first early 11 0"] * 2
