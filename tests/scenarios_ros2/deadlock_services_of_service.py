"""call() in a callback, in the group of the service that should answer: it is never asked."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, end_after, mark
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    return response


def ask():
    mark("asks")
    client.call(Trigger.Request(), timeout_sec=0.7 * P)
    mark("goes_on")


rclpy.init()
node = rclpy.create_node("deadlock_services_of_service")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work", callback_group=MutuallyExclusiveCallbackGroup())
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
timer = node.create_timer(P, lambda: (timer.cancel(), ask()))
end_after(2.4)
executor.spin()
