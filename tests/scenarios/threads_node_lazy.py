"""A node of a student: two timers need a sensor that is opened at the first need, once, behind a lock."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark, say


class Sensor:
    _lock = threading.Lock()
    _instance = None

    def __init__(self):
        mark("opens")
        block(2)

    @classmethod
    def get(cls):
        if cls._instance is None:
            with cls._lock:
                if cls._instance is None:
                    cls._instance = cls()
        return cls._instance


def callback(name):
    def call(event):
        sensors.append(Sensor.get())
        mark(name)

    return call


begin("threads_node_lazy")
sensors = []
rospy.Timer(rospy.Duration(P), callback("first"), oneshot=True)
block(0.5)
rospy.Timer(rospy.Duration(P), callback("second"), oneshot=True)
rospy.Timer(rospy.Duration(3.5 * P), callback("third"), oneshot=True)
end_after(4.5)
say(len(sensors), len(set(map(id, sensors))))
