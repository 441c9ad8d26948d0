#!/usr/bin/env python3

import rclpy

rclpy.init()
node = rclpy.create_node("shutdown_in_callback")
node.create_timer(0.5, rclpy.shutdown)
rclpy.spin(node)
