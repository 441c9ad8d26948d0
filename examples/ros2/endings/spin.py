#!/usr/bin/env python3

import rclpy

rclpy.init()
node = rclpy.create_node("spin")
node.create_timer(0.5, lambda: None)
rclpy.spin(node)
