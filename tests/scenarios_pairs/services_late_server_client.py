"""Asks before the server is there, in vain; once it is known, it answers."""

import rclpy
from scenario import begin, invite, mark, say, spin_for, spin_until
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(Trigger, "late")
lost = client.call_async(Trigger.Request())
say(client.service_is_ready(), client.wait_for_service(0.5))
invite(node)
say(spin_until(node, client.service_is_ready))
begin()
say(client.wait_for_service(1.0))
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future)
mark("answered")
spin_for(node, 0.5)
say(lost.done(), future.result().message)
rclpy.shutdown()
