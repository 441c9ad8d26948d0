"""A SimpleQueue between a timer and a worker; get with a timeout, and Empty."""

import queue
import threading

import rospy
from scenario import P, attempt, begin, block, mark, say


def work():
    while True:
        try:
            value = values.get(timeout=1.5 * P)
        except queue.Empty:
            mark("empty")
            return
        mark("take")
        if value == 2:
            block(2.5)


begin("threads_simple_queue")
values = queue.SimpleQueue()
worker = threading.Thread(target=work)
worker.start()
counter = iter(range(1, 100))
timer = rospy.Timer(rospy.Duration(P), lambda event: values.put(next(counter)))
block(5.5)
timer.shutdown()
worker.join()
mark("joined")
names = {"values": values}
attempt("values.get_nowait()", names)
attempt("values.get(False)", names)
attempt("values.get(timeout=-1)", names)
say(values.put(1, block=False, timeout=0), values.qsize(), values.get())
