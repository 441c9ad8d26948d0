"""The course's smallest node: a timer publishes a counter, and a subscriber logs it."""

import rospy
from scenario import P, begin, end_after, mark
from std_msgs.msg import UInt32


class Node:
    def __init__(self):
        self.counter = 0
        self.publisher = rospy.Publisher("~counter", UInt32, queue_size=1)
        rospy.Subscriber("~counter", UInt32, self.heard)
        rospy.Timer(rospy.Duration(P), self.tick)

    def tick(self, event):
        self.counter += 1
        self.publisher.publish(self.counter)

    def heard(self, message):
        rospy.loginfo("counter = %d", message.data)
        mark("heard")


begin("topics_timer")
Node()
end_after(5.5)
