"""Two servers of one name: both answer, and the client takes the first answer."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_two_servers")
servers = [ActionServer(node, Fibonacci, "fibonacci", execute) for _ in range(2)]
client = ActionClient(node, Fibonacci, "fibonacci")
future = client.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(node, future)
result = future.result().get_result_async()
for _ in range(30):
    rclpy.spin_once(node, timeout_sec=0.02)
say(result.done(), result.result().status)
