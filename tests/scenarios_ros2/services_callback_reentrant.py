"""call() in a callback of a MultiThreadedExecutor, all in one ReentrantCallbackGroup: calls overlap each other."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    block(1.5)
    return response


def ask():
    mark("asks")
    client.call(Trigger.Request())
    mark("answered")


rclpy.init()
node = rclpy.create_node("services_callback_reentrant")
group = ReentrantCallbackGroup()
node.create_service(Trigger, "work", answer, callback_group=group)
client = node.create_client(Trigger, "work", callback_group=group)
executor = MultiThreadedExecutor(num_threads=6)
executor.add_node(node)
begin()
node.create_timer(P, ask, group)
end_after(4.2)
executor.spin()
