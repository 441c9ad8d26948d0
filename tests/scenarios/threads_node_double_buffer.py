"""A node of a student: a timer fills one buffer while the main works on the other; a lock guards the exchange only."""

import threading

import rospy
from scenario import P, begin, block, mark, say


class Buffers:
    def __init__(self):
        self._lock = threading.Lock()
        self._front, self._back = [], []

    def add(self, event):
        with self._lock:
            self._back.append(event.current_expected)

    def swap(self):
        with self._lock:
            self._front, self._back = self._back, []
        return self._front


begin("threads_node_double_buffer")
buffers = Buffers()
rospy.Timer(rospy.Duration(P), buffers.add)
for periods in (2.5, 1, 3):
    block(periods)
    say(len(buffers.swap()))
    mark("swap")
