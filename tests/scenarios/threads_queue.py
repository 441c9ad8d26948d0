"""A timer's callback puts numbers into a queue, a worker takes them, slowly; None ends it."""

import queue
import threading

import rospy
from scenario import P, begin, block, mark, say

numbers = queue.Queue()


def work():
    while (number := numbers.get()) is not None:
        mark("take")
        block(1.75)
        done.append(number)


def callback(event):
    put.append(len(put))
    numbers.put(put[-1])
    mark("put")


begin("threads_queue")
put, done = [], []
worker = threading.Thread(target=work)
worker.start()
timer = rospy.Timer(rospy.Duration(P), callback)
block(3.25)
timer.shutdown()
timer.join()
say("waiting", numbers.qsize(), numbers.empty(), numbers.full())
numbers.put(None)
worker.join()
mark("joined")
say(done)
