"""A node of a student: a worker that is started and stopped several times, each time with a thread of its own."""

import threading

import rospy
from scenario import P, begin, block, mark, say


class Worker:
    def __init__(self):
        self._running = threading.Event()
        self._thread = None

    def start(self):
        self._running.set()
        self._thread = threading.Thread(target=self._work)
        self._thread.start()

    def stop(self):
        self._running.clear()
        self._thread.join()
        mark("stopped")

    def _work(self):
        rate = rospy.Rate(1 / P)
        while self._running.is_set():
            mark("work")
            rate.sleep()


begin("threads_node_restarted")
worker = Worker()
for _ in range(2):
    worker.start()
    block(2.5)
    worker.stop()
    block(1)
say(threading.active_count() - len([thread for thread in threading.enumerate() if thread.is_alive()]))
