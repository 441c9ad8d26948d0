"""Ctrl-C while a goal is executed."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import begin, block, say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    say("executes")
    for _ in range(30):
        block(1)
    say("never")
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("ctrl_c_actions_execute")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
client.send_goal_async(Fibonacci.Goal(order=1))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    say("KeyboardInterrupt")
