"""The events of an end wait for their callback group, and several threads serve several groups."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.executors import MultiThreadedExecutor
from rclpy.qos import QoSProfile
from scenario import P, begin, block, end_after, mark
from std_msgs.msg import UInt32


def make_busy():
    mark("begins")
    block(3.5)
    mark("ends")


def publish(name, group):
    publisher = node.create_publisher(
        UInt32,
        name,
        QoSProfile(depth=1, deadline=Duration(seconds=P)),
        callback_group=group,
        event_callbacks=PublisherEventCallbacks(deadline=lambda event: mark(f"{name}_{event.total_count}")),
    )
    publisher.publish(UInt32())


rclpy.init()
node = rclpy.create_node("qos_events_multi")
begin()
publish("beside", MutuallyExclusiveCallbackGroup())
publish("blocked", None)
timer = node.create_timer(4.3 * P, make_busy)
executor = MultiThreadedExecutor(3)
executor.add_node(node)
end_after(8.2)
executor.spin()
