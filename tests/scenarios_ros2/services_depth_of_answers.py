"""Answers that wait for the client: as many as its depth, the newest."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import QoSProfile, qos_profile_services_default
from scenario import block, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    block(0.02)
    response.int32_value = request.int32_value
    return response


rclpy.init()
server = rclpy.create_node("server")
asker = rclpy.create_node("asker")
executors = [SingleThreadedExecutor() for _ in range(2)]
for executor, node in zip(executors, (server, asker)):
    executor.add_node(node)
server.create_service(BasicTypes, "work", answer, qos_profile=QoSProfile(depth=20))
for qos in (qos_profile_services_default, QoSProfile(depth=3), QoSProfile(depth=20)):
    client = asker.create_client(BasicTypes, "work", qos_profile=qos, callback_group=MutuallyExclusiveCallbackGroup())
    futures = [client.call_async(BasicTypes.Request(int32_value=number)) for number in range(15)]
    for executor in executors:
        for _ in range(45):
            executor.spin_once(timeout_sec=0.02)
    say(qos.depth, [future.result().int32_value for future in futures if future.done()])
    asker.destroy_client(client)
rclpy.shutdown()
