"""A node of a student: a timer, a filter and a printer are connected by queues; the slowest sets the pace."""

import queue
import threading

import rospy
from scenario import P, begin, block, mark, say


def stage(name, source, target, periods):
    while (value := source.get()) is not None:
        block(periods)
        mark(name)
        target.put(value * 10)
    target.put(None)


begin("threads_node_pipeline")
raw, filtered, ready = queue.Queue(), queue.Queue(), queue.Queue()
threading.Thread(target=stage, args=("filter", raw, filtered, 0.5)).start()
threading.Thread(target=stage, args=("slow", filtered, ready, 1.75)).start()
counter = iter(range(1, 5))
timer = rospy.Timer(rospy.Duration(P), lambda event: raw.put(next(counter, None)))
say(list(iter(ready.get, None)))
mark("end")
timer.shutdown()
