"""tf_transformations for nodes of ROS 2. Loaded when a node imports it; it needs numpy."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from types import ModuleType
from typing import Any

from ..tf2 import transformations
from ..world.world import refusing

Quaternion = tuple[float, float, float, float]


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: transformations.Axes = "sxyz") -> Quaternion:
    """The quaternion of three angles: roll, pitch and yaw, unless ``axes`` says otherwise."""
    return _tuple(transformations.quaternion_from_euler(ai, aj, ak, axes))


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> Quaternion:
    """The quaternion that rotates by an angle about an axis."""
    return _tuple(transformations.quaternion_about_axis(angle, axis))


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """The quaternion of a matrix, whose w is not negative."""
    quaternion = transformations.quaternion_from_matrix(matrix)
    return _tuple(-quaternion if quaternion[3] < 0 else quaternion)


def quaternion_multiply(quaternion1: Sequence[float], quaternion0: Sequence[float]) -> Quaternion:
    """The quaternion that rotates by the second one and then by the first."""
    return _tuple(transformations.quaternion_multiply(quaternion1, quaternion0))


for _name in transformations.__all__:
    globals().setdefault(_name, getattr(transformations, _name))


def _tuple(quaternion: Any) -> Quaternion:
    x, y, z, w = quaternion
    return x, y, z, w


__getattr__ = refusing(
    "tf_transformations",
    {
        *("Arcball", "arcball_constrain_to_axis", "arcball_map_to_sphere", "arcball_nearest_axis", "clip_matrix"),
        *("compose_matrix", "decompose_matrix", "orthogonalization_matrix", "projection_from_matrix"),
        *("projection_matrix", "reflection_from_matrix", "reflection_matrix", "rotation_from_matrix"),
        *("scale_from_matrix", "scale_matrix", "shear_from_matrix", "shear_matrix", "superimposition_matrix"),
    },
)

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {"tf_transformations": sys.modules[__name__]}
