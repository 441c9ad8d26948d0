"""What tf2_geometry_msgs has in both ROSes: what messages of geometry_msgs hold is moved into another frame."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

from .geometry import IDENTITY, Transform

__all__ = ["Compose", "empty", "moved", "moved_vector", "set_pose", "set_vector"]

Compose = Callable[[Transform, Transform], Transform]
"""Makes the transform that does the second and then the first, with the rotation that a ROS makes of it."""


def empty(name: str, header: Any) -> Any:
    """Make an empty message of geometry_msgs of the ROS of the node, with a header."""
    made = getattr(import_module("geometry_msgs.msg"), name)()
    made.header = header
    return made


def moved(compose: Compose, stamped: Any, place: Any, turn: Any = None) -> Transform:
    """Move a place, and a quaternion if there is one, by a TransformStamped."""
    move, by = stamped.transform.translation, stamped.transform.rotation
    rotation = (turn.x, turn.y, turn.z, turn.w) if turn else IDENTITY.rotation
    what = Transform((place.x, place.y, place.z), rotation)
    return compose(Transform((move.x, move.y, move.z), (by.x, by.y, by.z, by.w)), what)


def moved_vector(compose: Compose, stamped: Any, vector: Any) -> Transform:
    """Rotate a vector by a TransformStamped, whose translation becomes 0."""
    move = stamped.transform.translation
    move.x = move.y = move.z = 0.0
    return moved(compose, stamped, vector)


def set_vector(vector: Any, transform: Transform) -> None:
    """Put a place into a point or a vector."""
    vector.x, vector.y, vector.z = transform.translation


def set_pose(pose: Any, transform: Transform) -> None:
    """Put a place and a quaternion into a pose."""
    set_vector(pose.position, transform)
    turn = pose.orientation
    turn.x, turn.y, turn.z, turn.w = transform.rotation
