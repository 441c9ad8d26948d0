#!/usr/bin/env python3

import sys

import rclpy

rclpy.init()
node = rclpy.create_node("system_exit")
node.create_timer(0.5, lambda: sys.exit(3))
rclpy.spin(node)
