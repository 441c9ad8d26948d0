"""Offers its service when it is invited."""

import rclpy
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_srvs.srv import Trigger


def answer(request, response):
    asked.append(request)
    say("asked")
    response.message = "here I am"
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
wait_for_invitation(node)
node.create_service(Trigger, "late", answer)
spin_until(node, lambda: asked)
spin_for(node, 1.0)
say(len(asked))
rclpy.shutdown()
