"""wait_for_message on a node that another thread spins: who gets the message?"""

import threading

import rclpy
from rclpy.wait_for_message import wait_for_message
from scenario import P, begin
from std_msgs.msg import UInt32


def publish():
    publisher.publish(UInt32(data=7))


rclpy.init()
node = rclpy.create_node("topics_wait_while_spun")
publisher = node.create_publisher(UInt32, "numbers", 10)
node.create_timer(P, publish)
begin()
thread = threading.Thread(target=rclpy.spin, args=(node,))
thread.start()
print(wait_for_message(UInt32, node, "numbers", time_to_wait=1.5 * P))
print(wait_for_message(UInt32, node, "others", time_to_wait=P))
rclpy.shutdown()
thread.join()
