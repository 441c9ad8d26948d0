"""A service that its own callback destroys; a client that its done callback destroys."""

import rclpy
from scenario import P, attempt, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked", node.destroy_service(service))
    response.message = "the last one"
    return response


rclpy.init()
node = rclpy.create_node("services_destroyed_in_callback")
service = node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
futures = [client.call_async(Trigger.Request()) for _ in range(2)]
names = {**vars(rclpy), "node": node, "future": futures[0], "P": P}
attempt("spin_until_future_complete(node, future, timeout_sec=P)", names)
say([future.done() for future in futures])
service = node.create_service(Trigger, "work", lambda request, response: response)
for _ in range(2):
    future = client.call_async(Trigger.Request())
    future.add_done_callback(lambda _: say("destroyed", node.destroy_client(client)))
for _ in range(6):
    rclpy.spin_once(node, timeout_sec=0.05)
rclpy.shutdown()
