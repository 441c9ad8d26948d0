"""Serves two processes."""

import rclpy
from scenario import say, spin_for, spin_until
from test_msgs.srv import BasicTypes


def answer(request, response):
    asked.append(request.int32_value)
    response.int32_value = 10 * request.int32_value
    return response


rclpy.init()
node = rclpy.create_node("server")
asked = []
node.create_service(BasicTypes, "work", answer)
spin_until(node, lambda: len(asked) == 6)
spin_for(node, 1.0)
say(sorted(asked))
rclpy.shutdown()
