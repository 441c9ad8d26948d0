"""Asks a service that has another type there: it is never ready, and both types are known."""

import rclpy
from scenario import invite, say, spin_for, spin_until
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("client", start_parameter_services=False)
client = node.create_client(Trigger, "work")
say(spin_until(node, lambda: node.count_services("work") == 1))
spin_for(node, 0.5)
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
say(future.done(), client.service_is_ready())
say([entry for entry in node.get_service_names_and_types() if entry[0] == "/work"])
invite(node)
rclpy.shutdown()
