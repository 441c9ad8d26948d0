"""A subscriber always gets the newest message: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Steer by the newest position"
TEXT = """
**You need**: [the second tutorial](../docs/publish.rst), [the notebook on publishing](publish.md), and for some answers
[data that callbacks share](../docs/how-to/shared-data.rst).

A sensor publishes a robot's position every 0.1 s. The controller needs 0.33 s for a step and falls behind: run it, and
compare the timestamps with the positions, which are tenths of a second. Each step should use a position at most 0.1 s
old. Change neither the sensor nor how long a step takes.
"""
REVEALS = "A subscriber always gets the newest message. It is the publisher's queue that has to be short."

NODE = """
import rospy
from std_msgs.msg import UInt32


class Sensor:
    def __init__(self):
        self.position = 0
        self.publisher = rospy.Publisher("position", UInt32, queue_size=10)
        rospy.Timer(rospy.Duration(0.1), self.timerCallback)

    def timerCallback(self, event):
        self.position += 1
        self.publisher.publish(self.position)


class Controller:
    def __init__(self):
        rospy.Subscriber("position", UInt32, self.positionCallback)

    def positionCallback(self, message):
        rospy.loginfo("[CONTROLLER] position = " + str(message.data))
        rospy.sleep(0.33)  # the computation


if __name__ == '__main__':
    rospy.init_node("controller_py_node")
    controller = Controller()
    sensor = Sensor()
    rospy.spin()
"""

HINTS = [
    "Where are the positions that were published, but not used?",
    "Without a `queue_size`, a `rospy.Subscriber` keeps them all, in order.",
    "How many should wait if only the newest is useful?",
]
HINT = "The subscriber has a queue, too: `queue_size` says how many messages may wait there."

check = by.run(10.0, by.steers_by_the_newest())

SOLUTION = {"self.positionCallback": "self.positionCallback, queue_size=1"}
AFTER = """
A callback that stores the position, and a loop that computes with the last one, works as well.
"""

SIZE = ", queue_size=1)"
NEWEST = "self.positionCallback, queue_size=1)"
STEP = """        rospy.loginfo("[CONTROLLER] position = " + str(message.data))
        rospy.sleep(0.33)  # the computation"""
STORES = {  # the callback stores the position, and LOOP uses it
    SIZE: ")\n        self.newest = None",
    STEP: "        self.newest = message.data",
}
LOOPS = """    while not rospy.is_shutdown():
        if controller.newest is None:
            rospy.sleep(0.01)
            continue
        rospy.loginfo("[CONTROLLER] position = " + str(controller.newest))
        rospy.sleep(0.33)"""

RIGHT = [
    {"Subscriber(": "Subscriber(name=", "UInt32, self.pos": "data_class=UInt32, callback=self.pos"},
    {**STORES, "    rospy.spin()": LOOPS},
    {
        **STORES,
        SIZE: ")\n        self.newest = None\n        rospy.Timer(rospy.Duration(0.33), self.step)\n\n"
        "    def step(self, event):\n        if self.newest is None:\n            return\n"
        '        rospy.loginfo("[CONTROLLER] position = " + str(self.newest))\n        rospy.sleep(0.33)',
    },
    {
        **STORES,
        SIZE: ")\n        import threading\n        self.turn = threading.Condition()\n        self.newest = None\n"
        "        threading.Thread(target=self.steps, daemon=True).start()\n\n    def steps(self):\n"
        "        while True:\n            with self.turn:\n                self.turn.wait()\n"
        '            rospy.loginfo("[CONTROLLER] position = " + str(self.newest))\n            rospy.sleep(0.33)',
        STEP: "        with self.turn:\n            self.newest = message.data\n            self.turn.notify()",
    },
    {
        **STORES,
        SIZE: ")\n        import queue, threading\n        self.queue = queue.LifoQueue()\n"
        "        threading.Thread(target=self.steps, daemon=True).start()\n\n    def steps(self):\n"
        "        while True:\n            newest = self.queue.get()\n"
        '            rospy.loginfo("[CONTROLLER] position = " + str(newest))\n            rospy.sleep(0.33)',
        STEP: "        self.queue.put(message.data)",
    },
    {"rospy.sleep(0.33)": "rospy.sleep(0.35)"},
]
WRONG = [
    (
        {SIZE: ")", "str(message.data)": "str(sensor.position)"},
        "printed position 4, but the message that it got held 2",
        "in another process",
    ),
    (
        {SIZE: ")"},
        "at 0.43 s the controller steered by position 2, which was 0.23 s old",
        "how many messages may wait there",
    ),
    ({SIZE: ")", "queue_size=10": "queue_size=1"}, "steered by position 2", "has a queue, too"),
    ({NEWEST: "self.positionCallback, queue_size=2)"}, "A newer one had arrived", "has a queue, too"),
    ({NEWEST: "self.positionCallback, queue_size=10)"}, "A newer one had arrived", "has a queue, too"),
    ({NEWEST: "self.positionCallback, queue_size=0)"}, "queue size may not be set to zero", "has a queue, too"),
    ({NEWEST: 'self.positionCallback, queue_size="1")'}, "queue size must be an integer", "has a queue, too"),
    ({"rospy.sleep(0.33)": "rospy.sleep(0.05)"}, "less than 0.33 s after the last time", "takes 0.33 s"),
    (
        {"        rospy.loginfo": "        rospy.sleep(0.33)\n        rospy.loginfo", "0.33)  #": "0)  #"},
        "at 0.43 s the controller steered by position 1, which was 0.33 s old",
        "print it first, and then compute",
    ),
    ({"position += 1": "position += 10"}, "the sensor published position 10", "The sensor should stay as it is."),
    ({"Duration(0.1)": "Duration(0.4)"}, "the sensor published 25 positions", "The sensor should stay as it is."),
    (
        {'position = " + str(message.data)': 'position = " + str(message)'},
        "is not a position that",
        "A message is not yet its number:",
    ),
    (
        {"        rospy.sleep(0.33)": "        raise RuntimeError\n        rospy.sleep(0.33)"},
        "RuntimeError",
        "has a queue, too",
    ),
    (
        {"        rospy.Subscriber": "        pass  # "},
        "the controller: nothing subscribes to `/position`.",
        "The subscription uses the publisher's topic, letter by letter",
    ),
    (
        {NEWEST: "self.positionCallback(), queue_size=1)"},
        "missing 1 required positional",
        "Pass the function on without calling it:",
    ),
    (
        {"rospy.sleep(0.33)": "rospy.sleep(0.6)"},
        "the controller steered 17 times",
        "From one step to the next it took up to 0.6 s.",
    ),
]
