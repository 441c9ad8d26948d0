"""On one thread, a goal that is executed keeps a timer waiting, and so does its feedback not arrive before its end."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import P, begin, block, end_after, mark
from test_msgs.action import Fibonacci


def execute(goal_handle):
    mark("executes")
    for _ in range(2):
        block(0.8)
        goal_handle.publish_feedback(Fibonacci.Feedback())
    mark("executed")
    goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_timer_beside")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
node.create_timer(P, lambda: mark("tick"))
client.send_goal_async(Fibonacci.Goal(order=1), feedback_callback=lambda message: mark("feedback"))
end_after(4.5)
rclpy.spin(node)
