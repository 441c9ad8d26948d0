"""Timers of several periods, under rclpy.spin: each keeps its own grid."""

import rclpy
from rclpy.node import Node
from scenario import P, begin, end_after, mark


class Several(Node):
    def __init__(self):
        super().__init__("timer_several")
        begin()
        self.create_timer(P, self.first)
        self.create_timer(1.5 * P, self.second)
        self.create_timer(2.75 * P, self.third)

    def first(self):
        mark("first")

    def second(self):
        mark("second")

    def third(self):
        mark("third")


rclpy.init()
node = Several()
end_after(9.4)
rclpy.spin(node)
