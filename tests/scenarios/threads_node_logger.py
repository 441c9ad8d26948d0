"""A node of a student: the callbacks put their lines into a queue, one thread logs them."""

import queue
import threading

import rospy
from scenario import P, begin, block, mark

lines = queue.Queue()


def log():
    while True:
        text, *values = lines.get()
        rospy.loginfo(text, *values)
        mark("logged")
        block(0.6)
        lines.task_done()


begin("threads_node_logger")
threading.Thread(target=log, daemon=True).start()
timer = rospy.Timer(rospy.Duration(P), lambda event: lines.put(("tick of %s", "the timer")))
block(0.5)
lines.put(("the main",))
block(3)
timer.shutdown()
lines.join()
mark("all_logged")
