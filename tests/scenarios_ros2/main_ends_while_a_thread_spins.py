"""main() ends while a daemon thread spins; nothing is shut down."""

import threading
import time

import rclpy

rclpy.init()
node = rclpy.create_node("left")
node.create_timer(0.2, lambda: print("tick"))
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
time.sleep(0.5)
print("main ends")
