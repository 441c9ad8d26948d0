"""Nodes of ROS 1."""

from __future__ import annotations

from .ros import Ros, Words

__all__ = ["Ros1"]


class Ros1(Ros):
    number = 1
    roots = ("rospy", "genpy")
    beside = {
        "actionlib": "rospy.actionlib",
        "message_filters": "rospy.message_filters",
        "rosgraph": "rospy.graph",
        "roslib": "rospy.rospkg",
        "rospkg": "rospy.rospkg",
        "tf": "rospy.tf",
        "tf2_geometry_msgs": "rospy.tf2_geometry_msgs",
        "tf2_py": "rospy.tf2_ros",
        "tf2_ros": "rospy.tf2_ros",
    }
    needed = frozenset({"genpy", "rosgraph", "rosgraph_msgs", "roslib", "rospkg", "rospy", "std_msgs", "yaml"})
    name_key = "__name"
    raises = False
    in_terminals = False
    timers_are_threads = True
    words = Words("rospy.is_shutdown()", "rospy.sleep(0.1)", "rospy.spin()")
    killed_as = ", as roslaunch does"
    also_threads = " (a rospy.Timer is one, too)"
    _steps = "noted_steps.NotedThreads"
