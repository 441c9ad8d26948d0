"""The types of a message's fields, as ``SLOT_TYPES`` has them (source: rosidl_parser/definition.py)."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from types import ModuleType
from typing import Any, ClassVar

__all__ = [
    "AbstractNestableType",
    "AbstractNestedType",
    "AbstractSequence",
    "AbstractString",
    "AbstractType",
    "AbstractWString",
    "Array",
    "BasicType",
    "BoundedSequence",
    "BoundedString",
    "BoundedWString",
    "NamespacedType",
    "UnboundedSequence",
    "UnboundedString",
    "UnboundedWString",
]


class AbstractType:
    """A type; two are equal if their kinds and all that they were made of are."""

    __slots__: ClassVar[tuple[str, ...]] = ()

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and all(getattr(self, name) == getattr(other, name) for name in self._parts())

    __hash__ = None  # type: ignore[assignment]

    def _parts(self) -> list[str]:
        return [name for kind in type(self).__mro__ for name in getattr(kind, "__slots__", ())]


class AbstractNestableType(AbstractType):
    """The type of a value that is no array."""

    __slots__ = ()


class BasicType(AbstractNestableType):
    """A number, a bool or an octet, by its ``typename`` in the interface language, as in double."""

    __slots__ = ("typename",)

    def __init__(self, typename: str) -> None:
        self.typename = typename


class NamespacedType(AbstractNestableType):
    """A message, by its name and where it is, as in ['std_msgs', 'msg']."""

    __slots__ = ("name", "namespaces")

    def __init__(self, namespaces: Iterable[str], name: str) -> None:
        self.namespaces = namespaces
        self.name = name

    def namespaced_name(self) -> tuple[str, ...]:
        """The parts of its full name."""
        return (*self.namespaces, self.name)


class _Unbounded:
    __slots__: ClassVar[tuple[str, ...]] = ()

    def has_maximum_size(self) -> bool:
        """Whether a value can be too long: no."""
        return False


class _Bounded:
    __slots__: ClassVar[tuple[str, ...]] = ()

    def has_maximum_size(self) -> bool:
        """Whether a value can be too long: yes."""
        return True


class AbstractGenericString(AbstractNestableType):
    """A text."""

    __slots__ = ()


class AbstractString(AbstractGenericString):
    """A text of 8-bit characters."""

    __slots__ = ()


class BoundedString(_Bounded, AbstractString):
    """A text of at most ``maximum_size`` characters of 8 bits."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = maximum_size


class UnboundedString(_Unbounded, AbstractString):
    """A text of any number of characters of 8 bits."""

    __slots__ = ()


class AbstractWString(AbstractGenericString):
    """A text of 16-bit characters."""

    __slots__ = ()


class BoundedWString(_Bounded, AbstractWString):
    """A text of at most ``maximum_size`` characters of 16 bits."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = maximum_size


class UnboundedWString(_Unbounded, AbstractWString):
    """A text of any number of characters of 16 bits."""

    __slots__ = ()


class AbstractNestedType(AbstractType):
    """An array of values of ``value_type``."""

    __slots__ = ("value_type",)

    def __init__(self, value_type: Any) -> None:
        self.value_type = value_type


class Array(_Bounded, AbstractNestedType):
    """An array of ``size`` values."""

    __slots__ = ("size",)

    def __init__(self, value_type: Any, size: int) -> None:
        super().__init__(value_type)
        self.size = size


class AbstractSequence(AbstractNestedType):
    """An array whose length may vary."""

    __slots__ = ()


class BoundedSequence(_Bounded, AbstractSequence):
    """An array of at most ``maximum_size`` values."""

    __slots__ = ("maximum_size",)

    def __init__(self, value_type: Any, maximum_size: int) -> None:
        super().__init__(value_type)
        self.maximum_size = maximum_size


class UnboundedSequence(_Unbounded, AbstractSequence):
    """An array of any length."""

    __slots__ = ()


for _name in (*__all__, "AbstractGenericString"):
    globals()[_name].__module__ = "rosidl_parser.definition"

definition = sys.modules[__name__]

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(("rosidl_parser", "rosidl_parser.definition"), definition)
