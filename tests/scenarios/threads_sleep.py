"""time.sleep and rospy.sleep in several threads at once: each sleeps its own time."""

import threading
import time

import rospy
from scenario import P, begin, mark


def work(name, sleep, *durations):
    for duration in durations:
        sleep(duration)
        mark(name)


begin("threads_sleep")
workers = [
    threading.Thread(target=work, args=("time", time.sleep, P, 0.5 * P, 0, 2 * P)),
    threading.Thread(target=work, args=("rospy", rospy.sleep, 1.5 * P, rospy.Duration(1.5 * P), -1, 0)),
    threading.Thread(target=work, args=("rate", lambda hz: rospy.Rate(hz).sleep(), 1 / P, 0.5 / P)),
]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
mark("all")
