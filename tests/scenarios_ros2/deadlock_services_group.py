"""call() in a callback of a MultiThreadedExecutor, in the group of the client: it waits for its own end."""

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
    client.call(Trigger.Request())
    mark("answered")


rclpy.init()
node = rclpy.create_node("deadlock_services_group")
other = MutuallyExclusiveCallbackGroup()
node.create_service(Trigger, "work", answer, callback_group=other)
client = node.create_client(Trigger, "work")
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
node.create_timer(P, ask)
node.create_timer(P, lambda: mark("tick"), other)
end_after(2.4)
executor.spin()
