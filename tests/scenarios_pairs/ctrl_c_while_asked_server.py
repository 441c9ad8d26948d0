"""Ctrl-C while its callback runs, for 30 s."""

import time

import rclpy
from scenario import say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    try:
        time.sleep(30)
    finally:
        say("over")
    return response


rclpy.init()
node = rclpy.create_node("server")
node.create_service(Trigger, "work", answer)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    say("interrupted")
