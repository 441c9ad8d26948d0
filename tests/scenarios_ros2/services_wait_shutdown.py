"""rclpy.shutdown() ends the wait for a service: what it says then."""

import rclpy
from scenario import after, attempt, begin, mark
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("services_wait_shutdown")
client = node.create_client(Trigger, "work")
begin()
after(1.5, rclpy.shutdown)
attempt("client.wait_for_service()", {"client": client})
mark("waited")
attempt("client.wait_for_service(1)", {"client": client})
mark("waited")
