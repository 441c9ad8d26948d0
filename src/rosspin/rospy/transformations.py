"""tf.transformations for nodes of ROS 1. Loaded when a node imports it; it needs numpy."""

from __future__ import annotations

from ..tf2 import transformations
from ..world.world import refusing

for _name in transformations.__all__:
    globals()[_name] = getattr(transformations, _name)

__getattr__ = refusing(
    "tf.transformations",
    {
        *("Arcball", "arcball_constrain_to_axis", "arcball_map_to_sphere", "arcball_nearest_axis", "clip_matrix"),
        *("compose_matrix", "decompose_matrix", "orthogonalization_matrix", "projection_from_matrix"),
        *("projection_matrix", "reflection_from_matrix", "reflection_matrix", "rotation_from_matrix"),
        *("scale_from_matrix", "scale_matrix", "shear_from_matrix", "shear_matrix", "superimposition_matrix"),
    },
)
