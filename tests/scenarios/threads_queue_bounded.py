"""A full queue slows a timer's callback down to the pace of the worker."""

import queue
import threading

import rospy
from scenario import P, begin, block, end_after, mark

numbers = queue.Queue(2)


def work():
    while True:
        block(2.25)
        numbers.get()
        mark("take")


def callback(event):
    mark("begin")
    numbers.put(event)
    mark("end_of_put")


begin("threads_queue_bounded")
threading.Thread(target=work, daemon=True).start()
rospy.Timer(rospy.Duration(P), callback)
end_after(8.3)
