"""The last of three."""

import rclpy
from scenario import begin, mark, say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    if not seen:
        begin()
    seen.append(message.data)
    mark("receive")


rclpy.init()
node = rclpy.create_node("sink")
seen = []
node.create_subscription(UInt32, "squares", receive, 10)
spin_until(node, lambda: len(seen) == 3)
say(seen)
rclpy.shutdown()
