"""A message knows the connection that it came by."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_connection_header")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)


def heard(message):
    for name in sorted(message._connection_header):
        say(name, message._connection_header[name].strip())


rospy.Subscriber("~a", UInt32, heard)
block(1)
publisher.publish(1)
block(0.5)
