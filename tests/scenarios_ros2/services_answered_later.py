"""A service's callback is a coroutine that awaits a future, which a timer sets: it answers then, others meanwhile."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.task import Future
from scenario import P, begin, mark, say
from std_srvs.srv import SetBool


async def answer(request, response):
    say("asked", request.data)
    if request.data:
        response.message = await due
    return response


def done(future):
    mark("answered")
    say(future.result().message)


rclpy.init()
node = rclpy.create_node("services_answered_later")
due = Future()
node.create_service(SetBool, "switch", answer, callback_group=ReentrantCallbackGroup())
client = node.create_client(SetBool, "switch")
begin()
node.create_timer(2 * P, lambda: due.set_result("in time"))
for data in (True, False):
    client.call_async(SetBool.Request(data=data)).add_done_callback(done)
node.create_timer(3.5 * P, rclpy.shutdown)
rclpy.spin(node)
