"""Requests that wait are served in turn, one in each round, and a timer comes in between."""

import rclpy
from scenario import P, begin, block, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    say("asked", request.int32_value)
    response.int32_value = 10 * request.int32_value
    return response


def done(future):
    say("answered", future.result().int32_value)
    if all(each.done() for each in futures):
        rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("services_queued")
node.create_service(BasicTypes, "work", answer)
client = node.create_client(BasicTypes, "work")
begin()
timer = node.create_timer(P, lambda: (say("timer"), timer.cancel()))
futures = [client.call_async(BasicTypes.Request(int32_value=number)) for number in range(5)]
for future in futures:
    future.add_done_callback(done)
block(1.3)
rclpy.spin(node)
