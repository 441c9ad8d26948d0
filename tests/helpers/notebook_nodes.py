"""The node that each notebook shows."""

from __future__ import annotations

ROS1, ROS2 = "my_robotics_pkg/src", "my_robotics_pkg_ros2/my_robotics_pkg"
NODES = {
    "timer": f"{ROS1}/spinner_py_node.py",
    "rate": f"{ROS1}/spinner_rate_py_node.py",
    "publish": f"{ROS1}/pubsub_py_node.py",
    "ros2-timer": f"{ROS2}/spinner_py_node.py",
    "ros2-rate": f"{ROS2}/spinner_rate_py_node.py",
    "ros2-publish": "topics/ros2/pubsub_py_node.py",
}

# And its node in C++.
IN_CPP = {
    "timer": f"{ROS1}/spinner_cpp_node.cpp",
    "rate": f"{ROS1}/spinner_rate_cpp_node.cpp",
    "ros2-timer": "my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp",
    "ros2-rate": "my_robotics_pkg_ros2_cpp/src/spinner_rate_cpp_node.cpp",
}
