"""tf2_geometry_msgs for nodes of ROS 1 (sources: tf2_geometry_msgs 0.7.6, orocos_kdl). Loaded when imported."""

from __future__ import annotations

import math
import sys
from copy import deepcopy
from importlib import import_module
from types import ModuleType
from typing import Any

from ..tf2.geometry import Quaternion, Transform
from ..tf2.moving import empty, moved, moved_vector, set_pose, set_vector
from ..world.world import refusing

_MESSAGES = ("PointStamped", "PoseStamped", "Vector3Stamped", "WrenchStamped")

__all__ = [  # noqa: PLE0604 - the messages are each node's own, so they are looked up when asked for
    "do_transform_point",
    "do_transform_pose",
    "do_transform_vector3",
    "do_transform_wrench",
    "from_msg_msg",
    "to_msg_msg",
    *_MESSAGES,
]

Matrix = tuple[tuple[float, ...], ...]


def to_msg_msg(msg: Any) -> Any:
    """Return the message."""
    return msg


from_msg_msg = to_msg_msg


def do_transform_point(point: Any, transform: Any) -> Any:
    """Move a PointStamped by a TransformStamped, whose header it gets."""
    made = empty("PointStamped", transform.header)
    set_vector(made.point, moved(_compose, transform, point.point))
    return made


def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    """Rotate a Vector3Stamped by a TransformStamped."""
    transform = deepcopy(transform)
    made = empty("Vector3Stamped", transform.header)
    set_vector(made.vector, moved_vector(_compose, transform, vector3.vector))
    return made


def do_transform_pose(pose: Any, transform: Any) -> Any:
    """Move a PoseStamped by a TransformStamped. As in PyKDL, an orientation of zeros counts as a matrix of zeros."""
    made = empty("PoseStamped", transform.header)
    set_pose(made.pose, moved(_compose, transform, pose.pose.position, pose.pose.orientation))
    return made


def do_transform_wrench(wrench: Any, transform: Any) -> Any:
    """Rotate a WrenchStamped by a TransformStamped."""
    made, transform = empty("WrenchStamped", transform.header), deepcopy(transform)
    set_vector(made.wrench.force, moved_vector(_compose, transform, wrench.wrench.force))
    set_vector(made.wrench.torque, moved_vector(_compose, transform, wrench.wrench.torque))
    return made


def _compose(one: Transform, other: Transform) -> Transform:
    """As PyKDL's frames do, which keep matrices: quaternions whose length is not 1 give no rotations."""
    first, second = _matrix(one.rotation), _matrix(other.rotation)
    x, y, z = (move + _dot(row, other.translation) for row, move in zip(first, one.translation))
    columns = tuple(zip(*second))
    return Transform((x, y, z), _quaternion(tuple(tuple(_dot(row, column) for column in columns) for row in first)))


def _dot(one: tuple[float, ...], other: tuple[float, ...]) -> float:
    return sum(a * b for a, b in zip(one, other))


def _matrix(rotation: Quaternion) -> Matrix:
    x, y, z, w = rotation
    return (
        (w * w + x * x - y * y - z * z, 2 * x * y - 2 * w * z, 2 * x * z + 2 * w * y),
        (2 * x * y + 2 * w * z, w * w - x * x + y * y - z * z, 2 * y * z - 2 * w * x),
        (2 * x * z - 2 * w * y, 2 * y * z + 2 * w * x, w * w - x * x - y * y + z * z),
    )


def _quaternion(matrix: Matrix) -> Quaternion:
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = matrix
    if xx + yy + zz > 1e-12:
        scale = 0.5 / math.sqrt(xx + yy + zz + 1)
        return (zy - yz) * scale, (xz - zx) * scale, (yx - xy) * scale, 0.25 / scale
    if xx > yy and xx > zz:
        scale = 2 * math.sqrt(1 + xx - yy - zz)
        return 0.25 * scale, (xy + yx) / scale, (xz + zx) / scale, (zy - yz) / scale
    if yy > zz:
        scale = 2 * math.sqrt(1 + yy - xx - zz)
        return (xy + yx) / scale, 0.25 * scale, (yz + zy) / scale, (xz - zx) / scale
    scale = 2 * math.sqrt(1 + zz - xx - yy)
    return (xz + zx) / scale, (yz + zy) / scale, 0.25 * scale, (yx - xy) / scale


# What importing it teaches tf2_ros, by the messages' names.
TRANSFORMS = {
    "PointStamped": do_transform_point,
    "PoseStamped": do_transform_pose,
    "Vector3Stamped": do_transform_vector3,
    "WrenchStamped": do_transform_wrench,
}
CONVERTS = dict.fromkeys(("PointStamped", "PoseStamped", "Vector3Stamped"), to_msg_msg)

_refuse = refusing("tf2_geometry_msgs", {"PyKDL", "transform_to_kdl"})


def __getattr__(name: str) -> Any:
    return getattr(import_module("geometry_msgs.msg"), name) if name in _MESSAGES else _refuse(name)


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(
    ("tf2_geometry_msgs", "tf2_geometry_msgs.tf2_geometry_msgs"), sys.modules[__name__]
)
tf2_geometry_msgs = sys.modules[__name__]
