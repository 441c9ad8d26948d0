"""More requests than the queue of the service takes: which are answered, by depth; the same for answers."""

import rclpy
from rclpy.qos import HistoryPolicy, QoSProfile, qos_profile_services_default
from scenario import block, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    asked.append(request.int32_value)
    response.int32_value = request.int32_value
    return response


rclpy.init()
node = rclpy.create_node("services_depth")
for name, of_service, of_client in (
    ("default", qos_profile_services_default, qos_profile_services_default),
    ("two", QoSProfile(depth=2), qos_profile_services_default),
    ("client_two", qos_profile_services_default, QoSProfile(depth=2)),
    ("all", QoSProfile(history=HistoryPolicy.KEEP_ALL), QoSProfile(history=HistoryPolicy.KEEP_ALL)),
):
    asked = []
    service = node.create_service(BasicTypes, name, answer, qos_profile=of_service)
    client = node.create_client(BasicTypes, name, qos_profile=of_client)
    futures = []
    for number in range(15):
        futures.append(client.call_async(BasicTypes.Request(int32_value=number)))
        block(0.02)
    for _ in range(60):
        rclpy.spin_once(node, timeout_sec=0.02)
    say(name, asked, [future.result().int32_value for future in futures if future.done()])
    node.destroy_service(service)
    node.destroy_client(client)
rclpy.shutdown()
