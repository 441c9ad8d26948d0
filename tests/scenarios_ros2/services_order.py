"""A round takes timers, subscriptions, guard conditions, clients and services, each in the order of their making."""

import rclpy
from scenario import P, begin, block, say
from std_msgs.msg import Empty as Message
from std_srvs.srv import Trigger


def answer(name):
    def call(request, response):
        say(name)
        return response

    return call


rclpy.init()
node = rclpy.create_node("services_order")
services = [node.create_service(Trigger, name, answer(name)) for name in ("service2", "service1")]
clients = [node.create_client(Trigger, name) for name in ("service1", "service2")]
guard = node.create_guard_condition(lambda: say("guard"))
node.create_subscription(Message, "topic", lambda _: say("subscription"), 10)
publisher = node.create_publisher(Message, "topic", 10)
first = [client.call_async(Trigger.Request()) for client in clients]
block(0.3)
for _ in services:
    rclpy.spin_once(node)
begin()
for number, future in enumerate(first, 1):
    future.add_done_callback(lambda _, number=number: say("client", number))
timer = node.create_timer(P, lambda: (say("timer"), timer.cancel()))
for client in clients:
    client.call_async(Trigger.Request())
publisher.publish(Message())
guard.trigger()
block(1.3)
for _ in range(11):
    rclpy.spin_once(node)
rclpy.shutdown()
