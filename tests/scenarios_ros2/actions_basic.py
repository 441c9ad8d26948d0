"""A goal, its feedback and its result: the client and the server in one node, one thread."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    say("executes", goal_handle.request.order, goal_handle.status, goal_handle.is_active)
    sequence = [0, 1]
    for _ in range(goal_handle.request.order):
        sequence.append(sequence[-1] + sequence[-2])
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
    goal_handle.succeed()
    say("succeeded", goal_handle.status, goal_handle.is_active)
    return Fibonacci.Result(sequence=sequence)


rclpy.init()
node = rclpy.create_node("actions_basic")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
say(client.wait_for_server(), client.server_is_ready())
future = client.send_goal_async(
    Fibonacci.Goal(order=3),
    feedback_callback=lambda message: say("feedback", list(message.feedback.sequence)),
)
rclpy.spin_until_future_complete(node, future)
handle = future.result()
say("accepted", handle.accepted, handle.status)
result = handle.get_result_async()
rclpy.spin_until_future_complete(node, result)
say("result", result.result().status, list(result.result().result.sequence))
say("status", handle.status)
