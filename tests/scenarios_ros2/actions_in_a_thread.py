"""send_goal, cancel_goal and get_result wait, in another thread than the one that spins."""

import os
import threading

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import begin, block, end_after, mark, say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    block(1)
    if goal_handle.is_cancel_requested:
        goal_handle.canceled()
    else:
        goal_handle.succeed()
    return Fibonacci.Result(sequence=[goal_handle.request.order])


def work():
    response = client.send_goal(Fibonacci.Goal(order=4))
    mark("result")
    say(response.status, list(response.result.sequence))
    future = client.send_goal_async(Fibonacci.Goal(order=5))
    while not future.done():
        block(0.05)
    handle = future.result()
    say("cancelled", len(handle.cancel_goal().goals_canceling))
    response = handle.get_result()
    mark("second")
    say(response.status)
    os._exit(0)


rclpy.init()
node = rclpy.create_node("actions_in_a_thread")
group = ReentrantCallbackGroup()
server = ActionServer(
    node, Fibonacci, "f", execute, callback_group=group, cancel_callback=lambda handle: CancelResponse.ACCEPT
)
client = ActionClient(node, Fibonacci, "f", callback_group=group)
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
threading.Thread(target=work, daemon=True).start()
end_after(8)
executor.spin()
