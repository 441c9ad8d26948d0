"""A client in async callbacks, and a server whose function awaits."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
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
    timer.cancel()
    handle = await client.send_goal_async(Fibonacci.Goal(order=1))
    mark("accepted")
    response = await handle.get_result_async()
    mark("result")
    say(response.status, list(response.result.sequence))


rclpy.init()
node = rclpy.create_node("actions_await")
group = MutuallyExclusiveCallbackGroup()
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
timer = node.create_timer(P, start, group)
end_after(5.5)
rclpy.spin(node)
