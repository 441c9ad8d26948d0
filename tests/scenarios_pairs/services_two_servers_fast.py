"""Answers at once."""

import rclpy
from scenario import NAME, say, wait_for_invitation
from test_msgs.srv import BasicTypes


def answer(request, response):
    say("asked", request.int32_value)
    response.string_value = NAME
    return response


rclpy.init()
node = rclpy.create_node(NAME)
node.create_service(BasicTypes, "work", answer)
wait_for_invitation(node)
rclpy.shutdown()
