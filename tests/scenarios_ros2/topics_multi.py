"""Subscriptions in groups of their own under a MultiThreadedExecutor; a reentrant one overlaps itself."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import begin, block, end_after, mark, until
from std_msgs.msg import UInt32


def receiver(name):
    def receive(message):
        mark(f"{name}_{message.data}")
        block(1)

    return receive


rclpy.init()
node = rclpy.create_node("topics_multi")
publisher = node.create_publisher(UInt32, "numbers", 10)
for name, group in (("own", MutuallyExclusiveCallbackGroup()), ("overlaps", ReentrantCallbackGroup())):
    node.create_subscription(UInt32, "numbers", receiver(name), 10, callback_group=group)
begin()
executor = MultiThreadedExecutor(8)
executor.add_node(node)
until(0.5)
for number in range(3):
    publisher.publish(UInt32(data=number))
end_after(4)
executor.spin()
