"""A timer that cancels itself in its first call is a one-shot; a second one continues."""

import rclpy
from rclpy.node import Node
from scenario import P, begin, end_after, mark


class OneShot(Node):
    def __init__(self):
        super().__init__("timer_oneshot")
        begin()
        self.one_shot = self.create_timer(1.5 * P, self.once)
        self.timer = self.create_timer(P, self.often)

    def once(self):
        mark("once")
        self.one_shot.cancel()

    def often(self):
        mark("often")


rclpy.init()
node = OneShot()
end_after(4.5)
rclpy.spin(node)
