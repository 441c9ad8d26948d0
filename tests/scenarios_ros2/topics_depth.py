"""A callback slower than the messages: which ones it sees depends on the subscription's depth."""

import threading

import rclpy
from scenario import arg, begin, end_after, mark, until
from std_msgs.msg import UInt32


def publish():
    for number in range(20):
        until(0.25 * number + 0.1)
        publisher.publish(UInt32(data=number))


def receive(message):
    mark(f"seen_{message.data}")
    seen.append(message)
    until(0.225 + 1.25 * len(seen))  # between two messages


seen = []
rclpy.init()
node = rclpy.create_node("topics_depth")
publisher = node.create_publisher(UInt32, "numbers", 100)
node.create_subscription(UInt32, "numbers", receive, int(arg("depth")))
begin()
threading.Thread(target=publish, daemon=True).start()
end_after(17.1)
rclpy.spin(node)
