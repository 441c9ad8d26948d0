"""call() with a lock that the service needs, each callback in a group of its own: enough threads do not help."""

import threading

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, end_after, mark
from std_srvs.srv import Trigger

lock = threading.Lock()


def answer(request, response):
    mark("asked")
    with lock:
        mark("answers")
    return response


def ask():
    with lock:
        mark("asks")
        client.call(Trigger.Request())
        mark("answered")


rclpy.init()
node = rclpy.create_node("deadlock_services_lock")
group = ReentrantCallbackGroup()
node.create_service(Trigger, "work", answer, callback_group=group)
client = node.create_client(Trigger, "work", callback_group=group)
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
node.create_timer(1.5 * P, ask, callback_group=group)
node.create_timer(P, lambda: mark("tick"))
end_after(2.6)
executor.spin()
