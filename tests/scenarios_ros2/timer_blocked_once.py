"""The third call of a timer takes block:= periods: at most one late tick, then the old grid."""

import rclpy
from rclpy.node import Node
from scenario import P, arg, begin, block, end_after, mark


class Blocked(Node):
    def __init__(self):
        super().__init__("timer_blocked_once")
        begin()
        self.calls = 0
        self.timer = self.create_timer(P, self.timer_callback)

    def timer_callback(self):
        self.calls += 1
        mark("tick")
        if self.calls == 3:
            block(arg("block"))


rclpy.init()
node = Blocked()
end_after(11.45)
rclpy.spin(node)
