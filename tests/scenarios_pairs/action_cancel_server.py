"""Executes a goal on one of two threads, until it is cancelled."""

import threading
import time

import rclpy
from rclpy.action import ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import say
from test_msgs.action import Fibonacci

done = threading.Event()


def execute(goal_handle):
    say("executes", goal_handle.request.order)
    for _ in range(100):
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        time.sleep(0.1)
        if goal_handle.is_cancel_requested:
            goal_handle.canceled()
            say("canceled", goal_handle.status)
            break
    done.set()
    return Fibonacci.Result(sequence=[7])


rclpy.init()
node = rclpy.create_node("server")
server = ActionServer(
    node,
    Fibonacci,
    "fibonacci",
    execute,
    cancel_callback=lambda handle: CancelResponse.ACCEPT,
    callback_group=ReentrantCallbackGroup(),
)
executor = MultiThreadedExecutor(num_threads=2)
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
say("done", done.wait(60))
time.sleep(0.5)
rclpy.shutdown()
