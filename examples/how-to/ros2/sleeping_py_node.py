#!/usr/bin/env python3

import time

import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node("sleeping_py_node")
    counter = 0
    while rclpy.ok():
        counter += 1
        node.get_logger().info(
            "[SLEEPING PY NODE] counter = " + str(counter))

        # The work of the loop takes 5 ms
        time.sleep(0.005)

        # A whole period, whatever the work took
        time.sleep(0.1)


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        pass
