"""A service waits while its group is busy, in a MultiThreadedExecutor; one of another group is served meanwhile."""

import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark, until
from std_srvs.srv import Trigger


def slow():
    mark("slow")
    timer.cancel()
    block(2)


def answer(name):
    def call(request, response):
        mark(name)
        return response

    return call


def ask():
    until(1.5)
    busy_future = busy.call_async(Trigger.Request())
    busy_future.add_done_callback(lambda _: mark("busy_answered"))
    free.call(Trigger.Request())
    mark("free_answered")


rclpy.init()
node = rclpy.create_node("services_groups")
own = MutuallyExclusiveCallbackGroup()
node.create_service(Trigger, "busy", answer("busy"))
node.create_service(Trigger, "free", answer("free"), callback_group=own)
busy, free = (node.create_client(Trigger, name, callback_group=own) for name in ("busy", "free"))
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
timer = node.create_timer(P, slow)
threading.Thread(target=ask, daemon=True).start()
end_after(4.5)
executor.spin()
