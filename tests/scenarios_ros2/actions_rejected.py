"""Goals that the server does not accept."""

import rclpy
from rclpy.action import ActionClient, ActionServer, GoalResponse
from scenario import say
from test_msgs.action import Fibonacci


def decide(goal):
    say("decides on", goal.order)
    if goal.order == 3:
        return None
    return GoalResponse.ACCEPT if goal.order < 2 else GoalResponse.REJECT


def execute(goal_handle):
    say("executes", goal_handle.request.order)
    goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_rejected")
server = ActionServer(node, Fibonacci, "fibonacci", execute, goal_callback=decide)
client = ActionClient(node, Fibonacci, "fibonacci")
for order in (1, 2, 3):
    future = client.send_goal_async(Fibonacci.Goal(order=order))
    rclpy.spin_until_future_complete(node, future)
    handle = future.result()
    say("accepted", handle.accepted, handle.status, handle.stamp.sec > -1)
    result = handle.get_result_async()
    rclpy.spin_until_future_complete(node, result)
    say("result", result.result())
