#!/usr/bin/env python3

import rospy
from std_msgs.msg import UInt32


class EagerPyNode:
    def __init__(self):
        self.counter = 0
        # Change False to True, and run it again
        latch = rospy.get_param("~latch", False)
        self.publisher = rospy.Publisher(
            "counter", UInt32, latch=latch, queue_size=10)
        rospy.Subscriber("counter", UInt32, self.counterCallback)
        # Publish immediately, and then every 0.5 s
        self.timerCallback(None)
        rospy.Timer(rospy.Duration(0.5), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        self.publisher.publish(self.counter)

    def counterCallback(self, message):
        rospy.loginfo("[EAGER PY NODE] counter = " + str(message.data))


if __name__ == '__main__':
    rospy.init_node("eager_py_node")
    eager_py_node = EagerPyNode()
    rospy.spin()
