"""A publisher that latches sends its last message to whoever comes late."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String

begin("topics_latch")
publisher = rospy.Publisher("~a", String, queue_size=10, latch=True)
for word in ("one", "two", "three"):
    publisher.publish(word)
block(1)
subscriber = rospy.Subscriber("~a", String, lambda message: say("first", message.data))
block(1)
publisher.publish("four")
block(0.5)
subscriber.unregister()
block(1)
publisher.publish("five")
block(0.5)
rospy.Subscriber("~a", String, lambda message: say("again", message.data))
block(1)
