"""Executes one goal, and ends."""

import time

import rclpy
from rclpy.action import ActionServer
from rclpy.task import Future
from scenario import say, spin_for
from test_msgs.action import Fibonacci

done = Future()


def execute(goal_handle):
    say("executes", goal_handle.request.order)
    sequence = [0, 1]
    for _ in range(goal_handle.request.order):
        sequence.append(sequence[-1] + sequence[-2])
        time.sleep(0.2)
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
    goal_handle.succeed()
    done.set_result(None)
    return Fibonacci.Result(sequence=sequence)


rclpy.init()
node = rclpy.create_node("server")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
rclpy.spin_until_future_complete(node, done, timeout_sec=60)
spin_for(node, 0.5)
say("ends")
