"""A node of a student: a timer puts tokens into a bucket, three workers need one for each thing that they do."""

import threading

import rospy
from scenario import P, begin, mark, say

tokens = threading.Semaphore(2)


def work():
    for _ in range(2):
        with lock:
            tokens.acquire()
            mark("work")


begin("threads_node_tokens")
lock = threading.Lock()
timer = rospy.Timer(rospy.Duration(P), lambda event: tokens.release())
workers = [threading.Thread(target=work) for _ in range(3)]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
timer.shutdown()
say("left", tokens.acquire(blocking=False))
