#!/usr/bin/env python3

from threading import Thread

import rclpy

rclpy.init()
node = rclpy.create_node("rate_in_main")
Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(2.0)
while rclpy.ok():
    rate.sleep()
