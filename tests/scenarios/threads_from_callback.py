"""A callback hands slow work to a thread of its own: the timer keeps its period, the works overlap."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark, mark_event


def work(number):
    block(1.5)
    mark(f"done{number}")


def callback(event):
    workers.append(threading.Thread(target=work, args=(len(workers) + 1,)))
    workers[-1].start()
    mark_event("tick", event)


begin("threads_from_callback")
workers = []
rospy.Timer(rospy.Duration(P), callback)
end_after(3.75)
for worker in workers:
    worker.join()
mark("joined")
