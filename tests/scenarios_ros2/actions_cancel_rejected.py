"""A server refuses to cancel, unless it is told otherwise; a goal that has ended cannot be cancelled."""

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse
from scenario import say
from test_msgs.action import Fibonacci

handles = []


def ask(handle):
    future = handle.cancel_goal_async()
    rclpy.spin_until_future_complete(node, future)
    response = future.result()
    say("return code", response.return_code, "goals", len(response.goals_canceling))


def send():
    future = client.send_goal_async(Fibonacci.Goal(order=1))
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def end(goal_handle):
    goal_handle.canceled() if goal_handle.is_cancel_requested else goal_handle.succeed()
    return Fibonacci.Result()


rclpy.init()
node = rclpy.create_node("actions_cancel_rejected")
server = ActionServer(node, Fibonacci, "fibonacci", end, handle_accepted_callback=handles.append)
client = ActionClient(node, Fibonacci, "fibonacci")
first = send()
say("server", handles[0].status, "client", first.status)
ask(first)
say("server", handles[0].status)
server.register_cancel_callback(lambda goal_handle: CancelResponse.ACCEPT)
second = send()
ask(second)
ask(second)
say("server", [handle.status for handle in handles])
handles[1].execute()
result = second.get_result_async()
rclpy.spin_until_future_complete(node, result)
say("result", result.result().status)
ask(second)
ask(first)
server.register_cancel_callback(None)
ask(send())
