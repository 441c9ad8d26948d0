"""call_async and spin_until_future_complete: the answer is there at once; two calls one after the other."""

import rclpy
from scenario import begin, mark, say
from std_srvs.srv import SetBool


def answer(request, response):
    say("asked", request.data)
    response.success = not request.data
    response.message = f"was {request.data}"
    return response


rclpy.init()
node = rclpy.create_node("services_call_async")
service = node.create_service(SetBool, "switch", answer)
client = node.create_client(SetBool, "switch")
begin()
for data in (True, False):
    future = client.call_async(SetBool.Request(data=data))
    say(future.done(), future.result(), type(future).__name__)
    rclpy.spin_until_future_complete(node, future)
    mark("answered")
    say(future.done(), future.result(), future.exception())
rclpy.shutdown()
