"""call() in a callback of a MultiThreadedExecutor: it is answered, as the client is in a group of its own."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    mark("asked")
    block(0.5)
    response.message = "done"
    return response


def ask():
    mark("asks")
    say(client.call(Trigger.Request()).message)
    mark("answered")


rclpy.init()
node = rclpy.create_node("services_callback_in_own_group")
node.create_service(Trigger, "work", answer, callback_group=MutuallyExclusiveCallbackGroup())
client = node.create_client(Trigger, "work", callback_group=MutuallyExclusiveCallbackGroup())
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
begin()
node.create_timer(P, ask)
end_after(4.7)
executor.spin()
