"""At Ctrl-C a hook publishes a last message, which arrives."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String


def stop():
    publisher.publish("stop")
    block(0.5)


begin("ctrl_c_topics_hook")
publisher = rospy.Publisher("~a", String, queue_size=1)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
rospy.on_shutdown(stop)
rospy.spin()
say("end", rospy.is_shutdown())
publisher.publish("late")
