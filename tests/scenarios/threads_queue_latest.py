"""A queue of one place that keeps only the latest value: a quick timer, a slow loop in the main."""

import queue

import rospy
from scenario import P, begin, block, mark, say

latest = queue.Queue(1)


def callback(event):
    counter.append(len(counter) + 1)
    try:
        latest.put_nowait(counter[-1])
    except queue.Full:
        dropped.append(latest.get_nowait())
        latest.put_nowait(counter[-1])


begin("threads_queue_latest")
counter, dropped, taken = [], [], []
rospy.Timer(rospy.Duration(P), callback)
block(0.5)
rate = rospy.Rate(1 / (3 * P))
for _ in range(3):
    rate.sleep()
    taken.append(latest.get())
    mark("take")
say("taken", taken, "dropped", dropped)
