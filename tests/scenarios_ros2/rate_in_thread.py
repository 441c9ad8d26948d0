"""A Rate loop in a thread while the main spins; pass 2 takes block:= periods. One pass is made up for."""

import threading

import rclpy
from scenario import P, arg, begin, block, end_after, mark


def loop():
    passes = 0
    while rclpy.ok():
        passes += 1
        mark("pass")
        if passes == 2:
            block(arg("block"))
        rate.sleep()


rclpy.init()
node = rclpy.create_node("rate_in_thread")
begin()
rate = node.create_rate(1 / P)
threading.Thread(target=loop, daemon=True).start()
end_after(9.45)
rclpy.spin(node)
