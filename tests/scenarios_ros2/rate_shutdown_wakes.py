"""rclpy.shutdown() from another thread: spin returns, a Rate that sleeps raises ROSInterruptException, as any later."""

import threading

import rclpy
from rclpy.exceptions import ROSInterruptException
from scenario import P, after, begin, mark, say


def loop():
    try:
        while True:
            mark("pass")
            rate.sleep()
    except ROSInterruptException as error:
        mark("interrupted")
        say(type(error).__name__, error.args)
    try:
        rate.sleep()
    except ROSInterruptException as error:
        say("again", type(error).__name__)


rclpy.init()
node = rclpy.create_node("rate_shutdown_wakes")
begin()
rate = node.create_rate(0.5 / P)
thread = threading.Thread(target=loop)
thread.start()
after(5.2, rclpy.shutdown)
try:
    rclpy.spin(node)
except Exception as error:
    say("spin", type(error).__name__)
thread.join()
mark("spun")
say("ok", rclpy.ok())
