"""A round takes the timers, then one message of each subscription, in the order in which they were made."""

import rclpy
from scenario import P, begin, block, say
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("topics_order")
first, second = (node.create_publisher(UInt32, name, 10) for name in ("first", "second"))
node.create_subscription(UInt32, "second", lambda message: say("second", message.data), 10)
node.create_subscription(UInt32, "first", lambda message: say("first", message.data), 10)
begin()
timer = node.create_timer(P, lambda: (say("timer"), timer.cancel()))
for number in range(3):
    first.publish(UInt32(data=number))
    second.publish(UInt32(data=number))
block(1.3)
for _ in range(7):
    rclpy.spin_once(node)
rclpy.shutdown()
