"""A loop over Queue.get with a timeout looks at is_shutdown each time, and ends after Ctrl-C."""

import queue

import rospy
from scenario import P, begin, mark, say

values = queue.Queue()
begin("ctrl_c_threads_queue_timeout")
while not rospy.is_shutdown():
    mark("pass")
    try:
        values.get(timeout=P)
    except queue.Empty:
        pass
say("the loop has ended")
