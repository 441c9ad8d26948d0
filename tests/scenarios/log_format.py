"""ROSCONSOLE_FORMAT, in the parts that are the same in every run."""

import os

os.environ["ROSCONSOLE_FORMAT"] = "${severity}|${message}|${logger}|${node}|${function}|${line}|$$|${nonsense}"

import rospy  # noqa: E402


class Speaker:
    def speak(self):
        rospy.loginfo("from a method")


def speak():
    rospy.logwarn("from a function")


rospy.loginfo("before")
rospy.init_node("log_format")
rospy.loginfo("from the module")
speak()
Speaker().speak()
rospy.logerr("named", logger_name="mine")
rospy.loginfo("with ${severity} inside")
