"""ROS 2's binary format, CDR in its first version, as Fast CDR writes it (measured on Jazzy; source: Fast-CDR).

Each number is at a multiple of its size, counted from behind the head; what lies between is 0.
"""

from __future__ import annotations

import struct
from typing import Any, TypeVar

from .definitions import CODES
from .ros2 import Message

__all__ = ["CDRError", "deserialize", "room", "serialize"]

M = TypeVar("M", bound=Message)

_HEAD = b"\0\1\0\0"  # little-endian, as on every machine that ROS 2 supports
_CODES = CODES | {"bool": "?", "byte": "c"}
_TEXTS = ("string", "wstring")


class CDRError(ValueError):
    """Bytes hold no message of the class."""


def serialize(message: Message) -> bytes:
    """Write a message. Its values must have been checked."""
    out = _Out()
    out.message(message)
    return _HEAD + out.data


def room(message: Message) -> int:
    """How many bytes a real ROS makes room for (source: rosidl_typesupport_fastrtps_cpp's templates).

    For a class without strings and sequences it is a multiple of 4.
    """
    end = _end(type(message))
    if end is not None:
        return len(_HEAD) + end + -end % 4
    out = _Out(is_roomy=True)
    out.message(message)
    return len(_HEAD) + len(out.data)


def deserialize(data: bytes, data_class: type[M]) -> M:
    """Read a message; what follows it is ignored. Raises CDRError."""
    if len(data) < len(_HEAD) or data[0] or data[1] > 1:
        raise CDRError("these bytes do not begin as CDR does")
    return _Reader(data[len(_HEAD) :], "<" if data[1] else ">").message(data_class)


def _end(data_class: type[Message], at: int = 0) -> int | None:
    """Where a message that begins ``at`` ends, counted from behind the head; None if that is not always the same."""
    for field in data_class._rosspin_fields.values():
        kind = field.kind
        count = kind.length if kind.array else 1
        if count is None or kind.base in _TEXTS:
            return None
        if not field.message:
            size = struct.calcsize(_CODES[kind.base])
            at += -at % size + count * size
            continue
        for _ in range(count):
            end = _end(field.message, at)
            if end is None:
                return None
            at = end
    return at if data_class._rosspin_fields else at + 1


class _Out:
    """Writes to ``data``. If it is roomy, it also leaves the room that nothing is written to."""

    def __init__(self, is_roomy: bool = False) -> None:
        self.data = bytearray()
        self._is_roomy = is_roomy

    def message(self, message: Message) -> None:
        for field in type(message)._rosspin_fields.values():
            value, kind = getattr(message, field.slot), field.kind
            values = value if kind.array else (value,)
            if kind.array and kind.length is None:
                self._pack("I", len(values))
            if kind.base in _CODES:
                self._pack(_CODES[kind.base], *values)
                continue
            for each in values:
                if field.message:
                    self.message(each)
                elif kind.base == "string":
                    text = each.encode() + b"\0"
                    self._pack("I", len(text))
                    self.data += text
                else:
                    units = each.encode("utf-16-le")
                    codes = struct.unpack(f"<{len(units) // 2}H", units)
                    self._pack("I", len(codes), *codes, *([0] if self._is_roomy else []))
        if not type(message)._rosspin_fields:
            self.data.append(0)

    def _pack(self, code: str, *values: Any) -> None:
        if values or self._is_roomy:
            self.data += bytes(-len(self.data) % struct.calcsize(code))
        self.data += struct.pack(f"<{len(values)}{code}", *values)


class _Reader:
    """Reads ``data`` from the beginning on, in an ``order``: < or >."""

    def __init__(self, data: bytes, order: str) -> None:
        self._data = data
        self._order = order
        self._at = 0

    def message(self, data_class: type[M]) -> M:
        message = data_class.__new__(data_class)
        for field in data_class._rosspin_fields.values():
            kind = field.kind
            count = 1 if not kind.array else kind.length if kind.length is not None else self._length()
            if kind.base in _CODES:
                values = self._unpack(_CODES[kind.base], count)
            elif field.message:
                values = [self.message(field.message) for _ in range(count)]
            else:
                values = [self._wide() if kind.base == "wstring" else self._text() for _ in range(count)]
            setattr(message, field.slot, field.copy(field.construct(values)) if kind.array else values[0])
        if not data_class._rosspin_fields:
            self._take(1)
        return message

    def _take(self, size: int) -> bytes:
        part = self._data[self._at : self._at + size]
        if len(part) < size:
            raise CDRError("the message is longer than its bytes")
        self._at += size
        return part

    def _unpack(self, code: str, count: int) -> list[Any]:
        size = struct.calcsize(code)
        if count:
            self._at += -self._at % size
        return list(struct.unpack(f"{self._order}{count}{code}", self._take(count * size)))

    def _length(self) -> int:
        return int(self._unpack("I", 1)[0])

    def _text(self) -> str:
        return self._take(self._length()).removesuffix(b"\0").decode(errors="replace")

    def _wide(self) -> str:
        codes = self._unpack("I", self._length())
        return b"".join(struct.pack("<H", code & 0xFFFF) for code in codes).decode("utf-16-le", "replace")
