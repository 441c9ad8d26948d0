"""Without a connection no value is checked; arguments are."""

import rospy
from scenario import attempt, begin
from std_msgs.msg import String, UInt32

begin("topics_publish_unconnected")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
names = {"publisher": publisher, "String": String, "UInt32": UInt32}
for text in (
    "publisher.publish(-1)",
    "publisher.publish('a')",
    "publisher.publish(1, 2)",
    "publisher.publish(UInt32('a'))",
):
    attempt(text, names)
attempt("publisher.publish(String('a'))", names)
