"""Ctrl-C while it waits for the answer."""

import rclpy
from scenario import say
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(Trigger, "work")
client.wait_for_service()
say("asks")
try:
    rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
except KeyboardInterrupt:
    say("interrupted")
