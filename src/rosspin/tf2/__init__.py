"""Transforms between frames over time: what tf2's core does, without ROS and without numpy."""
