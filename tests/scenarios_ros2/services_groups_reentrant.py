"""A service of a ReentrantCallbackGroup serves several requests at a time, one of an exclusive group does not."""

import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import begin, block, end_after, mark
from std_srvs.srv import Trigger


def answer(name):
    def call(request, response):
        mark(name)
        block(1)
        return response

    return call


def ask(client):
    client.call(Trigger.Request())
    mark(f"{client.srv_name}_answered")


rclpy.init()
node = rclpy.create_node("services_groups_reentrant")
groups = {"exclusive": MutuallyExclusiveCallbackGroup(), "reentrant": ReentrantCallbackGroup()}
for name, group in groups.items():
    node.create_service(Trigger, name, answer(name), callback_group=group)
clients = [node.create_client(Trigger, name, callback_group=ReentrantCallbackGroup()) for name in groups]
executor = MultiThreadedExecutor(num_threads=6)
executor.add_node(node)
begin()
for client in clients:
    for _ in range(2):
        threading.Thread(target=ask, args=(client,), daemon=True).start()
end_after(3.5)
executor.spin()
