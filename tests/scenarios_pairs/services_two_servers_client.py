"""Asks a service that two processes offer: the first answer counts, the other one is dropped."""

import rclpy
from scenario import begin, invite, mark, say, spin_for, spin_until
from test_msgs.srv import BasicTypes

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(BasicTypes, "work")
say(spin_until(node, lambda: node.count_services("work") == 2))
spin_for(node, 1.0)
for number in range(2):
    begin()
    future = client.call_async(BasicTypes.Request(int32_value=number))
    rclpy.spin_until_future_complete(node, future)
    mark("answered")
    say(future.result().string_value)
    spin_for(node, 1.0)
invite(node, guests=2)
rclpy.shutdown()
