#!/usr/bin/env python3

import rospy
from std_msgs.msg import UInt32


class SlowPyNode:
    def __init__(self):
        self.counter = -1
        self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)
        # Change 1 to 3, to 10 or to None, and run it again
        queue_size = rospy.get_param("~queue_size", 1)
        rospy.Subscriber(
            "counter", UInt32, self.counterCallback, queue_size=queue_size)
        rospy.sleep(0.5)
        self.timer = rospy.Timer(rospy.Duration(0.1), self.timerCallback)

    # Publish 0, 1, 2 up to 29, one every 0.1 s
    def timerCallback(self, event):
        self.counter += 1
        self.publisher.publish(self.counter)
        if self.counter == 29:
            self.timer.shutdown()

    # Take 0.8 s for each message
    def counterCallback(self, message):
        rospy.loginfo("[SLOW PY NODE] counter = " + str(message.data))
        rospy.sleep(0.8)


if __name__ == '__main__':
    rospy.init_node("slow_py_node")
    slow_py_node = SlowPyNode()
    rospy.spin()
