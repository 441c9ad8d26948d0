"""wait_for_service looks every 0.25 s; the timeout counts these looks."""

import rclpy
from scenario import after, begin, mark, say
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("services_wait")
client = node.create_client(Trigger, "work")
begin()
for timeout in (0, -1, 0.3, 0.5):
    say(timeout, client.wait_for_service(timeout_sec=timeout))
    mark("waited")
after(3.8, lambda: node.create_service(Trigger, "work", print))
say(client.wait_for_service())
mark("waited")
say(client.wait_for_service(timeout_sec=5), client.wait_for_service(0))
mark("waited")
rclpy.shutdown()
