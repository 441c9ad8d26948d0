"""call() in a callback of rclpy.spin(): the answer could only come after the callback. Ctrl-C ends it."""

import rclpy
from scenario import P, begin, mark
from std_srvs.srv import Trigger


def ask():
    mark("asks")
    client.call(Trigger.Request())
    mark("answered")


rclpy.init()
node = rclpy.create_node("deadlock_services_call")
node.create_service(Trigger, "work", lambda request, response: response)
client = node.create_client(Trigger, "work")
begin()
node.create_timer(P, ask)
rclpy.spin(node)
