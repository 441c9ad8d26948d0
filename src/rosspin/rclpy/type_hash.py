"""Hashes of types' definitions (sources: rclpy/type_hash.py, rosidl_generator_type_description)."""

from __future__ import annotations

import hashlib
import json
import re
from importlib import import_module
from typing import Any

from .endpoints import kind_of

__all__ = ["TypeHash"]

# The numbers of types in type_description_interfaces/FieldType, by the names that messages have for them.
_TYPES = {
    name: number
    for number, name in enumerate(
        "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float double long_double char wchar boolean octet string "
        "wstring".split(),
        start=2,
    )
}
_NESTED = 1
_BOUNDED = 4  # what a string with a bound adds
_ARRAY, _BOUNDED_SEQUENCE, _SEQUENCE = 48, 96, 144  # what they add

_FIELD = re.compile(
    r"(?:sequence<)?(?P<type>[\w/]+)(?:<(?P<size>\d+)>)?(?:\[(?P<length>\d+)\]|(?:, (?P<bound>\d+))?>)?"
)


class TypeHash:
    """A hash, and the version of the rules by which it was made; without arguments, none."""

    _TYPE_HASH_SIZE = 32

    __slots__ = ["_value", "_version"]

    def __init__(self, version: int = -1, value: bytes = bytes(_TYPE_HASH_SIZE)) -> None:
        self.version = version
        self.value = value

    @property
    def version(self) -> int:
        """The version. Raises AssertionError for anything but an int."""
        return self._version

    @version.setter
    def version(self, value: int) -> None:
        assert isinstance(value, int)
        self._version = value

    @property
    def value(self) -> bytes:
        """The hash. Raises AssertionError for anything but bytes."""
        return self._value

    @value.setter
    def value(self, value: bytes) -> None:
        assert isinstance(value, bytes)
        self._value = value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TypeHash) and (self._version, self._value) == (other._version, other._value)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        if self._version <= 0 or len(self._value) != self._TYPE_HASH_SIZE:
            return "INVALID"
        return f"RIHS{self._version:02}_{self._value.hex()}"


def hash_of(data_class: Any) -> TypeHash:
    """The hash of a message's class: of its fields and of all messages in it, not of comments or defaults."""
    descriptions: dict[str, Any] = {}
    _describe(data_class, descriptions)
    own = descriptions.pop(kind_of(data_class))
    text = json.dumps(
        {"type_description": own, "referenced_type_descriptions": [descriptions[name] for name in sorted(descriptions)]}
    )
    return TypeHash(1, hashlib.sha256(text.encode()).digest())


def _describe(data_class: Any, descriptions: dict[str, Any]) -> str:
    """Describe a class and the classes of messages in it, by their names. Return its name."""
    name = kind_of(data_class)
    if name not in descriptions:
        fields: list[Any] = []
        descriptions[name] = {"type_name": name, "fields": fields}
        # One without fields has one that no one sees.
        types = data_class.get_fields_and_field_types() or {"structure_needs_at_least_one_member": "uint8"}
        for field, kind in types.items():
            match = _FIELD.fullmatch(kind)
            assert match, kind
            base, size = match["type"], int(match["size"] or 0)
            number = _TYPES.get(base, _NESTED) + (_BOUNDED if size else 0)
            if kind.startswith("sequence<"):
                number += _BOUNDED_SEQUENCE if match["bound"] else _SEQUENCE
            elif match["length"]:
                number += _ARRAY
            type_ = {
                "type_id": number,
                "capacity": int(match["bound"] or match["length"] or 0),
                "string_capacity": size,
                "nested_type_name": "" if base in _TYPES else _describe(_class(base), descriptions),
            }
            fields.append({"name": field, "type": type_})
    return name


def _class(name: str) -> Any:
    """The class of a message in another one, as in std_msgs/Header; of a part of an action, too."""
    package, _, short = name.partition("/")
    folder = "action" if "_" in short else "msg"
    return getattr(import_module(f"{package}.{folder}"), short)
