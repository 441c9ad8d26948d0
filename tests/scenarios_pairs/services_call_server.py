"""Answers each number with its double until it is 0."""

import rclpy
from scenario import say, spin_for, spin_until
from test_msgs.srv import BasicTypes


def answer(request, response):
    asked.append(request.int32_value)
    say("asked", request.int32_value)
    response.int32_value = 2 * request.int32_value
    response.string_value = node.get_name()
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
node.create_service(BasicTypes, "double", answer)
spin_until(node, lambda: 0 in asked)
spin_for(node, 0.5)
rclpy.shutdown()
