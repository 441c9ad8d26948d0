"""Rotations as matrices (4 x 4), quaternions (x, y, z, w) and Euler angles (rad), as tf has them; numpy is needed.

Sources: tf/transformations.py, tf_transformations/__init__.py.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import reduce
from importlib import import_module
from typing import Any

numpy: Any = import_module("numpy")

__all__ = [
    "concatenate_matrices",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_matrix",
    "identity_matrix",
    "inverse_matrix",
    "is_same_transform",
    "quaternion_about_axis",
    "quaternion_conjugate",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_matrix",
    "quaternion_multiply",
    "quaternion_slerp",
    "random_quaternion",
    "random_rotation_matrix",
    "random_vector",
    "rotation_matrix",
    "translation_from_matrix",
    "translation_matrix",
    "unit_vector",
    "vector_norm",
]

_EPS = numpy.finfo(float).eps * 4.0

Axes = str | tuple[int, int, int, int]


def identity_matrix() -> Any:
    """The matrix that changes nothing."""
    return numpy.identity(4)


def translation_matrix(direction: Sequence[float]) -> Any:
    """The matrix that moves by a vector."""
    matrix = numpy.identity(4)
    matrix[:3, 3] = direction[:3]
    return matrix


def translation_from_matrix(matrix: Any) -> Any:
    """By which vector a matrix moves."""
    return numpy.asarray(matrix)[:3, 3].copy()


def rotation_matrix(angle: float, direction: Sequence[float], point: Sequence[float] | None = None) -> Any:
    """The matrix that rotates by an angle about a direction, through a point if it is given."""
    matrix = quaternion_matrix(quaternion_about_axis(angle, direction))
    if point is not None:
        fixed = numpy.array(point[:3], dtype=float)
        matrix[:3, 3] = fixed - matrix[:3, :3] @ fixed
    return matrix


def _parsed(axes: Axes) -> tuple[int, int, int, bool, bool, bool]:
    """Return the three axes as for fixed ones, and whether they go round the other way, repeat the first, and rotate.

    Raises KeyError for what names no axes.
    """
    if isinstance(axes, str):
        rotates, letters = axes[:1].lower() == "r", axes[1:].lower()
        order = ["xyz".find(letter) for letter in (letters[::-1] if rotates else letters)]
        known = len(order) == 3 and order[0] != order[1] != order[2] and min(order) >= 0 and axes[0].lower() in "sr"
        if not known:
            raise KeyError(axes)
        first, second, last = order
        parity, repeats = second != (first + 1) % 3, first == last
    else:
        first, *flags = axes
        if len(flags) != 3 or first not in range(3) or not all(flag in (0, 1) for flag in flags):
            raise KeyError(axes)
        parity, repeats, rotates = map(bool, flags)
        second = (first + (2 if parity else 1)) % 3
    return first, second, 3 - first - second, parity, repeats, rotates


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Any:
    """The quaternion of three angles: roll, pitch and yaw, unless ``axes`` says otherwise."""
    first, second, third, _, repeats, rotates = _parsed(axes)
    angles = (ak, aj, ai) if rotates else (ai, aj, ak)
    turns = [
        quaternion_about_axis(angle, numpy.identity(3)[axis])
        for angle, axis in zip(angles, (first, second, first if repeats else third), strict=True)
    ]
    return quaternion_multiply(turns[2], quaternion_multiply(turns[1], turns[0]))


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Any:
    """The matrix of three angles."""
    return quaternion_matrix(quaternion_from_euler(ai, aj, ak, axes))


def euler_from_matrix(matrix: Any, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """The three angles of a matrix: one triple of the many that there are."""
    i, j, k, parity, repeats, rotates = _parsed(axes)
    m = numpy.asarray(matrix, dtype=float)[:3, :3]
    if repeats:
        length = math.hypot(m[i, j], m[i, k])
        first = math.atan2(m[i, j], m[i, k]) if length > _EPS else math.atan2(-m[j, k], m[j, j])
        second = math.atan2(length, m[i, i])
        third = math.atan2(m[j, i], -m[k, i]) if length > _EPS else 0.0
    else:
        length = math.hypot(m[i, i], m[j, i])
        first = math.atan2(m[k, j], m[k, k]) if length > _EPS else math.atan2(-m[j, k], m[j, j])
        second = math.atan2(-m[k, i], length)
        third = math.atan2(m[j, i], m[i, i]) if length > _EPS else 0.0
    if parity:
        first, second, third = -first, -second, -third
    return (third, second, first) if rotates else (first, second, third)


def euler_from_quaternion(quaternion: Sequence[float], axes: Axes = "sxyz") -> tuple[float, float, float]:
    """The three angles of a quaternion."""
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> Any:
    """The quaternion that rotates by an angle about an axis."""
    quaternion = numpy.array([*axis[:3], 0.0], dtype=float)
    length = vector_norm(quaternion)
    if length > _EPS:
        quaternion *= math.sin(angle / 2) / length
    quaternion[3] = math.cos(angle / 2)
    return quaternion


def quaternion_matrix(quaternion: Sequence[float]) -> Any:
    """The matrix of a quaternion of any length but 0, which gives the identity."""
    x, y, z, w = (float(part) for part in quaternion[:4])
    square = x * x + y * y + z * z + w * w
    matrix = numpy.identity(4)
    if square < _EPS:
        return matrix
    scale = 2.0 / square
    matrix[:3, :3] = (
        (1 - scale * (y * y + z * z), scale * (x * y - z * w), scale * (x * z + y * w)),
        (scale * (x * y + z * w), 1 - scale * (x * x + z * z), scale * (y * z - x * w)),
        (scale * (x * z - y * w), scale * (y * z + x * w), 1 - scale * (x * x + y * y)),
    )
    return matrix


def quaternion_from_matrix(matrix: Any) -> Any:
    """The quaternion of a matrix."""
    m = numpy.asarray(matrix, dtype=float)
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    quaternion = numpy.empty(4)
    if trace > 0:
        total = trace + 1
        quaternion[:] = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], total
    else:
        i = int(numpy.argmax(numpy.diag(m)[:3]))
        j, k = (i + 1) % 3, (i + 2) % 3
        total = m[i, i] - m[j, j] - m[k, k] + 1
        quaternion[[i, j, k, 3]] = total, m[i, j] + m[j, i], m[k, i] + m[i, k], m[k, j] - m[j, k]
    return quaternion * (0.5 / math.sqrt(total))


def quaternion_multiply(quaternion1: Sequence[float], quaternion0: Sequence[float]) -> Any:
    """The quaternion that rotates by the second one and then by the first."""
    ax, ay, az, aw = quaternion1
    bx, by, bz, bw = quaternion0
    return numpy.array(
        (
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        ),
        dtype=float,
    )


def quaternion_conjugate(quaternion: Sequence[float]) -> Any:
    """The same rotation the other way round, of a quaternion of length 1."""
    x, y, z, w = quaternion
    return numpy.array((-x, -y, -z, w), dtype=float)


def quaternion_inverse(quaternion: Sequence[float]) -> Any:
    """The same rotation the other way round."""
    return quaternion_conjugate(quaternion) / numpy.dot(quaternion, quaternion)


def quaternion_slerp(
    quat0: Sequence[float], quat1: Sequence[float], fraction: float, spin: int = 0, shortestpath: bool = True
) -> Any:
    """The rotation between two others: the first at the fraction 0, the second at 1."""
    one, other = unit_vector(quat0[:4]), unit_vector(quat1[:4])
    if fraction in (0.0, 1.0):
        return other if fraction else one
    dot = float(numpy.dot(one, other))
    if abs(abs(dot) - 1.0) < _EPS:
        return one
    if shortestpath and dot < 0.0:
        dot, other = -dot, -other
    angle = math.acos(dot) + spin * math.pi
    if abs(angle) < _EPS:
        return one
    return (math.sin((1.0 - fraction) * angle) * one + math.sin(fraction * angle) * other) / math.sin(angle)


def random_quaternion(rand: Sequence[float] | None = None) -> Any:
    """A random rotation, or the one that three numbers from 0 to 1 stand for."""
    a, b, c = numpy.random.rand(3) if rand is None else rand
    near, far = math.sqrt(1.0 - a), math.sqrt(a)
    one, other = 2 * math.pi * b, 2 * math.pi * c
    return numpy.array((math.sin(one) * near, math.cos(one) * near, math.sin(other) * far, math.cos(other) * far))


def random_rotation_matrix(rand: Sequence[float] | None = None) -> Any:
    """The matrix of such a rotation."""
    return quaternion_matrix(random_quaternion(rand))


def random_vector(size: Any) -> Any:
    """Random numbers from 0 to 1."""
    return numpy.random.random(size)


def vector_norm(data: Any, axis: int | None = None) -> Any:
    """The length of a vector, or of those along an axis."""
    length = numpy.sqrt(numpy.sum(numpy.square(numpy.array(data, dtype=float)), axis=axis))
    return length if axis is not None else float(length)


def unit_vector(data: Any, axis: int | None = None) -> Any:
    """A vector's direction, or those along an axis."""
    vector = numpy.array(data, dtype=float)
    length = vector_norm(vector, axis)
    return vector / (length if axis is None else numpy.expand_dims(length, axis))


def inverse_matrix(matrix: Any) -> Any:
    """The matrix that undoes another."""
    return numpy.linalg.inv(matrix)


def concatenate_matrices(*matrices: Any) -> Any:
    """The matrix that does the last of others first."""
    return reduce(numpy.dot, matrices, numpy.identity(4))


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Whether two matrices do the same."""
    one, other = (numpy.asarray(each, dtype=float) / numpy.asarray(each)[3, 3] for each in (matrix0, matrix1))
    return bool(numpy.allclose(one, other))
