"""A goal that is cancelled while it is executed, on four threads."""

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import after, begin, block, end_after, mark, say
from test_msgs.action import Fibonacci


def execute(goal_handle):
    mark("executes")
    for number in range(10):
        if goal_handle.is_cancel_requested:
            say("cancel requested", goal_handle.status)
            goal_handle.canceled()
            say("canceled", goal_handle.status)
            return Fibonacci.Result(sequence=[number])
        block(1)
    goal_handle.succeed()
    return Fibonacci.Result()


def decide(goal_handle):
    mark("cancels")
    say(goal_handle.status, goal_handle.is_active)
    return CancelResponse.ACCEPT


def accepted(future):
    global handle
    handle = future.result()
    handle.get_result_async().add_done_callback(ended)


def ended(future):
    mark("ended")
    say(future.result().status, list(future.result().result.sequence))


def cancel():
    mark("asks")
    handle.cancel_goal_async().add_done_callback(cancelled)


def cancelled(future):
    mark("answered")
    say(future.result().return_code, len(future.result().goals_canceling))


rclpy.init()
node = rclpy.create_node("actions_cancel")
group = ReentrantCallbackGroup()
server = ActionServer(node, Fibonacci, "fibonacci", execute, cancel_callback=decide, callback_group=group)
client = ActionClient(node, Fibonacci, "fibonacci", callback_group=group)
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
client.send_goal_async(Fibonacci.Goal(order=1)).add_done_callback(accepted)
after(2.5, cancel)
end_after(5.5)
executor.spin()
