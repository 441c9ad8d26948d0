"""A service whose callback is a coroutine awaits another service before it answers."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from scenario import begin, mark, say
from test_msgs.srv import BasicTypes


async def add_one(request, response):
    say("outer", request.int32_value)
    inner = await double.call_async(BasicTypes.Request(int32_value=request.int32_value))
    response.int32_value = inner.int32_value + 1
    return response


def twice(request, response):
    say("inner", request.int32_value)
    response.int32_value = 2 * request.int32_value
    return response


rclpy.init()
node = rclpy.create_node("services_await_in_service")
group = ReentrantCallbackGroup()
node.create_service(BasicTypes, "outer", add_one)
node.create_service(BasicTypes, "inner", twice, callback_group=group)
double = node.create_client(BasicTypes, "inner", callback_group=group)
client = node.create_client(BasicTypes, "outer", callback_group=group)
begin()
for number in (1, 20):
    future = client.call_async(BasicTypes.Request(int32_value=number))
    rclpy.spin_until_future_complete(node, future, timeout_sec=2)
    say(future.result().int32_value)
mark("answered")
rclpy.shutdown()
