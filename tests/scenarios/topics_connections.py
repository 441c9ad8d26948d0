"""Publishers and subscribers connect, whichever comes first; a node counts once, however many ends it has."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_connections")
first = rospy.Publisher("~a", UInt32, queue_size=1)
say("alone", first.get_num_connections())
one = rospy.Subscriber("~a", UInt32)
block(1)
say("connected", first.get_num_connections(), one.get_num_connections())
two = rospy.Subscriber("~a", UInt32, print)
second = rospy.Publisher("~a", UInt32, queue_size=1)
block(1)
say("two of each", first.get_num_connections(), second.get_num_connections(), two.get_num_connections())
one.unregister()
block(1)
say("one of two", first.get_num_connections(), two.get_num_connections())
