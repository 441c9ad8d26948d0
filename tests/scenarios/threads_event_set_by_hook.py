"""A thread waits for an event that a shutdown hook sets."""

import threading

import rospy
from scenario import P, begin, mark, say

stop = threading.Event()


def work():
    while not stop.wait(P):
        mark("pass")
    mark("stopped")
    say("is_shutdown", rospy.is_shutdown())


def stop_worker():
    mark("hook")
    stop.set()
    worker.join()


begin("threads_event_set_by_hook")
worker = threading.Thread(target=work)
worker.start()
rospy.on_shutdown(stop_worker)
rospy.sleep(2.5 * P)
rospy.signal_shutdown("enough")
print("end", rospy.is_shutdown())
