"""Two timers of one period under rclpy.spin, the first one slow: the second is called every other round."""

import rclpy
from scenario import P, begin, block, end_after, mark


def slow():
    mark("slow")
    block(1.6)


rclpy.init()
node = rclpy.create_node("timer_starves")
begin()
node.create_timer(P, slow)
node.create_timer(P, lambda: mark("fast"))
end_after(10.75)
rclpy.spin(node)
