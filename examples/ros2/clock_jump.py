#!/usr/bin/env python3
"""A timer of 1 s on ROS time that jumps from 0 to 100, and later back to 50.

The node tells the time itself, on /clock, and prints when it ticks, in ROS time.
"""

import time
from threading import Thread

import rclpy
from builtin_interfaces.msg import Time
from rclpy.executors import ExternalShutdownException
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock


def tell(publisher):
    for begin in (100, 50):
        for step in range(31):
            now = begin + step / 10
            publisher.publish(Clock(clock=Time(
                sec=int(now), nanosec=int(now % 1 * 1e9))))
            time.sleep(0.05)


def main():
    rclpy.init()
    node = rclpy.create_node("clock_jump", parameter_overrides=[
        Parameter("use_sim_time", value=True)])
    clock = node.get_clock()
    node.create_timer(1.0, lambda: print(
        "ros_time,%.1f" % (clock.now().nanoseconds / 1e9), flush=True))
    publisher = node.create_publisher(Clock, "/clock", 10)
    Thread(target=tell, args=(publisher,), daemon=True).start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
