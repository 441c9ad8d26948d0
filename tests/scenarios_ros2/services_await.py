"""A timer's callback awaits the answer; the other timer ticks meanwhile, and the group is not free before the end."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from scenario import P, begin, end_after, mark, say
from std_srvs.srv import SetBool


def answer(request, response):
    mark("asked")
    response.message = f"was {request.data}"
    return response


async def ask():
    mark("asks")
    timer.cancel()
    for data in (True, False):
        response = await client.call_async(SetBool.Request(data=data))
        mark("goes_on")
        say(response.message)


rclpy.init()
node = rclpy.create_node("services_await")
group = MutuallyExclusiveCallbackGroup()
node.create_service(SetBool, "switch", answer, callback_group=group)
client = node.create_client(SetBool, "switch", callback_group=group)
begin()
timer = node.create_timer(P, ask)
node.create_timer(0.75 * P, lambda: mark("tick"), group)
end_after(2.7)
rclpy.spin(node)
