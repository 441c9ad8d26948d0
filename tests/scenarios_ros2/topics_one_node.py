"""A timer publishes, a subscription of the same node receives: nothing is lost, all under one spin."""

import rclpy
from scenario import P, begin, end_after, mark, say
from std_msgs.msg import UInt32


def callback():
    global count
    count += 1
    mark("publish")
    publisher.publish(UInt32(data=count))


def receive(message):
    mark("receive")
    say(message)


count = 0
rclpy.init()
node = rclpy.create_node("topics_one_node")
publisher = node.create_publisher(UInt32, "numbers", 10)
begin()
node.create_subscription(UInt32, "numbers", receive, 10)
publisher.publish(UInt32(data=0))
node.create_timer(P, callback)
end_after(4.5)
rclpy.spin(node)
