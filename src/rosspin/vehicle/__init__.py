"""A vehicle that follows a line: how it moves, what a run shows of it, and its node for each ROS.

``from rosspin.vehicle.ros2 import vehicle`` or ``.ros1`` is a node, to be run together with one that steers it:
``rosspin.start([my_node, vehicle])``.
"""

from __future__ import annotations

from . import ros1, ros2

__all__ = ["VEHICLES"]

VEHICLES = {1: ros1.vehicle, 2: ros2.vehicle}
"""The vehicle as a node, by its ROS."""
