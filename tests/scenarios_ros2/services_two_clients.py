"""Two clients of one service, in one node and in another: each gets the answers to its own requests."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import say
from test_msgs.srv import BasicTypes


def answer(request, response):
    say("asked", request.int32_value)
    response.int32_value = 10 * request.int32_value
    return response


rclpy.init()
node, other = (rclpy.create_node(name) for name in ("services_two_clients", "other"))
node.create_service(BasicTypes, "work", answer)
clients = [each.create_client(BasicTypes, "work") for each in (node, node, other)]
executor = SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(other)
futures = [
    client.call_async(BasicTypes.Request(int32_value=number + 3 * turn))
    for turn in range(2)
    for number, client in enumerate(clients)
]
for future in futures:
    executor.spin_until_future_complete(future)
say([future.result().int32_value for future in futures])
rclpy.shutdown()
