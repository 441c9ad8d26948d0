"""A node's world, whichever ROS it is for."""
