"""The main waits for an event that a callback sets."""

import threading

import rospy
from scenario import P, begin, mark, say
from std_msgs.msg import UInt32

heard = threading.Event()
begin("topics_event")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Subscriber("~a", UInt32, lambda message: heard.set())
rospy.Timer(rospy.Duration(2 * P), lambda event: publisher.publish(1), oneshot=True)
say("heard", heard.wait(10 * P))
mark("heard")
