"""A Rate that is destroyed wakes who sleeps on it; then it cannot sleep any more."""

import threading

import rclpy
from scenario import P, after, begin, end_after, mark, say


def loop():
    for _ in range(4):
        try:
            rate.sleep()
            mark("pass")
        except Exception as error:
            say(type(error).__name__, error)
            break


rclpy.init()
node = rclpy.create_node("rate_destroyed")
begin()
rate = node.create_rate(1 / P)
threading.Thread(target=loop, daemon=True).start()
after(2.5, lambda: node.destroy_rate(rate))
end_after(4)
rclpy.spin(node)
