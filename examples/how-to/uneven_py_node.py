#!/usr/bin/env python3

import rospy


class UnevenPyNode:
    def __init__(self):
        self.counter = 0
        rospy.Timer(rospy.Duration(0.1), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        message = "[UNEVEN PY NODE] counter = " + str(self.counter)

        # When was the last call, and how long did it take?
        if event.last_real is not None:
            since = (event.current_real - event.last_real).to_sec()
            message += ", %.3f s after a call that took %.3f s" % (
                since, event.last_duration)
        rospy.loginfo(message)

        # Every fifth call has more to do
        if self.counter % 5 == 0:
            rospy.sleep(0.25)


if __name__ == '__main__':
    rospy.init_node("uneven_py_node")
    uneven_py_node = UnevenPyNode()
    rospy.spin()
