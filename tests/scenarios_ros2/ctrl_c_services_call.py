"""Ctrl-C while main waits in call() for a service that does not answer."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from scenario import begin, block, mark
from std_srvs.srv import Trigger


def spin():
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def answer(request, response):
    mark("asked")
    block(20)
    return response


rclpy.init()
node = rclpy.create_node("ctrl_c_services_call")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
executor = SingleThreadedExecutor()
executor.add_node(node)
begin()
threading.Thread(target=spin, daemon=True).start()
try:
    client.call(Trigger.Request())
finally:
    mark("over")
