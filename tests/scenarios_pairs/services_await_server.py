"""Answers after a second."""

import time

import rclpy
from scenario import spin_for, spin_until
from std_srvs.srv import Trigger


def answer(request, response):
    time.sleep(1.0)
    asked.append(request)
    response.message = "done"
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
node.create_service(Trigger, "work", answer)
spin_until(node, lambda: asked)
spin_for(node, 1.0)
rclpy.shutdown()
