"""When a server forgets goals that have ended: each further end puts it off, and what is asked is served first."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import P, attempt, begin, now, say, until
from test_msgs.action import Fibonacci


def execute(goal_handle):
    handles.append(goal_handle)
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[5])


def send():
    future = client.send_goal_async(Fibonacci.Goal())
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def result(goal_handle):
    future = goal_handle.get_result_async()
    rclpy.spin_until_future_complete(node, future)
    return future.result().status


def spin(periods):
    while now() < periods * P:
        rclpy.spin_once(node, timeout_sec=0.01)


rclpy.init()
node = rclpy.create_node("actions_results_expire")
handles = []
attempt("ActionServer(node, Fibonacci, 'other', execute, result_timeout=-1)", globals())
server = ActionServer(node, Fibonacci, "fibonacci", execute, result_timeout=4 * P)
client = ActionClient(node, Fibonacci, "fibonacci")
client.wait_for_server()
begin()
for periods in (1, 1.5):
    send()
    spin(periods)
last = send()
for periods in (4.25, 4.75, 6.75, 7.25):
    spin(periods)
    say([handle.status for handle in handles])
say(result(last))
last = send()
until(13)
say(result(last), result(last))
