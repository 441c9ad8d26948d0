"""callback_args is the callback's second argument, unless it is None."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_callback_args")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
for args in (None, 0, "text", (1, 2), {"a": 1}):
    rospy.Subscriber("~a", UInt32, lambda *given: say(len(given), *given[1:]), args)
block(1)
publisher.publish(1)
block(0.5)
