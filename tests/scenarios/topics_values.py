"""What a subscriber gets: the value as it comes off the wire."""

import rospy
from geometry_msgs.msg import PoseStamped
from scenario import begin, block, say
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, ColorRGBA, Duration, Float32, Float64MultiArray, String, Time, UInt8MultiArray

begin("topics_values")
publishers = []
for name, type_, message in (
    ("~a", Float32, Float32(0.1)),
    ("~b", ColorRGBA, ColorRGBA(r=1, a=0.3)),
    ("~c", String, String('a "b"\nc: \xe4')),
    ("~d", Float64MultiArray, Float64MultiArray(data=[1, 2.5, float("inf")])),
    ("~e", UInt8MultiArray, UInt8MultiArray(data=[97, 98])),
    ("~f", Time, Time(rospy.Time(3, 45))),
    ("~g", Duration, Duration(rospy.Duration(-0.25))),
    ("~h", Bool, Bool(2)),
    ("~i", LaserScan, LaserScan(ranges=[0.5, 1.25], angle_min=-1)),
    ("~j", PoseStamped, PoseStamped()),
):
    publishers.append((rospy.Publisher(name, type_, queue_size=10), message))
    rospy.Subscriber(name, type_, lambda message: say(type(message).__name__, repr(message)))
block(2)
for publisher, message in publishers:
    publisher.publish(message)
    block(0.8)
