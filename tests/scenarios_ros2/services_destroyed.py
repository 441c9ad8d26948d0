"""A service or client that is destroyed with a request on its way, and what can still be asked of it."""

import warnings

import rclpy
from scenario import P, attempt, begin, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    return response


rclpy.init()
node = rclpy.create_node("services_destroyed")
service = node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
begin()
future = client.call_async(Trigger.Request())
say(node.destroy_service(service), node.destroy_service(service), client.service_is_ready())
rclpy.spin_until_future_complete(node, future, timeout_sec=P)
mark("spun")
say(future.done())
again = node.create_service(Trigger, "work", answer)
rclpy.spin_until_future_complete(node, future, timeout_sec=P)
mark("spun")
future = client.call_async(Trigger.Request())
say(node.destroy_client(client), node.destroy_client(client))
with warnings.catch_warnings(record=True) as caught:
    rclpy.spin_until_future_complete(node, future, timeout_sec=P)
mark("spun")
say(future.done(), *(each.category.__name__ for each in caught))
names = {"node": node, "client": client, "service": service, "Trigger": Trigger, "future": future}
for text in """
client.call_async(Trigger.Request())
client.call_async(None)
client.call(Trigger.Request())
client.service_is_ready()
client.wait_for_service(1)
client.service_name
client.logger_name
client.srv_name
client.get_pending_request(1) is None, client.get_pending_request(2) is future
client.remove_pending_request(future)
client.destroy()
service.service_name
service.logger_name
service.srv_name
service.send_response(Trigger.Response(), None)
service.destroy()
node.count_services('work'), node.count_clients('work')
""".strip().splitlines():
    attempt(text, names)
node.destroy_node()
attempt("node.create_client(Trigger, 'work')", names)
attempt("node.create_service(Trigger, 'work', print)", names)
attempt("node.count_services('work')", names)
attempt("node.get_service_names_and_types()", names)
attempt("node.resolve_service_name('work')", names)
attempt("list(node.clients), list(node.services)", names)
rclpy.shutdown()
