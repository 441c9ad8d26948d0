"""A node of a student: one timer counts, another one prints and clears the count, under a lock."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark, say

lock = threading.Lock()
count = 0


def tick(event):
    global count
    with lock:
        count += 1


def report(event):
    global count
    with lock:
        counts.append(count)
        count = 0
    mark("report")


counts = []
begin("threads_node_rate_monitor")
rospy.Timer(rospy.Duration(P), tick)
block(0.5)
rospy.Timer(rospy.Duration(2 * P), report)
block(7)
say(counts)
end_after(0)
