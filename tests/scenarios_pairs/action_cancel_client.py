"""Cancels a goal of a server in another process at its first feedback."""

import rclpy
from rclpy.action import ActionClient
from rclpy.task import Future
from scenario import say
from test_msgs.action import Fibonacci

heard = Future()


def feedback(message):
    if not heard.done():
        say("feedback")
        heard.set_result(None)


rclpy.init()
node = rclpy.create_node("client")
client = ActionClient(node, Fibonacci, "fibonacci")
say("there", client.wait_for_server(timeout_sec=60.0))
future = client.send_goal_async(Fibonacci.Goal(order=30), feedback_callback=feedback)
rclpy.spin_until_future_complete(node, future)
rclpy.spin_until_future_complete(node, heard)
answer = future.result().cancel_goal_async()
rclpy.spin_until_future_complete(node, answer)
say("cancels", answer.result().return_code, len(answer.result().goals_canceling))
result = future.result().get_result_async()
rclpy.spin_until_future_complete(node, result)
say("result", result.result().status, list(result.result().result.sequence))
