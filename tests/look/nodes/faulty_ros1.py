"""A node of ROS 1 with the faults that its command line asks for: NAME ACTIVITY..."""

import sys
import time
from threading import Lock, Thread

import rospy
from std_msgs.msg import Int64

sys.path.insert(0, __file__.rpartition("/")[0])
from activities import Activity  # noqa: E402

lock = Lock()


def locked(activity):
    """With the option ``lock``, one of these activities at a time."""

    def call(*args):
        with lock:
            activity()

    return call if activity.get("lock") else lambda *args: activity()


def until_the_end(activity, sleep):
    try:
        activity.loop(sleep)
    except rospy.ROSInterruptException:
        pass


def add(activity):
    if activity.kind == "timer":
        rospy.Timer(rospy.Duration(1 / activity.rate), locked(activity))
    elif activity.kind == "burst":
        rospy.Timer(rospy.Duration(1 / activity.rate), activity.burst)
    elif activity.kind == "sleep":
        Thread(target=until_the_end, args=[activity, lambda: rospy.sleep(1 / activity.rate)], daemon=True).start()
    elif activity.kind == "rate":
        Thread(target=until_the_end, args=[activity, rospy.Rate(activity.rate).sleep], daemon=True).start()
    elif activity.kind == "event":
        wait = lambda: time.sleep(activity.random.expovariate(activity.rate))  # noqa: E731
        Thread(target=activity.loop, args=[wait], daemon=True).start()
    elif activity.kind == "gc":
        Thread(target=activity.collect_garbage, daemon=True).start()
    elif activity.kind == "pub":
        publisher = rospy.Publisher("heading", Int64, queue_size=10)
        start = int(activity.get("first"))

        def publish(event):
            publisher.publish(start + activity.count + 1)
            activity()

        rospy.Timer(rospy.Duration(1 / activity.rate), publish)
    elif activity.kind == "sub":
        depth = int(activity.get("queue") or 10)
        rospy.Subscriber("heading", Int64, lambda message: activity(message.data), queue_size=depth)


words = sys.argv[1:]
if words[-1].startswith("after="):
    time.sleep(float(words.pop().partition("=")[2]))
rospy.init_node(words[0])
for word in words[1:]:
    add(Activity(word, rospy.loginfo))
rospy.spin()
