"""A result is kept for those who ask late, for as long as the server was told."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import arg, say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[5])


def spin(periods):
    for _ in range(periods):
        rclpy.spin_once(node, timeout_sec=0.05)


rclpy.init()
node = rclpy.create_node("actions_result_late")
server = ActionServer(node, Fibonacci, "fibonacci", execute, result_timeout=arg("timeout", 1))
client = ActionClient(node, Fibonacci, "fibonacci")
future = client.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(node, future)
for wait in (6, 40):
    spin(wait)
    result = future.result().get_result_async()
    rclpy.spin_until_future_complete(node, result)
    say(result.result().status, list(result.result().result.sequence))
