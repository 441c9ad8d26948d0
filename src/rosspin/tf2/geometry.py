"""The geometry that transforms need (source: tf2/LinearMath)."""

from __future__ import annotations

import math
from typing import NamedTuple

__all__ = ["IDENTITY", "Quaternion", "Transform", "Vector", "interpolate", "rotate"]

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]  # x, y, z, w


class Transform(NamedTuple):
    """A rotation, and then a translation (m). ``rotation`` is a quaternion of length 1."""

    translation: Vector
    rotation: Quaternion

    def __matmul__(self, first: Transform) -> Transform:
        """The transform that does ``first`` and then this one."""
        moved = rotate(self.rotation, first.translation)
        return Transform(_add(moved, self.translation), _multiply(self.rotation, first.rotation))

    def inverse(self) -> Transform:
        """The transform that undoes this one."""
        x, y, z = self.translation
        back = _conjugate(self.rotation)
        return Transform(rotate(back, (-x, -y, -z)), back)

    def normalised(self) -> Transform:
        """The same transform, with its quaternion as tf2 gives it, which makes a matrix of it and a quaternion of that.

        So it has length 1, and is one of the two that are equal. One of length 0 becomes NaN.
        """
        x, y, z, w = self.rotation
        scale = 2 / (x * x + y * y + z * z + w * w or math.nan)
        xs, ys, zs = x * scale, y * scale, z * scale
        matrix = (
            (1 - (y * ys + z * zs), x * ys - w * zs, x * zs + w * ys),
            (x * ys + w * zs, 1 - (x * xs + z * zs), y * zs - w * xs),
            (x * zs - w * ys, y * zs + w * xs, 1 - (x * xs + y * ys)),
        )
        diagonal = matrix[0][0], matrix[1][1], matrix[2][2]
        trace = diagonal[0] + diagonal[1] + diagonal[2]
        parts = [0.0] * 4
        if trace > 0:
            root = math.sqrt(trace + 1)
            parts[3] = root / 2
            for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                parts[i] = (matrix[k][j] - matrix[j][k]) * (0.5 / root)
        else:
            i = diagonal.index(max(diagonal))
            j, k = (i + 1) % 3, (i + 2) % 3
            root = math.sqrt(diagonal[i] - diagonal[j] - diagonal[k] + 1)
            parts[i] = root / 2
            parts[3] = (matrix[k][j] - matrix[j][k]) * (0.5 / root)
            parts[j] = (matrix[j][i] + matrix[i][j]) * (0.5 / root)
            parts[k] = (matrix[k][i] + matrix[i][k]) * (0.5 / root)
        x, y, z, w = parts
        return Transform(self.translation, (x, y, z, w))


IDENTITY = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def interpolate(one: Transform, other: Transform, ratio: float) -> Transform:
    """The transform between two others: ``one`` at the ratio 0, ``other`` at 1, with even speed on the shortest way."""
    a, b, c = ((1 - ratio) * start + ratio * end for start, end in zip(one.translation, other.translation, strict=True))
    return Transform((a, b, c), _slerp(one.rotation, other.rotation, ratio))


def rotate(rotation: Quaternion, vector: Vector) -> Vector:
    """Rotate a vector."""
    x, y, z, _ = _multiply(_multiply(rotation, (*vector, 0.0)), _conjugate(rotation))
    return x, y, z


def _slerp(one: Quaternion, other: Quaternion, ratio: float) -> Quaternion:
    dot = sum(map(float.__mul__, one, other))
    angle = math.acos(min(abs(dot) / (math.hypot(*one) * math.hypot(*other)), 1.0))
    if not angle:
        return one
    start = math.sin((1 - ratio) * angle) / math.sin(angle)
    end = math.copysign(math.sin(ratio * angle) / math.sin(angle), dot)
    x, y, z, w = (start * a + end * b for a, b in zip(one, other, strict=True))
    return x, y, z, w


def _multiply(one: Quaternion, other: Quaternion) -> Quaternion:
    ax, ay, az, aw = one
    bx, by, bz, bw = other
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def _conjugate(rotation: Quaternion) -> Quaternion:
    x, y, z, w = rotation
    return -x, -y, -z, w


def _add(one: Vector, other: Vector) -> Vector:
    return one[0] + other[0], one[1] + other[1], one[2] + other[2]
