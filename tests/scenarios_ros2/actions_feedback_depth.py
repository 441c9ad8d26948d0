"""Feedback that comes while it cannot be taken: the newest of it is kept."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.qos import QoSProfile
from scenario import arg, say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    for number in range(15):
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[number]))
    goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_feedback_depth")
server = ActionServer(node, Fibonacci, "count", execute)
client = ActionClient(node, Fibonacci, "count", feedback_sub_qos_profile=QoSProfile(depth=int(arg("depth", 10))))
seen = []
future = client.send_goal_async(
    Fibonacci.Goal(), feedback_callback=lambda message: seen.append(message.feedback.sequence[0])
)
rclpy.spin_until_future_complete(node, future)
result = future.result().get_result_async()
rclpy.spin_until_future_complete(node, result)
say("until the result", len(seen))
for _ in range(30):
    rclpy.spin_once(node, timeout_sec=0.01)
say(*seen)
