#!/usr/bin/env python3

import rospy
from geometry_msgs.msg import Twist
from sensor_msgs.msg import Range


class ControllerPyNode:
    def __init__(self):
        self.range = 0.0
        self.last_heard = None
        self.publisher = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        rospy.Subscriber("range", Range, self.rangeCallback, queue_size=1)
        rospy.Timer(rospy.Duration(0.02), self.timerCallback)

    def rangeCallback(self, message):
        self.range = message.range
        self.last_heard = rospy.Time.now()

    def timerCallback(self, event):
        command = Twist()
        if self.isSensorAlive() and self.range > 1.0:
            command.linear.x = 0.5
        self.publisher.publish(command)

    def isSensorAlive(self):
        if self.last_heard is None:
            return False
        return rospy.Time.now() - self.last_heard < rospy.Duration(0.2)


if __name__ == '__main__':
    rospy.init_node("controller_py_node")
    controller_py_node = ControllerPyNode()
    rospy.spin()
