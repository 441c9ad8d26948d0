"""What is published before a subscriber is connected is lost, without a word."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_first_lost")
rospy.Subscriber("~a", UInt32, lambda message: say("got", message.data))
block(1)
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
for number in range(5):
    publisher.publish(number)
say("connections", publisher.get_num_connections())
block(1)
say("connections", publisher.get_num_connections())
publisher.publish(5)
block(1)
