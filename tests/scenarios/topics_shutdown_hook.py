"""What a shutdown hook publishes arrives, in the same node, too; what is published later does not."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String


def hook():
    say("hook", rospy.is_shutdown())
    publisher.publish("from the hook")


begin("topics_shutdown_hook")
publisher = rospy.Publisher("~a", String, queue_size=10)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
rospy.on_shutdown(lambda: (hook(), block(0.5)))
block(1)
rospy.signal_shutdown("end")
publisher.publish("late")
block(0.5)
say("end")
