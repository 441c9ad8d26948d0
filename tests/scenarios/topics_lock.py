"""A callback and a timer share data under a lock."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32

lock = threading.Lock()
latest = [None]


def heard(message):
    with lock:
        latest[0] = message.data
        block(0.5)


def report(event):
    with lock:
        say("latest", latest[0])
        mark("report")


begin("topics_lock")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Subscriber("~a", UInt32, heard)
block(1)
rospy.Timer(rospy.Duration(P), report)
for number in range(3):
    block(0.8)
    publisher.publish(number)
end_after(1.5)
