"""Ctrl-C in wait_for_service."""

import rclpy
from scenario import begin, mark
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("ctrl_c_services_wait")
client = node.create_client(Trigger, "nobodys")
begin()
try:
    client.wait_for_service()
finally:
    mark("over")
