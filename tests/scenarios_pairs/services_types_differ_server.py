"""Offers the service with its own type; it is never asked."""

import rclpy
from scenario import say, wait_for_invitation
from std_srvs.srv import Empty

rclpy.init()
node = rclpy.create_node("server", start_parameter_services=False)
service = node.create_service(Empty, "work", lambda request, response: say("asked"))
wait_for_invitation(node)
rclpy.shutdown()
