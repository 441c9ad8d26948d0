#!/usr/bin/env python3

import time

import rclpy

rclpy.init()
node = rclpy.create_node("in_callback")
node.create_timer(0.5, lambda: time.sleep(1.5))
rclpy.spin(node)
