"""Topics have names as all that ROS names: relative, private, global, remapped."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_names")
for name in ("a", "~a", "/topics_names/g/a", "b/", "old", "~private"):
    publisher = rospy.Publisher(name, UInt32, queue_size=1)
    say(name, publisher.name, publisher.resolved_name, publisher.type, publisher.md5sum)
subscriber = rospy.Subscriber("new", UInt32, lambda message: say("got", message.data))
old = rospy.Publisher("old", UInt32, queue_size=1)
block(1)
old.publish(1)
block(0.5)
