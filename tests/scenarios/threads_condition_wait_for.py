"""A callback fills a list, the main waits for its third element with wait_for."""

import threading

import rospy
from scenario import P, begin, mark, say

condition = threading.Condition(threading.Lock())
values = []


def callback(event):
    with condition:
        values.append(len(values))
        mark("value")
        condition.notify()


begin("threads_condition_wait_for")
timer = rospy.Timer(rospy.Duration(P), callback)
with condition:
    condition.wait_for(lambda: len(values) == 3)
    mark("three")
    say(values)
timer.shutdown()
timer.join()
mark("joined")
