"""Ctrl-C in spin_until_future_complete, with an answer that never comes."""

import rclpy
from scenario import begin, mark
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("ctrl_c_services_future")
client = node.create_client(Trigger, "nobodys")
begin()
try:
    rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
finally:
    mark("over")
