"""Ends at once when it is asked."""

import os

import rclpy
from scenario import say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    os._exit(3)


rclpy.init()
node = rclpy.create_node("server")
node.create_service(Trigger, "work", answer)
rclpy.spin(node)
