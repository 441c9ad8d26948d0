"""Who asks and who answers publish what they do: nothing, that it was done, or what was said."""

import rclpy
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from scenario import say
from test_msgs.srv import BasicTypes

OFF, METADATA, CONTENTS = ServiceIntrospectionState.__members__.values()


def answer(request, response):
    response.int32_value = request.int32_value + 1
    return response


rclpy.init()
node = rclpy.create_node("service_introspection")
service = node.create_service(BasicTypes, "add", answer)
client = node.create_client(BasicTypes, "add")
client.wait_for_service()
events = []
node.create_subscription(BasicTypes.Event, "add/_service_event", events.append, 100)
for states in ((OFF, OFF), (METADATA, METADATA), (OFF, CONTENTS), (CONTENTS, OFF), (CONTENTS, METADATA), (OFF, OFF)):
    for end, state in zip((client, service), states, strict=True):
        say(end.configure_introspection(node.get_clock(), qos_profile_system_default, state))
    wanted = sum(state is not OFF for state in states)
    while node.count_publishers("/add/_service_event") != wanted:
        rclpy.spin_once(node, timeout_sec=0.05)
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0.05)
    before = node.get_clock().now().to_msg()
    future = client.call_async(BasicTypes.Request(int32_value=3, string_value="a"))
    rclpy.spin_until_future_complete(node, future)
    for _ in range(8):
        rclpy.spin_once(node, timeout_sec=0.05)
    say(*states, wanted, [publisher.topic for publisher in node.publishers])
    for event in sorted(events, key=lambda event: event.info.event_type):
        info = event.info
        say("  ", info.event_type, info.sequence_number, len(info.client_gid), 0 <= info.stamp.sec - before.sec < 3)
        say("    ", event.request, event.response)
    if len(events) == 4:
        gids = [tuple(event.info.client_gid) for event in sorted(events, key=lambda event: event.info.event_type)]
        say(gids[0] == gids[3], gids[1] == gids[2])
    events.clear()
rclpy.shutdown()
