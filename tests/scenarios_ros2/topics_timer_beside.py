"""A slow subscription and a timer in one group: the timer waits, but has its turn in each round."""

import threading

import rclpy
from scenario import P, begin, block, end_after, mark, until
from std_msgs.msg import UInt32


def publish():
    for number in range(15):
        until(0.5 * number + 0.1)
        publisher.publish(UInt32(data=number))


def receive(message):
    mark("receive")
    block(1.6)


rclpy.init()
node = rclpy.create_node("topics_timer_beside")
publisher = node.create_publisher(UInt32, "numbers", 10)
node.create_subscription(UInt32, "numbers", receive, 1)
begin()
node.create_timer(P, lambda: mark("tick"))
threading.Thread(target=publish, daemon=True).start()
end_after(8.8)
rclpy.spin(node)
