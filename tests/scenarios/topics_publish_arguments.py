"""Arguments of publish() that make no message: errors of the call, which leave the connection as it is."""

import rospy
from scenario import attempt, begin, block, say
from std_msgs.msg import Empty, Int32, String, UInt32

begin("topics_publish_arguments")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, lambda message: say("got", message.data))
empty = rospy.Publisher("~empty", Empty, queue_size=10)
block(1)
names = {"publisher": publisher, "empty": empty, "Int32": Int32, "String": String, "UInt32": UInt32}
for text in (
    "publisher.publish(Int32(1))",
    "publisher.publish(1, 2)",
    "publisher.publish(foo=1)",
    "publisher.publish(1, data=1)",
    "empty.publish(1)",
    "empty.publish(String('a'))",
):
    attempt(text, names)
publisher.publish(UInt32(5))
block(0.3)
