"""A serialization error that is caught breaks the connection: what follows does not arrive."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_publish_breaks")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, lambda message: say("got", message.data))
block(1)
for value in (1, -1, 2, 3, 4):
    try:
        publisher.publish(value)
    except rospy.ROSSerializationException as error:
        say(type(error).__name__, error)
    block(0.3)
