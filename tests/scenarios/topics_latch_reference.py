"""What is latched is the sender's own object, not a copy of it."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String

begin("topics_latch_reference")
publisher = rospy.Publisher("~a", String, queue_size=10, latch=True)
message = String("as it was")
publisher.publish(message)
message.data = "changed"
block(1)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
block(1)
