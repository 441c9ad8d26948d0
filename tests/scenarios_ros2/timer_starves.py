"""Two timers of one period under rclpy.spin, the first one slow: the second is called every other round.

Both are due when the spin begins: which of them is due first is not asked.
"""

import rclpy
from scenario import P, begin, block, end_after, mark, until


def slow():
    mark("slow")
    block(1.6)


rclpy.init()
node = rclpy.create_node("timer_starves")
begin()
node.create_timer(P, slow)
node.create_timer(P, lambda: mark("fast"))
until(1.3)
end_after(9.45)
rclpy.spin(node)
