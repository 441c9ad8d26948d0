"""The thread of a callback: always the same one, a daemon, and not the main thread."""

import threading

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

threads = []


def heard(message):
    thread = threading.current_thread()
    threads.append(thread)
    say(thread.name, thread.daemon, thread is threading.main_thread())


begin("topics_thread")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, heard)
block(1)
for number in range(3):
    publisher.publish(number)
    block(0.5)
say("threads", len(set(threads)))
