#!/usr/bin/env python3

import rclpy


def timer_callback():
    raise ValueError("in a callback")


rclpy.init()
node = rclpy.create_node("exception")
node.create_timer(0.5, timer_callback)
rclpy.spin(node)
