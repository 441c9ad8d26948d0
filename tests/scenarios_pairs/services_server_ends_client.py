"""Sees the server go with a request unanswered, and come again."""

import rclpy
from scenario import invite, say, spin_for, spin_until
from std_srvs.srv import SetBool

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(SetBool, "switch")
say(client.wait_for_service())
lost = client.call_async(SetBool.Request(data=True))
say(spin_until(node, lambda: not client.service_is_ready()), lost.done())
say(node.count_services("switch"), client.wait_for_service(0.1))
invite(node)
say(client.wait_for_service())
future = client.call_async(SetBool.Request(data=False))
rclpy.spin_until_future_complete(node, future)
say(lost.done(), future.result().message)
spin_for(node, 0.5)
rclpy.shutdown()
