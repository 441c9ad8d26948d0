#!/usr/bin/env python3

import rclpy

rclpy.init()
node = rclpy.create_node("rate_nobody_spins")
rate = node.create_rate(2.0)
while rclpy.ok():
    rate.sleep()
