"""A timer hands its work to a pool and keeps its period; the results are read when the node shuts down."""

from concurrent.futures import ThreadPoolExecutor

import rospy
from scenario import P, begin, block, mark, mark_event, say


def work(number):
    mark("begin")
    block(1.5)
    return number


def callback(event):
    mark_event("tick", event)
    futures.append(pool.submit(work, len(futures)))


begin("threads_pool_from_callback")
futures = []
pool = ThreadPoolExecutor(1)
rospy.on_shutdown(lambda: say([future.done() for future in futures]))
timer = rospy.Timer(rospy.Duration(P), callback)
block(3.5)
timer.shutdown()
rospy.signal_shutdown("enough")
