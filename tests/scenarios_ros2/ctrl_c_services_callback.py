"""Ctrl-C while a service's callback runs."""

import rclpy
from scenario import begin, block, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    try:
        block(9)
    finally:
        mark("over")
    return response


rclpy.init()
node = rclpy.create_node("ctrl_c_services_callback")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
future = client.call_async(Trigger.Request())
begin()
try:
    rclpy.spin_until_future_complete(node, future)
except KeyboardInterrupt:
    say("interrupted", future.done())
rclpy.try_shutdown()
