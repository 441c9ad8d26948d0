"""The real ROS, where it is installed."""
