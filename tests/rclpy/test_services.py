"""rclpy's services: what the scenarios cannot say, of a run's record, of processes, and of what is never asked for."""

from __future__ import annotations

import math
import time
from typing import Any

import pytest

from rosspin import rclpy, simulate


def server() -> None:
    from test_msgs.srv import BasicTypes  # type: ignore[import-not-found]

    def answer(request: Any, response: Any) -> Any:
        time.sleep(0.5)
        response.int32_value = 2 * request.int32_value
        return response

    rclpy.init()
    node = rclpy.create_node("server")
    node.create_service(BasicTypes, "double", answer)
    rclpy.spin(node)


def client() -> None:
    from test_msgs.srv import BasicTypes

    rclpy.init()
    node = rclpy.create_node("client", namespace="ns")
    asker = node.create_client(BasicTypes, "/double")
    asker.call_async(BasicTypes.Request(int32_value=-1))
    assert asker.wait_for_service()
    for number in range(2):
        rclpy.spin_until_future_complete(node, asker.call_async(BasicTypes.Request(int32_value=number)))
    rclpy.shutdown()


def test_a_run_has_the_calls() -> None:
    calls = simulate([server, client], 5).calls
    assert [call[:3] for call in calls] == [("/double", "/ns/client", asked) for asked in (0.0, 0.25, 0.75)]
    assert [call.request.int32_value for call in calls] == [-1, 0, 1]
    lost, *others = calls
    assert lost.server == "" and math.isnan(lost.answered) and lost.response is None
    assert [(call.server, call.answered, call.response.int32_value) for call in others] == [
        ("/server", 0.75, 0),
        ("/server", 1.25, 2),
    ]


def test_of_two_answers_the_first_counts() -> None:
    call = simulate([server, server, client], 5).calls[1]
    assert (call.server, call.answered) == ("/server", 0.75)


def test_the_same_run_gives_the_same_calls() -> None:
    one, other = ([repr(call) for call in simulate([server, client, client], 5).calls] for _ in range(2))
    assert one == other and len(one) == 6


def test_calls_in_a_process_take_no_time() -> None:
    def node() -> None:
        from std_srvs.srv import Trigger  # type: ignore[import-not-found]

        rclpy.init()
        node = rclpy.create_node("node")
        node.create_service(Trigger, "work", lambda request, response: response)
        asker = node.create_client(Trigger, "work")
        for _ in range(10):
            rclpy.spin_until_future_complete(node, asker.call_async(Trigger.Request()))
        rclpy.shutdown()

    assert {(call.asked, call.answered) for call in simulate(node, 1).calls} == {(0.0, 0.0)}


def test_a_node_has_services_for_its_parameters_once_somebody_looks() -> None:
    counts: list[int] = []

    def node() -> None:
        from rcl_interfaces.srv import GetParameters  # type: ignore[import-not-found]

        rclpy.init()
        nodes = [rclpy.create_node(name) for name in ("asked", "shown", "plain")]
        early = nodes[2].create_client(GetParameters, "late/get_parameters")
        nodes[2].create_client(GetParameters, "asked/get_parameters")
        assert len(list(nodes[1].services)) == 6
        nodes.append(rclpy.create_node("late"))
        assert early.service_is_ready()
        counts.extend(len(node._services) for node in nodes)

    assert simulate(node, 1).console == ""
    assert counts == [6, 6, 0, 6]


def test_what_has_ended_is_found_by_nobody() -> None:
    def look(node: Any) -> list[Any]:
        from std_msgs.msg import UInt32
        from std_srvs.srv import Trigger

        asker, publisher = node.create_client(Trigger, "work"), node.create_publisher(UInt32, "topic", 10)
        time.sleep(1)
        found = [asker.service_is_ready(), publisher.get_subscription_count()]
        return [*found, node.destroy_client(asker), node.destroy_publisher(publisher)]

    def ends() -> None:
        from std_msgs.msg import UInt32
        from std_srvs.srv import Trigger

        rclpy.init()
        node = rclpy.create_node("ends")
        node.create_service(Trigger, "work", print)
        node.create_subscription(UInt32, "topic", print, 10)
        rclpy.shutdown()
        rclpy.init()
        print(look(rclpy.create_node("again")))

    def comes_later() -> None:
        rclpy.init()
        time.sleep(1)
        print(look(rclpy.create_node("later")))

    assert simulate([ends, comes_later], 5).console == "[False, 0, True, True]\n" * 2


def test_messages_that_hold_others_reach_another_process() -> None:
    def talker() -> None:
        from geometry_msgs.msg import PoseStamped
        from nav_msgs.msg import Path

        rclpy.init()
        node = rclpy.create_node("talker")
        publisher = node.create_publisher(Path, "path", 10)
        node.create_timer(1.0, lambda: publisher.publish(Path(poses=[PoseStamped()])))
        rclpy.spin(node)

    def listener() -> None:
        from nav_msgs.msg import Path

        rclpy.init()
        node = rclpy.create_node("listener")
        node.create_subscription(Path, "path", lambda message: print(len(message.poses), message.header.frame_id), 10)
        rclpy.spin(node)

    assert simulate([talker, listener], 1.5).console.startswith("1 \nTraceback")


@pytest.mark.parametrize("check", ["validate_topic_name", "validate_full_topic_name"])
def test_names_of_services_are_checked_as_such(check: str) -> None:
    with pytest.raises(
        rclpy.exceptions.InvalidServiceNameException, match="^Invalid service name: topic name must not"
    ):
        getattr(rclpy.names, check)("/a b", is_service=True)
