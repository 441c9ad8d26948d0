"""Launch files of ROS 2: what they import, and what ``ros2 launch`` does with their nodes."""
