#!/usr/bin/env python3

import rospy


# The light barrier sees a part
def read_barrier():
    return 1


class PartsPyNode:
    def __init__(self):
        self.parts = 0
        # Each timer calls back in a thread of its own
        rospy.Timer(rospy.Duration(0.1), self.leftCallback)
        rospy.Timer(rospy.Duration(0.1), self.rightCallback)
        rospy.Timer(rospy.Duration(1.05), self.reportCallback)

    # A part passes on the left belt
    def leftCallback(self, event):
        self.parts += read_barrier()

    # A part passes on the right belt
    def rightCallback(self, event):
        self.parts += read_barrier()

    def reportCallback(self, event):
        rospy.loginfo("[PARTS] parts = " + str(self.parts))


if __name__ == "__main__":
    rospy.init_node("parts_py_node")
    PartsPyNode()
    rospy.spin()
