"""A Publisher may be made before init_node(); it publishes and connects only after it."""

import rospy
from scenario import attempt, begin, block, say
from std_msgs.msg import UInt32

publisher = rospy.Publisher("topics_before_init/a", UInt32, queue_size=1)
subscriber = rospy.Subscriber("topics_before_init/a", UInt32, lambda message: say("got", message.data))
attempt("publisher.publish(1)", {"publisher": publisher})
attempt("rospy.Publisher('~a', UInt32, queue_size=1)", {"UInt32": UInt32})
begin("topics_before_init")
block(1)
say(publisher.get_num_connections(), subscriber.get_num_connections())
publisher.publish(2)
block(0.5)
