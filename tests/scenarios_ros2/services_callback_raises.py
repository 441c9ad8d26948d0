"""What a service's callback raises leaves spin(); the request is never answered, the next one is."""

import rclpy
from scenario import P, attempt, begin, mark, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    say("asked", request.int32_value)
    if request.int32_value == 0:
        raise ValueError("in a service's callback")
    return response


rclpy.init()
node = rclpy.create_node("services_callback_raises")
node.create_service(BasicTypes, "work", answer)
client = node.create_client(BasicTypes, "work")
futures = [client.call_async(BasicTypes.Request(int32_value=number)) for number in range(2)]
names = {"spin_until_future_complete": rclpy.spin_until_future_complete, "node": node, "futures": futures, "P": P}
begin()
for _ in range(2):
    attempt("spin_until_future_complete(node, futures[0], timeout_sec=P)", names)
    mark("spun")
    say([future.done() for future in futures])
rclpy.shutdown()
