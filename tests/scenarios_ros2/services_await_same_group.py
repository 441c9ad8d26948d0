"""A callback awaits an answer that its own group keeps back, as the group is busy until the callback ends: never."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from scenario import P, begin, end_after, mark
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    return response


async def ask():
    mark("asks")
    await client.call_async(Trigger.Request())
    mark("goes_on")


rclpy.init()
node = rclpy.create_node("services_await_same_group")
node.create_service(Trigger, "work", answer, callback_group=MutuallyExclusiveCallbackGroup())
client = node.create_client(Trigger, "work")
begin()
node.create_timer(P, ask)
node.create_timer(0.75 * P, lambda: mark("tick"), MutuallyExclusiveCallbackGroup())
end_after(3.2)
rclpy.spin(node)
