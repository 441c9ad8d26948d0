"""With disable_signals a KeyboardInterrupt ends Queue.get and leaves the queue usable."""

import queue

import rospy
from scenario import begin, mark, say

values = queue.Queue()
begin("ctrl_c_threads_no_signals_queue", disable_signals=True)
try:
    values.get()
except KeyboardInterrupt:
    mark("caught")
values.put("usable")
say(values.get(timeout=1), rospy.is_shutdown())
