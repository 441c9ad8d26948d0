"""A subscriber gets an object of its own, which all callbacks of the node share."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import Float64MultiArray

seen = []


def first(message):
    seen.append(message)
    say("first", message.data, type(message.data).__name__)
    message.data = "changed by the first"


def second(message):
    say("second", message.data, message is seen[-1])


begin("topics_copies")
publisher = rospy.Publisher("~a", Float64MultiArray, queue_size=10)
rospy.Subscriber("~a", Float64MultiArray, first)
rospy.Subscriber("~a", Float64MultiArray, second)
block(1)
message = Float64MultiArray(data=[1.0])
publisher.publish(message)
message.data.append(2.0)
block(0.5)
say("sender", message.data, message is seen[0])
publisher.publish(message)
block(0.5)
