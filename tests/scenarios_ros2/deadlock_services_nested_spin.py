"""spin_until_future_complete in a callback: the answer waits for the callback's group. Ctrl-C ends it."""

import rclpy
from scenario import P, begin, mark
from std_srvs.srv import Trigger


def ask():
    mark("asks")
    future = client.call_async(Trigger.Request())
    try:
        rclpy.spin_until_future_complete(node, future)
    finally:
        mark("over")


rclpy.init()
node = rclpy.create_node("deadlock_services_nested_spin")
node.create_service(Trigger, "work", lambda request, response: response)
client = node.create_client(Trigger, "work")
begin()
node.create_timer(P, ask)
rclpy.spin(node)
