"""The clocks of the time module run alike in a thread and in the main."""

import threading
import time

import rospy
from scenario import P, begin, block, mark

CLOCKS = ("time", "monotonic", "perf_counter")


def measure(name, periods):
    before = [getattr(time, clock)() for clock in CLOCKS] + [rospy.get_time()]
    before_ns = [getattr(time, clock + "_ns")() for clock in CLOCKS]
    block(periods)
    after = [getattr(time, clock)() for clock in CLOCKS] + [rospy.get_time()]
    after_ns = [getattr(time, clock + "_ns")() for clock in CLOCKS]
    for clock, start, end in zip((*CLOCKS, "ros"), before, after):
        mark(f"{name}_{clock}", end - start)
    for clock, start, end in zip(CLOCKS, before_ns, after_ns):
        mark(f"{name}_{clock}_ns", (end - start) / 1e9)


begin("threads_clocks")
worker = threading.Thread(target=measure, args=("thread", 2))
worker.start()
measure("main", 1)
worker.join()
timer = rospy.Timer(rospy.Duration(P), lambda event: measure("timer", 1), oneshot=True)
timer.join()
