"""What was published before unregister() arrives; after it publish() is an error."""

import rospy
from scenario import attempt, begin, block, say
from std_msgs.msg import UInt32

begin("topics_unregister_publisher")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
other = rospy.Publisher("~a", UInt32, queue_size=10)
subscriber = rospy.Subscriber("~a", UInt32, lambda message: say("got", message.data))
block(1)
publisher.publish(1)
block(0.3)
publisher.unregister()
publisher.unregister()
attempt("publisher.publish(2)", {"publisher": publisher})
other.publish(3)
block(0.3)
say("connections", subscriber.get_num_connections())
other.unregister()
block(1)
say("connections", subscriber.get_num_connections())
other = rospy.Publisher("~a", UInt32, queue_size=10)
other.publish(4)
block(1)
other.publish(5)
block(0.3)
