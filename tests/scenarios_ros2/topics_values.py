"""What publishers and subscriptions do not take; fields are checked by the constructor if it is asked for."""

import os

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"

import rclpy  # noqa: E402
from geometry_msgs.msg import Point, Twist, Vector3  # noqa: E402
from rclpy.qos import QoSProfile  # noqa: E402
from scenario import attempt  # noqa: E402
from std_msgs.msg import Bool, Float64, Header, String, UInt8MultiArray, UInt32  # noqa: E402

rclpy.init()
node = rclpy.create_node("topics_values")
publisher = node.create_publisher(UInt32, "numbers", 10)
classes = (Bool, Float64, Header, Point, QoSProfile, String, Twist, UInt8MultiArray, UInt32, Vector3)
names = {"node": node, "publisher": publisher, **{each.__name__: each for each in classes}}
for text in """
publisher.publish(UInt32(data=5))
publisher.publish(5)
publisher.publish(String(data='5'))
publisher.publish()
publisher.publish(UInt32(), UInt32())
UInt32(5)
UInt32(foo=1)
UInt32(data='5')
UInt32(data=5.0)
UInt32(data=-1)
UInt32(data=2**32)
UInt32(data=True)
Float64(data=1)
Float64(data=1.5)
Bool(data=1)
String(data=5)
String(data='ä')
Twist(linear=Point())
Twist(linear=Vector3(x=1.0)).linear
Header(frame_id='a')
UInt8MultiArray(data=[1, 2]).data
UInt8MultiArray(data=[256])
UInt32(data=5) == UInt32(data=5), UInt32(data=5) == 5
UInt32.get_fields_and_field_types()
Twist()
node.create_publisher(UInt32, 'numbers')
node.create_publisher(UInt32, 'numbers', -1)
node.create_publisher(UInt32, 'numbers', '10')
node.create_publisher('UInt32', 'numbers', 10)
node.create_subscription(UInt32, 'numbers', print)
node.create_subscription(UInt32, 'numbers', None, 10)
QoSProfile()
QoSProfile(depth=5).depth
QoSProfile(depth=-5)
QoSProfile(depth=5).reliability
QoSProfile(depth=5).durability
node.destroy_publisher(publisher)
publisher.publish(UInt32(data=5))
""".strip().splitlines():
    attempt(text, names)
