"""Asks three times, and gets the answers to its own requests."""

import rclpy
from scenario import say, spin_until
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("left")
client = node.create_client(BasicTypes, "work")
say(client.wait_for_service())
futures = [client.call_async(BasicTypes.Request(int32_value=1 + number)) for number in range(3)]
say(spin_until(node, lambda: all(future.done() for future in futures)))
say([future.result().int32_value for future in futures])
rclpy.shutdown()
