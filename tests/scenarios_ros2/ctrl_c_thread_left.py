"""Ctrl-C with a thread that is no daemon and asks rclpy.ok(): Python waits for it."""

import threading
import time

import rclpy
from scenario import P, begin, mark, say


def work():
    while rclpy.ok():
        time.sleep(0.75 * P)
    mark("left")


rclpy.init()
node = rclpy.create_node("ctrl_c_thread_left")
begin()
threading.Thread(target=work).start()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    say("caught")
mark("end_of_main")
