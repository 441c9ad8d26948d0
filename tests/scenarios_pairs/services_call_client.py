"""Waits for a service of another process and asks it three times; each answer comes at once."""

import rclpy
from scenario import begin, mark, say
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(BasicTypes, "double")
say(client.wait_for_service())
for number in (1, 2, 0):
    begin()
    future = client.call_async(BasicTypes.Request(int32_value=number))
    rclpy.spin_until_future_complete(node, future)
    mark("answered")
    say(future.result().int32_value, future.result().string_value)
rclpy.shutdown()
