"""A vehicle that follows a line: how it moves, what a run shows of it, and its node for each ROS.

``from rosspin.vehicle.ros2 import vehicle`` or ``.ros1`` is a node, to be run beside one that steers it:
``rosspin.start([my_node, vehicle])``.
"""
