"""Ends its context while it is asked, and restarts when it is invited."""

import rclpy
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_srvs.srv import SetBool


def answer(request, response):
    asked.append(request.data)
    say("asked", request.data)
    if request.data:
        node.destroy_service(service)
        rclpy.shutdown()
        raise RuntimeError("no answer")
    response.message = "again"
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
service = node.create_service(SetBool, "switch", answer)
try:
    rclpy.spin(node)
except RuntimeError as error:
    say(error)
node.destroy_node()

rclpy.init()
node = rclpy.create_node("server")
wait_for_invitation(node)
service = node.create_service(SetBool, "switch", answer)
spin_until(node, lambda: False in asked)
spin_for(node, 1.0)
rclpy.shutdown()
