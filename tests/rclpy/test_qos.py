"""rclpy's QoS: what is exact only in simulated time, and what no scenario can hold."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from importlib import import_module
from typing import Any

import pytest

from rosspin import Run, rclpy, simulate
from rosspin.rclpy.duration import Duration
from rosspin.rclpy.event_handler import (
    EventHandler,
    PublisherEventCallbacks,
    QoSEventHandler,
    QoSPublisherEventType,
    SubscriptionEventCallbacks,
    UnsupportedEventTypeError,
)
from rosspin.rclpy.exceptions import RCLError
from rosspin.rclpy.qos import LivelinessPolicy, QoSPolicyKind, QoSProfile, qos_policy_name_from_kind

SECOND = Duration(seconds=1)


def run(body: Callable[[Any, Any], object], seconds: float = 10) -> Run:
    """A node with the message UInt32 that does something, and spins."""

    def node() -> None:
        from std_msgs.msg import UInt32

        rclpy.init()
        node = rclpy.create_node("node")
        body(node, UInt32)
        threading.Timer(seconds - 1, rclpy.shutdown).start()
        rclpy.spin(node)

    done = simulate(node, seconds)
    assert (done.status, done.console) == (0, "")
    return done


def at(seconds: float, function: Callable[[], object]) -> None:
    threading.Timer(seconds, function).start()


def test_deadlines_are_missed_a_period_after_the_last_message_and_each_period_after_that() -> None:
    missed: list[tuple[str, float, int]] = []

    def body(node: Any, UInt32: Any) -> None:
        def note(who: str) -> Callable[[Any], None]:
            return lambda event: missed.append((who, time.time(), event.total_count))

        publisher = node.create_publisher(
            UInt32,
            "topic",
            QoSProfile(depth=1, deadline=SECOND),
            event_callbacks=PublisherEventCallbacks(deadline=note("publisher")),
        )
        node.create_subscription(
            UInt32,
            "topic",
            lambda message: None,
            QoSProfile(depth=1, deadline=Duration(seconds=1.5)),
            event_callbacks=SubscriptionEventCallbacks(deadline=note("subscription")),
        )
        at(1.25, lambda: publisher.publish(UInt32()))
        at(3.5, lambda: publisher.publish(UInt32()))

    run(body, 6.25)
    assert missed == [
        *(("publisher", 2.25, 1), ("subscription", 2.75, 1), ("publisher", 3.25, 2)),
        *(("publisher", 4.5, 3), ("subscription", 5.0, 2)),
    ]


@pytest.mark.parametrize(("age", "seen"), [(0.999, [7]), (1.0, [])])
def test_a_message_as_old_as_its_lifespan_is_gone(age: float, seen: list[int]) -> None:
    received: list[int] = []

    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", 1)
        profile = QoSProfile(depth=1, lifespan=SECOND)
        node.create_subscription(UInt32, "topic", lambda message: received.append(message.data), profile)
        publisher.publish(UInt32(data=7))
        time.sleep(age)

    run(body)
    assert received == seen


def test_a_lease_runs_out_after_the_last_sign_of_life() -> None:
    heard: list[tuple[float, int, int]] = []

    def body(node: Any, UInt32: Any) -> None:
        profile = QoSProfile(
            depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=1)
        )
        publisher = node.create_publisher(UInt32, "topic", profile)
        events = SubscriptionEventCallbacks(
            liveliness=lambda event: heard.append((time.time(), event.alive_count, event.not_alive_count))
        )
        node.create_subscription(UInt32, "topic", lambda message: None, profile, event_callbacks=events)
        at(1.0, publisher.assert_liveliness)
        at(1.75, lambda: publisher.publish(UInt32()))
        at(4.0, lambda: node.destroy_publisher(publisher))

    run(body)
    assert heard == [(1.0, 1, 0), (2.75, 0, 1), (4.0, 0, 0)]


def test_executors_do_not_look_at_events_of_which_nobody_asked() -> None:
    def body(node: Any, UInt32: Any) -> None:
        publisher = node.create_publisher(UInt32, "topic", QoSProfile(depth=1, deadline=SECOND, lifespan=SECOND))
        node.create_subscription(UInt32, "topic", lambda message: None, 1)
        publisher.publish(UInt32())
        assert len(publisher.event_handlers) == 2
        assert node._rosspin_waitables == []

    run(body)


def test_a_topic_that_was_left_tells_nothing() -> None:
    told: list[Any] = []

    def body(node: Any, UInt32: Any) -> None:
        events = PublisherEventCallbacks(matched=told.append, deadline=told.append)
        profile = QoSProfile(depth=1, deadline=SECOND)
        publisher = node.create_publisher(UInt32, "topic", profile, event_callbacks=events)
        publisher.publish(UInt32())
        node.create_subscription(UInt32, "topic", lambda message: None, 1)
        node.destroy_publisher(publisher)
        left = [each.event_handlers for each in (*node.publishers, *node.subscriptions)]
        assert list(node.waitables) == [handler for handlers in left for handler in handlers]

    run(body)
    assert told == []


def test_the_names_of_events_are_those_of_rclpy() -> None:
    assert issubclass(UnsupportedEventTypeError, RCLError)
    assert qos_policy_name_from_kind(QoSPolicyKind.DEADLINE.value) == "DEADLINE"
    with pytest.raises(ValueError, match="3 is not a valid"):
        qos_policy_name_from_kind(3)

    def body(node: Any, UInt32: Any) -> None:
        assert import_module("rclpy.constants").S_TO_NS == 10**9
        assert import_module("rclpy.qos_event").EventHandler is EventHandler
        publisher = node.create_publisher(UInt32, "topic", 1)
        with pytest.warns(DeprecationWarning, match="use EventHandler instead"):
            QoSEventHandler(
                callback_group=node.default_callback_group,
                callback=lambda event: None,
                event_type=QoSPublisherEventType.RCL_PUBLISHER_MATCHED,
                parent_impl=publisher,
            )

    run(body)
