"""Rotations in tf_transformations."""

import itertools
import math
import random

import rclpy  # noqa: F401
import tf_transformations as t

draw = random.Random(3)


def show(*words):
    print(*[shown(word) for word in words], flush=True)


def shown(value):
    if isinstance(value, (str, int)):
        return str(value)
    if isinstance(value, float):
        return f"{value + 0.0:.9f}".replace("-0.000000000", "0.000000000")
    return f"{type(value).__name__}[{' '.join(shown(each) for each in value)}]"


def attempt(call, *args):
    try:
        show(call.__name__, call(*args))
    except Exception as error:
        show(call.__name__, type(error).__name__)


NAMES = [
    kind + axes
    for kind in "sr"
    for axes in ("xyz", "xyx", "xzy", "xzx", "yzx", "yzy", "yxz", "yxy", "zxy", "zxz", "zyx", "zyz")
]
for name in NAMES:
    angles = [draw.uniform(-1.5, 1.5) for _ in range(3)]
    turn = t.quaternion_from_euler(*angles, name)
    show(name, turn, t.euler_from_quaternion(turn, name))
    show(t.euler_matrix(*angles, name), t.euler_from_matrix(t.euler_matrix(*angles, name), axes=name))
for roll, pitch, yaw in itertools.product((0, 1, -2, math.pi / 2), repeat=3):
    show(t.quaternion_from_euler(roll, pitch, yaw))
for _ in range(8):
    one, other = ([draw.uniform(-1, 1) for _ in range(4)] for _ in range(2))
    show(t.quaternion_multiply(one, other), t.quaternion_conjugate(one), t.quaternion_inverse(one))
    show(t.quaternion_matrix(one), t.quaternion_from_matrix(t.quaternion_matrix(one)))
    show(*(t.quaternion_slerp(one, other, part) for part in (0, 0.3, 1)))
    show(t.quaternion_slerp(one, other, 0.3, 1), t.quaternion_slerp(one, other, 0.3, 0, False))
    show(t.quaternion_about_axis(one[0], other[:3]), t.rotation_matrix(one[0], other[:3], one[1:]))
    show(t.unit_vector(one), float(t.vector_norm(other)), t.random_quaternion([abs(each) for each in one[:3]]))
    show(t.euler_from_quaternion(one), t.euler_from_quaternion(one, axes="rzyx"))
    matrix = t.concatenate_matrices(t.translation_matrix(one[:3]), t.quaternion_matrix(other))
    show(matrix, t.inverse_matrix(matrix), t.translation_from_matrix(matrix))
    show(t.is_same_transform(matrix, t.identity_matrix()), t.is_same_transform(matrix, matrix))
show(t.quaternion_matrix([0, 0, 0, 0]), t.unit_vector([[1, 2], [3, 4]], 1), len(t.random_quaternion()))
show(t.random_rotation_matrix().shape, t.random_vector(3).shape)
attempt(t.quaternion_from_euler, 1, 2, 3, "sxxy")
attempt(t.euler_matrix, 1, 2)
