"""An answer wakes all clients of its service, each for a call of its own that does nothing."""

import rclpy
from scenario import say
from std_srvs.srv import Trigger


def answer(request, response):
    say("asked")
    return response


rclpy.init()
node = rclpy.create_node("services_answers_of_others")
node.create_service(Trigger, "work", answer)
clients = [node.create_client(Trigger, "work") for _ in range(3)]
guard = node.create_guard_condition(lambda: say("guard"))
for client in clients[1:]:
    future = client.call_async(Trigger.Request())
    future.add_done_callback(lambda _: say("answered"))
    for number in range(7):
        guard.trigger()
        rclpy.spin_once(node)
        say(number)
rclpy.shutdown()
