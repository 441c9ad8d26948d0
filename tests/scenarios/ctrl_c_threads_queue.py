"""Ctrl-C while the main waits for a queue: a shutdown hook puts the last element into it."""

import queue

import rospy
from scenario import P, begin, mark, say

values = queue.Queue()
begin("ctrl_c_threads_queue")
rospy.on_shutdown(lambda: values.put(None))
rospy.Timer(rospy.Duration(P), lambda event: values.put(event))
while values.get() is not None:
    mark("take")
say("the loop has ended")
