"""Goals that wait until the server executes them, one after the other."""

from collections import deque

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import P, begin, block, end_after, mark, say
from test_msgs.action import Fibonacci

waiting = deque()


def accept(goal_handle):
    say("accepted", goal_handle.request.order, goal_handle.status)
    waiting.append(goal_handle)


def execute(goal_handle):
    mark("executes", goal_handle.request.order)
    mark("at")
    block(0.5)
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[goal_handle.request.order])


def next_one():
    if waiting:
        waiting.popleft().execute()


def answered(future):
    handle = future.result()
    handle.get_result_async().add_done_callback(ended)


def ended(future):
    mark("ended")
    say(list(future.result().result.sequence), future.result().status)


rclpy.init()
node = rclpy.create_node("actions_deferred")
server = ActionServer(node, Fibonacci, "fibonacci", execute, handle_accepted_callback=accept)
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
node.create_timer(P, next_one)
for order in (1, 2, 3):
    client.send_goal_async(Fibonacci.Goal(order=order)).add_done_callback(answered)
end_after(4.5)
rclpy.spin(node)
