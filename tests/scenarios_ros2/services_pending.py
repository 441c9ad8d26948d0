"""remove_pending_request: the answer is dropped, and no done callback is called."""

import rclpy
from scenario import attempt, say
from test_msgs.srv import BasicTypes


def answer(request, response):
    say("asked", request.int32_value)
    return response


rclpy.init()
node = rclpy.create_node("services_pending")
node.create_service(BasicTypes, "work", answer)
client = node.create_client(BasicTypes, "work")
futures = [client.call_async(BasicTypes.Request(int32_value=number)) for number in range(4)]
for number, future in enumerate(futures):
    future.add_done_callback(lambda _, number=number: say("done", number))
client.remove_pending_request(futures[0])
client.remove_pending_request(futures[0])
futures[1].cancel()
futures[2].set_result("my own")
say([client.get_pending_request(number) is futures[number - 1] for number in (4,)])
for _ in range(12):
    rclpy.spin_once(node, timeout_sec=0.05)
names = {"client": client, "futures": futures}
attempt("client.get_pending_request(1)", names)
attempt("[future.done() for future in futures], [future.cancelled() for future in futures]", names)
attempt("[future.result() is None for future in futures]", names)
attempt("futures[2].result()", names)
rclpy.shutdown()
