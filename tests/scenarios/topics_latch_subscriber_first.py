"""A subscriber that was there first gets what was published before they were connected, if it is latched."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String

begin("topics_latch_subscriber_first")
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
block(1)
publisher = rospy.Publisher("~a", String, queue_size=10, latch=True)
publisher.publish("one")
publisher.publish("two")
block(1)
publisher.publish("three")
block(1)
