"""call() in another thread while main spins: it waits for the answer, whatever the timers do meanwhile."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, begin, block, mark, say
from std_srvs.srv import Trigger


def answer(request, response):
    block(1.5)
    response.success = True
    response.message = "done"
    return response


def ask():
    for _ in range(2):
        say(client.call(Trigger.Request()).message)
        mark("answered")
    rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("services_call_in_thread")
node.create_service(Trigger, "work", answer)
client = node.create_client(Trigger, "work")
begin()
node.create_timer(P, lambda: mark("tick"))
threading.Thread(target=ask).start()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    say("shut down")
