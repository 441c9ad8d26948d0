"""A Subscriber of AnyMsg gets the bytes; what it got can be published as it is."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String

begin("topics_any_msg")
publisher = rospy.Publisher("~a", String, queue_size=10)
onward = rospy.Publisher("~b", String, queue_size=10)
received = []
rospy.Subscriber("~a", rospy.AnyMsg, received.append)
rospy.Subscriber("~b", String, lambda message: say("onward", message.data))
block(1)
publisher.publish("word")
block(0.5)
say(type(received[0]).__name__, received[0]._buff, received[0]._connection_header["type"])
onward.publish(received[0])
block(0.5)
