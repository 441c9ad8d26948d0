"""Two loops on one Rate: a tick wakes both."""

import threading

import rclpy
from scenario import P, begin, end_after, mark


def loop(name):
    while True:
        rate.sleep()
        mark(name)


rclpy.init()
node = rclpy.create_node("rate_two_sleepers")
begin()
rate = node.create_rate(1 / P)
for name in ("first", "second"):
    threading.Thread(target=loop, args=(name,), daemon=True).start()
end_after(4.5)
rclpy.spin(node)
