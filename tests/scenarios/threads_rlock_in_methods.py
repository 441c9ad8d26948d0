"""A class whose methods call one another under one RLock, used by two timers and the main."""

import threading

import rospy
from scenario import P, begin, block, mark, until


class Account:
    def __init__(self):
        self._lock = threading.RLock()
        self.total = 0

    def add(self, amount):
        with self._lock:
            total = self.total
            block(0.5)
            self.total = total + amount

    def add_twice(self, amount):
        with self._lock:
            self.add(amount)
            self.add(amount)


begin("threads_rlock_in_methods")
account = Account()
rospy.Timer(rospy.Duration(P), lambda event: account.add(1), oneshot=True)
rospy.Timer(rospy.Duration(1.25 * P), lambda event: account.add_twice(10), oneshot=True)
until(1.9)
account.add(100)
mark("done")
print("total", account.total)
