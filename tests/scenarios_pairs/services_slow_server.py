"""Takes the time that it is asked to."""

import time

import rclpy
from scenario import say, spin_for, spin_until
from test_msgs.srv import BasicTypes


def answer(request, response):
    time.sleep(request.float64_value)
    asked.append(request.float64_value)
    response.float64_value = request.float64_value
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
node.create_service(BasicTypes, "work", answer)
spin_until(node, lambda: len(asked) == 2)
spin_for(node, 1.0)
say(asked)
rclpy.shutdown()
