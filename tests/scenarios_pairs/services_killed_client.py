"""A server that was killed still counts as ready: it is not said to be gone, and no answer comes."""

import rclpy
from scenario import say, spin_until
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(Trigger, "work")
say(client.wait_for_service())
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
say(future.done(), client.service_is_ready())
say(spin_until(node, lambda: not client.service_is_ready()), future.done())
rclpy.shutdown()
