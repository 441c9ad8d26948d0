"""call() with a timeout from a thread, while main spins: in time, and too late; the answer that is late is dropped."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, begin, block, mark, say
from std_srvs.srv import SetBool


def answer(request, response):
    block(0.5 if request.data else 1.5)
    mark("answers")
    response.message = str(request.data)
    return response


def ask():
    for data in (True, False, True):
        mark("asks")
        say(client.call(SetBool.Request(data=data), timeout_sec=P))
        mark("goes_on")
    rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("services_call_timeout")
node.create_service(SetBool, "slow", answer)
client = node.create_client(SetBool, "slow")
begin()
thread = threading.Thread(target=ask)
thread.start()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    say("shut down")
thread.join()
