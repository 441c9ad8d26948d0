"""A second Subscriber of a latched topic in a node is called inside of its constructor, by the caller's thread."""

import threading

import rospy
from scenario import begin, block, say
from std_msgs.msg import String

main = threading.current_thread()


def heard(name):
    return lambda message: say(name, message.data, threading.current_thread() is main)


begin("topics_latch_second")
publisher = rospy.Publisher("~a", String, queue_size=10, latch=True)
publisher.publish("word")
block(1)
rospy.Subscriber("~a", String, heard("first"))
block(1)
say("before")
rospy.Subscriber("~a", String, heard("second"))
say("after")
