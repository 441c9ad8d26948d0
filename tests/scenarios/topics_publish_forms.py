"""A message, its fields in order, some by keyword, or nothing: what publish() takes."""

import rospy
from geometry_msgs.msg import Point
from scenario import begin, block, say
from std_msgs.msg import Empty, UInt32

begin("topics_publish_forms")
point = rospy.Publisher("~point", Point, queue_size=10)
rospy.Subscriber("~point", Point, lambda message: say("point", message.x, message.y, message.z))
number = rospy.Publisher("~number", UInt32, queue_size=10)
rospy.Subscriber("~number", UInt32, lambda message: say("number", message.data))
empty = rospy.Publisher("~empty", Empty, queue_size=10)
rospy.Subscriber("~empty", Empty, lambda message: say("empty", repr(message)))
block(1)
for publish in (
    lambda: point.publish(Point(1, 2, 3)),
    lambda: point.publish(4, 5.5, 6),
    lambda: point.publish(y=7),
    lambda: point.publish(),
    lambda: number.publish(8),
    lambda: number.publish(data=9),
    lambda: number.publish(True),
    lambda: number.publish(None),
    lambda: empty.publish(),
    lambda: empty.publish(Empty()),
):
    publish()
    block(0.3)
