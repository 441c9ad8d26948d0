"""An exception in the function that executes a goal aborts the goal, and the node continues."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    if goal_handle.request.order == 1:
        raise ValueError("no such order")
    if goal_handle.request.order == 2:
        goal_handle.succeed()
        raise ValueError("too late")
    return Fibonacci.Result(sequence=[9])  # and says nothing of how it ended


rclpy.init()
node = rclpy.create_node("actions_raises")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
for order in (1, 2, 3):
    future = client.send_goal_async(Fibonacci.Goal(order=order))
    rclpy.spin_until_future_complete(node, future)
    result = future.result().get_result_async()
    rclpy.spin_until_future_complete(node, result)
    say("result", result.result().status, list(result.result().result.sequence))
