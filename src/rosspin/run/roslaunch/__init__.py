"""Launch files of ROS 1, and what roslaunch does with their nodes."""
