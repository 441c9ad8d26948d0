"""A callback that awaits a goal keeps its group, and so the answer from being taken: it never continues."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.task import Future
from scenario import P, begin, end_after, mark, say
from test_msgs.action import Fibonacci


async def execute(goal_handle):
    mark("executes")
    gate = Future()
    opener = node.create_timer(2 * P, lambda: gate.set_result(7))
    number = await gate
    opener.cancel()
    mark("goes_on")
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[number])


async def start():
    mark("sends")
    timer.cancel()
    handle = await client.send_goal_async(Fibonacci.Goal(order=1))
    mark("accepted")
    response = await handle.get_result_async()
    mark("result")
    say(response.status, list(response.result.sequence))


rclpy.init()
node = rclpy.create_node("deadlock_actions_await")
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
timer = node.create_timer(P, start)
end_after(5.5)
rclpy.spin(node)
