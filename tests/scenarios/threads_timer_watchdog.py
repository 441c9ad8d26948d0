"""A student's watchdog: each tick restarts a threading.Timer; when ticks stay away it barks, once."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark


class Watchdog:
    def __init__(self, timeout):
        self._timeout = timeout
        self._lock = threading.Lock()
        self._timer = None

    def wind_up(self):
        with self._lock:
            if self._timer is not None:
                self._timer.cancel()
            self._timer = threading.Timer(self._timeout, self.bark)
            self._timer.daemon = True
            self._timer.start()

    def bark(self):
        mark("bark")
        rospy.logwarn("no tick for %.1f s", self._timeout)


def callback(event):
    mark("tick")
    watchdog.wind_up()
    calls.append(event)
    if len(calls) == 3:
        block(2.6)


begin("threads_timer_watchdog")
calls = []
watchdog = Watchdog(1.6 * P)
watchdog.wind_up()
rospy.Timer(rospy.Duration(P), callback)
end_after(7.25)
