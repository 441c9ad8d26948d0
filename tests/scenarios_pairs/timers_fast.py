"""A timer of its own, which the other process's timer does not touch; it blocks itself once."""

import time

import rclpy
from scenario import begin, invite, mark, say, spin_until


def tick():
    ticks.append(1)
    mark("tick")
    if len(ticks) == 3:
        time.sleep(1.0)


rclpy.init()
node = rclpy.create_node("fast")
ticks = []
invite(node)
begin()
node.create_timer(0.4, tick)
spin_until(node, lambda: len(ticks) == 6)
say(len(ticks))
rclpy.shutdown()
