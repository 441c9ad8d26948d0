"""Asks, and ends before the answer comes."""

import rclpy
from scenario import say, wait_for_invitation
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(Trigger, "slow")
say(client.wait_for_service())
future = client.call_async(Trigger.Request())
wait_for_invitation(node)
say(future.done())
rclpy.shutdown()
