"""rclpy.shutdown() while another thread waits in call(): it waits on, until its timeout."""

import threading

import rclpy
from scenario import P, after, begin, mark, say
from std_srvs.srv import Trigger


def ask():
    say(client.call(Trigger.Request(), timeout_sec=3 * P))
    mark("goes_on")


rclpy.init()
node = rclpy.create_node("services_shutdown_while_called")
client = node.create_client(Trigger, "nobodys")
begin()
thread = threading.Thread(target=ask)
thread.start()
after(1.5, rclpy.shutdown)
try:
    rclpy.spin(node)
finally:
    mark("spun")
    thread.join()
