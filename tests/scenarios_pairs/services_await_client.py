"""A timer's callback awaits the answer of another process, while another timer ticks."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from scenario import begin, mark, say
from std_srvs.srv import Trigger


async def ask():
    timer.cancel()
    response = await client.call_async(Trigger.Request())
    mark("answered")
    say(response.message)
    rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("client")
other = MutuallyExclusiveCallbackGroup()
client = node.create_client(Trigger, "work", callback_group=other)
client.wait_for_service()
begin()
timer = node.create_timer(0.2, ask)
node.create_timer(0.35, lambda: mark("tick"), other)
rclpy.spin(node)
