"""A goal, its feedback and its result, of a server in another process."""

import rclpy
from rclpy.action import ActionClient
from scenario import say
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("client")
client = ActionClient(node, Fibonacci, "fibonacci")
say("there", client.wait_for_server(timeout_sec=60.0))
future = client.send_goal_async(
    Fibonacci.Goal(order=3), feedback_callback=lambda message: say("feedback", list(message.feedback.sequence))
)
rclpy.spin_until_future_complete(node, future)
say("accepted", future.result().accepted)
result = future.result().get_result_async()
rclpy.spin_until_future_complete(node, result)
say("result", result.result().status, list(result.result().result.sequence))
