"""tf2_geometry_msgs for nodes of ROS 2 (source: tf2_geometry_msgs 0.36.4). Loaded when a node imports it."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from types import ModuleType
from typing import Any

from ..tf2.geometry import IDENTITY, Quaternion, Transform
from ..tf2.moving import empty, moved, moved_vector, set_pose, set_vector
from .passed_on import passing_on

_MESSAGES = (
    *("Point", "Point32", "PointStamped", "PolygonStamped", "Pose", "PoseStamped", "PoseWithCovarianceStamped"),
    *("TransformStamped", "Vector3Stamped"),
)

__all__ = [  # noqa: PLE0604 - the messages are each node's own, so they are looked up when asked for
    "do_transform_point",
    "do_transform_polygon_stamped",
    "do_transform_pose",
    "do_transform_pose_stamped",
    "do_transform_pose_with_covariance_stamped",
    "do_transform_vector3",
    "from_msg_msg",
    "to_msg_msg",
    "transform_covariance",
    *_MESSAGES,
]


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
    """Rotate a Vector3Stamped by a TransformStamped, whose translation becomes 0, as in Jazzy."""
    made = empty("Vector3Stamped", transform.header)
    set_vector(made.vector, moved_vector(_compose, transform, vector3.vector))
    return made


def do_transform_pose(pose: Any, transform: Any) -> Any:
    """Move a Pose by a TransformStamped. An orientation of zeros counts as none."""
    made = _new("Pose")
    set_pose(made, moved(_compose, transform, pose.position, pose.orientation))
    return made


def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    """Move a PoseStamped by a TransformStamped, whose header it gets."""
    made = empty("PoseStamped", transform.header)
    made.pose = do_transform_pose(pose.pose, transform)
    return made


def do_transform_pose_with_covariance_stamped(pose: Any, transform: Any) -> Any:
    """Move a PoseWithCovarianceStamped by a TransformStamped, whose header it gets."""
    made = empty("PoseWithCovarianceStamped", transform.header)
    made.pose.pose = do_transform_pose(pose.pose.pose, transform)
    made.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return made


def do_transform_polygon_stamped(polygon: Any, transform: Any) -> Any:
    """Move a PolygonStamped by a TransformStamped, whose header it gets."""
    made = empty("PolygonStamped", transform.header)
    for point in polygon.polygon.points:
        made.polygon.points.append(_new("Point32"))
        set_vector(made.polygon.points[-1], moved(_compose, transform, point))
    return made


def transform_covariance(cov_in: Sequence[float], transform: Any) -> Any:
    """Rotate a covariance, of 6 rows and 6 columns, by a TransformStamped."""
    turn = transform.transform.rotation
    x, y, z, w = turn.x, turn.y, turn.z, turn.w
    rows = (
        (2 * (w * w + x * x) - 1, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 2 * (w * w + y * y) - 1, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 2 * (w * w + z * z) - 1),
    )
    found = _new("PoseWithCovarianceStamped").pose.covariance
    three = range(3)
    for place in range(36):  # in each of its four blocks, the matrix, the block, and the matrix transposed
        (down, i), (right, j) = (divmod(each, 3) for each in divmod(place, 6))
        block = [[cov_in[(3 * down + k) * 6 + 3 * right + m] for m in three] for k in three]
        found[place] = sum(rows[i][k] * block[k][m] * rows[j][m] for k in three for m in three)
    return found


def _compose(one: Transform, other: Transform) -> Transform:
    """With rotations of length 1 (none, if the length is 0), and a quaternion whose w is not negative."""
    found = Transform(one.translation, _unit(one.rotation)) @ Transform(other.translation, _unit(other.rotation))
    x, y, z, w = found.rotation
    return Transform(found.translation, (-x, -y, -z, -w)) if w < 0 else found


def _unit(rotation: Quaternion) -> Quaternion:
    square = sum(part * part for part in rotation)
    if square < sys.float_info.epsilon:
        return IDENTITY.rotation
    x, y, z, w = (part / math.sqrt(square) for part in rotation)
    return x, y, z, w


def _new(name: str) -> Any:
    return __getattr__(name)()


# What importing it teaches tf2_ros, by the messages' names.
TRANSFORMS = {
    "PointStamped": do_transform_point,
    "PolygonStamped": do_transform_polygon_stamped,
    "PoseStamped": do_transform_pose_stamped,
    "PoseWithCovarianceStamped": do_transform_pose_with_covariance_stamped,
    "Vector3Stamped": do_transform_vector3,
}
CONVERTS = dict.fromkeys(("PointStamped", "PoseStamped", "Vector3Stamped"), to_msg_msg)

__getattr__ = passing_on("tf2_geometry_msgs", {"geometry_msgs.msg": " ".join(_MESSAGES)})

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(
    ("tf2_geometry_msgs", "tf2_geometry_msgs.tf2_geometry_msgs"), sys.modules[__name__]
)
tf2_geometry_msgs = sys.modules[__name__]
