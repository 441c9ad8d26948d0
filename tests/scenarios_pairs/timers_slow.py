"""Ticks on while the other process blocks."""

import rclpy
from scenario import begin, mark, say, spin_until, wait_for_invitation


def tick():
    ticks.append(1)
    mark("tick")


rclpy.init()
node = rclpy.create_node("slow")
ticks = []
wait_for_invitation(node)
begin()
node.create_timer(0.6, tick)
spin_until(node, lambda: len(ticks) == 4)
say(len(ticks))
rclpy.shutdown()
