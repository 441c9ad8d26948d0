"""call() with a timeout, in a thread: a server that is too slow, then one that is not."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import begin, mark, say
from test_msgs.srv import BasicTypes


def ask():
    client.wait_for_service()
    for block in (1.5, 0.0):
        begin()
        response = client.call(BasicTypes.Request(float64_value=block), timeout_sec=1.0)
        mark("goes_on")
        say(response and response.float64_value)
    rclpy.shutdown()


rclpy.init()
node = rclpy.create_node("client")
client = node.create_client(BasicTypes, "work")
thread = threading.Thread(target=ask)
thread.start()
try:
    rclpy.spin(node)
except ExternalShutdownException:
    say("shut down")
thread.join()
