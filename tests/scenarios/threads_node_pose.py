"""A node of a student: a timer changes a pose in two steps, the main prints it; with the lock it never sees half."""

import threading

import rospy
from scenario import P, begin, block, mark, say


class Pose:
    def __init__(self):
        self._lock = threading.Lock()
        self._x = self._y = 0

    def step(self, event):
        with self._lock:
            self._x += 1
            block(0.8)
            self._y += 1

    def read(self):
        with self._lock:
            return self._x, self._y


begin("threads_node_pose")
pose = Pose()
rospy.Timer(rospy.Duration(2 * P), pose.step)
for wait in (2.4, 1.6, 0.6, 1):
    block(wait)
    say(pose.read())
    mark("read")
