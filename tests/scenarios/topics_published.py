"""get_published_topics() tells the topics that have a publisher."""

import rospy
from scenario import begin, say
from std_msgs.msg import String, UInt32

begin("topics_published")


def topics():
    return sorted(rospy.get_published_topics(rospy.get_name()))


say(topics())
rospy.Subscriber("~c", UInt32)
publisher = rospy.Publisher("~b", UInt32, queue_size=1)
rospy.Publisher("~a/x", String, queue_size=1)
say(topics())
say(rospy.get_published_topics(rospy.get_name() + "/a"))
say([name for name, _ in rospy.get_published_topics() if name == "/rosout"])
publisher.unregister()
say(topics())
