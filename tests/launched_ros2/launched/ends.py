"""Ends after the seconds, and with the status, that it is given; without a status by an exception."""

import sys
import time

import rclpy


def main():
    seconds, status = sys.argv[1:3]
    rclpy.init()
    node = rclpy.create_node("ends")
    node.get_logger().info("up")
    time.sleep(float(seconds))
    node.get_logger().info("ending")
    if status == "raise":
        raise RuntimeError("as told")
    return int(status)
