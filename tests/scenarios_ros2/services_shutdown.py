"""rclpy.shutdown() in a service's callback, with the answer still to be sent; and what can be asked afterwards."""

import rclpy
from scenario import attempt, say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    rclpy.shutdown()
    return response


rclpy.init()
node = rclpy.create_node("services_shutdown")
service = node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
future = client.call_async(Trigger.Request())
names = {"rclpy": rclpy, "node": node, "client": client, "service": service, "future": future, "Trigger": Trigger}
for text in """
rclpy.spin_until_future_complete(node, future)
future.done(), future.result()
client.call_async(Trigger.Request())
client.call(Trigger.Request(), 0.1)
client.service_is_ready()
client.service_name, service.service_name
client.wait_for_service(0.1)
node.create_client(Trigger, 'other')
node.create_service(Trigger, 'other', print)
node.count_services('work')
node.count_clients('work')
node.get_service_names_and_types()
node.get_service_names_and_types_by_node('services_shutdown', '/')
node.destroy_client(client), node.destroy_service(service)
""".strip().splitlines():
    attempt(text, names)
