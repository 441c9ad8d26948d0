#!/usr/bin/env python3

import rclpy
from rclpy.duration import Duration

rclpy.init()
node = rclpy.create_node("sleep_until")
due = node.get_clock().now()
while rclpy.ok():
    due += Duration(seconds=0.5)
    node.get_clock().sleep_until(due)
