"""A node of a student: a moving average over the last three values of a sensor thread, read by a timer."""

import collections
import threading

import rospy
from scenario import P, begin, block, end_after, mark, say

lock = threading.Lock()
averages = []
values = collections.deque(maxlen=3)


def measure():
    for value in (3, 6, 9, 12, 15, 18):
        block(1)
        with lock:
            values.append(value)


def show(event):
    with lock:
        averages.append(sum(values) / len(values))
    mark("shown")


begin("threads_node_average")
threading.Thread(target=measure, daemon=True).start()
block(0.5)
rospy.Timer(rospy.Duration(2 * P), show)
block(6.2)
say(averages)
end_after(0)
