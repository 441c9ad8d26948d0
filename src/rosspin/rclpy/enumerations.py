"""Enumerations of rclpy's C++ part (source: enum_base in pybind11/pybind11.h)."""

from __future__ import annotations

from enum import Enum

__all__ = ["CppEnum", "PlainCppEnum"]


class CppEnum(Enum):
    """One of an ``enum class``: always true, and an int where one is needed, but equal to none."""

    def __bool__(self) -> bool:
        return True

    def __int__(self) -> int:
        return int(self.value)

    __index__ = __int__

    def __hash__(self) -> int:
        return hash(self.value)

    def __eq__(self, other: object) -> bool:
        return self is other


class PlainCppEnum(CppEnum):
    """One of an ``enum``, which is equal to its number, too."""

    def __eq__(self, other: object) -> bool:
        return bool(self.value == other)

    __hash__ = CppEnum.__hash__
