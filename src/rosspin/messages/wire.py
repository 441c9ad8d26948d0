"""ROS 1's binary format, step by step as in the code that genpy generates (source: genpy/generator.py).

A message is written in steps: numbers in a row in one go, strings, arrays. Nested messages are flattened into their
parent's steps, except inside of an array. The order of the steps and the value that each has at hand (genpy's ``_x``)
are kept, because the texts of errors show them.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from importlib import import_module
from itertools import groupby
from keyword import iskeyword
from operator import attrgetter
from typing import Any, NamedTuple

from .definitions import CODES, Field, Kind

__all__ = ["SIMPLE", "LengthError", "Step", "numpy_array", "plan", "read", "safe"]

SIMPLE = CODES | {"bool": "B", "byte": "b"}
LENGTH = struct.Struct("<I")

Write = Callable[[bytes], object]


class LengthError(Exception):
    """A fixed array of messages or strings has the wrong length."""


class Step(NamedTuple):
    """Part of a message: ``write(message, write, at)``, ``end = read(message, data, start)``.

    ``at[0]`` is the value that was looked at last.
    """

    write: Callable[[Any, Write, list[Any]], None]
    read: Callable[[Any, bytes, int], int]


# What a field's type is made of: its fields and its class; None if it is built in. Times are made of two numbers.
Nested = Callable[[str], "tuple[Sequence[Field], Callable[[], Any]] | None"]

Array = Callable[[str, Kind], Step]


def safe(name: str) -> str:
    """A field's name in Python: Python's own words get an underscore."""
    return f"{name}_" if iskeyword(name) or name == "self" else name


def plan(
    fields: Sequence[Field], nested: Nested, array: Array | None = None, path: str = "self", flat: bool = True
) -> list[Step]:
    """Plan the steps of a message with these fields; ``array`` plans arrays of numbers and bools (None: as tuples).

    ``path`` is genpy's name for the message, ``flat`` flattens nested ones.
    """
    parts = list(_flatten(fields, nested)) if flat else [(safe(field.name), field.kind) for field in fields]
    steps: list[Step] = []
    for simple, group in groupby(parts, key=lambda part: not part[1].array and part[1].base in SIMPLE):
        if simple:
            members = list(group)
            # genpy packs 255 at a time.
            steps += [_numbers(members[start : start + 255]) for start in range(0, len(members), 255)]
        else:
            steps += [_complex(name, kind, nested, array or _array, path) for name, kind in group]
    return steps


def read(steps: list[Step], message: Any, data: bytes, start: int = 0) -> int:
    """Fill a message from ``data``; returns where it ends. struct.error if there is too little."""
    for step in steps:
        start = step.read(message, data, start)
    return start


def _flatten(fields: Sequence[Field], nested: Nested) -> list[tuple[str, Kind]]:
    parts = []
    for field in fields:
        name, kind = safe(field.name), field.kind
        inner = None if kind.array else nested(kind.base)
        if inner:
            parts += [(f"{name}.{path}", kind) for path, kind in _flatten(inner[0], nested)]
        else:
            parts.append((name, kind))
    return parts


def _setter(path: str) -> Callable[[Any, Any], None]:
    """A function that sets the attribute a.b.c of a message."""
    parent, _, name = path.rpartition(".")
    if not parent:
        return lambda message, value: setattr(message, name, value)
    get = attrgetter(parent)
    return lambda message, value: setattr(get(message), name, value)


def _complex(name: str, kind: Kind, nested: Nested, array: Array, path: str) -> Step:
    if kind.array:
        if kind.base in ("uint8", "char"):
            return _bytes(name, kind.length)
        if kind.base in SIMPLE:
            return array(name, kind)
        return _strings(name, kind, path) if kind.base == "string" else _messages(name, kind, nested, array, path)
    if kind.base == "string":
        return _string(name)
    inner = nested(kind.base)
    assert inner
    get, steps = attrgetter(name), plan(inner[0], nested, array, path, flat=False)

    def write(message: Any, out: Write, at: list[Any]) -> None:
        part = get(message)
        for step in steps:
            step.write(part, out, at)

    return Step(write, lambda message, data, start: read(steps, get(message), data, start))


def _numbers(members: list[tuple[str, Kind]]) -> Step:
    """Numbers and bools in a row."""
    get = attrgetter(*(name for name, _ in members))
    code = struct.Struct("<" + "".join(SIMPLE[kind.base] for _, kind in members))
    size, pack, unpack = code.size, code.pack, code.unpack
    setters = [(_setter(name), kind.base == "bool") for name, kind in members]

    def write_one(message: Any, out: Write, at: list[Any]) -> None:
        at[0] = value = get(message)
        out(pack(value))

    def write_all(message: Any, out: Write, at: list[Any]) -> None:
        at[0] = message
        out(pack(*get(message)))

    def read_one(message: Any, data: bytes, start: int) -> int:
        end = start + size
        (value,) = unpack(data[start:end])
        set_one(message, bool(value) if one_is_bool else value)
        return end

    def read_all(message: Any, data: bytes, start: int) -> int:
        end = start + size
        for (set_, is_bool), value in zip(setters, unpack(data[start:end])):
            set_(message, bool(value) if is_bool else value)
        return end

    if len(members) == 1:
        ((set_one, one_is_bool),) = setters
        return Step(write_one, read_one)
    return Step(write_all, read_all)


def _string(name: str) -> Step:
    get, set_ = attrgetter(name), _setter(name)

    def write(message: Any, out: Write, at: list[Any]) -> None:
        at[0] = value = get(message)
        len(value)  # a TypeError here, as in genpy, not an AttributeError in the next line
        at[0] = text = value.encode("utf-8")
        out(LENGTH.pack(len(text)) + text)

    def read_(message: Any, data: bytes, start: int) -> int:
        text, end = _text(data, start)
        set_(message, text)
        return end

    return Step(write, read_)


def _text(data: bytes, start: int) -> tuple[str, int]:
    (length,) = LENGTH.unpack(data[start : start + 4])
    end = start + 4 + length
    return data[start + 4 : end].decode("utf-8", "replace"), end


def _bytes(name: str, length: int | None) -> Step:
    """An array of uint8 or char: bytes, or a list of numbers."""
    get, set_ = attrgetter(name), _setter(name)

    def write(message: Any, out: Write, at: list[Any]) -> None:
        at[0] = value = get(message)
        head = b"" if length is not None else LENGTH.pack(len(value))
        size = len(value) if length is None else length
        if type(value) in (list, tuple):
            out(head + struct.pack(f"<{size}B", *value))
        else:
            out(head + struct.pack(f"<{size}s", value))

    def read_(message: Any, data: bytes, start: int) -> int:
        size, start = _size(data, start, length)
        set_(message, data[start : start + size])
        return start + size

    return Step(write, read_)


def _size(data: bytes, start: int, length: int | None) -> tuple[int, int]:
    """An array's length, read from ``data`` unless it is fixed, and where its elements begin."""
    if length is not None:
        return length, start
    (size,) = LENGTH.unpack(data[start : start + 4])
    return size, start + 4


def _array(name: str, kind: Kind) -> Step:
    """An array of numbers or bools."""
    get, set_, code = attrgetter(name), _setter(name), SIMPLE[kind.base]

    def write(message: Any, out: Write, at: list[Any]) -> None:
        value = get(message)
        if kind.length is None:
            out(LENGTH.pack(len(value)))
        out(struct.pack(f"<{len(value) if kind.length is None else kind.length}{code}", *value))

    def read_(message: Any, data: bytes, start: int) -> int:
        size, start = _size(data, start, kind.length)
        form = f"<{size}{code}"
        end = start + struct.calcsize(form)
        values: Any = struct.unpack(form, data[start:end])
        set_(message, list(map(bool, values)) if kind.base == "bool" else values)
        return end

    return Step(write, read_)


def numpy_array(name: str, kind: Kind) -> Step:
    """An array of numbers or bools that is one of numpy's. Its bytes are written as they are, whatever its type."""
    numpy: Any = import_module("numpy")
    get, set_, dtype = attrgetter(name), _setter(name), "?" if kind.base == "bool" else SIMPLE[kind.base]
    width: int = numpy.dtype(dtype).itemsize

    def write(message: Any, out: Write, at: list[Any]) -> None:
        value = get(message)
        if kind.length is None:
            out(LENGTH.pack(len(value)))
        out(value.tobytes())

    def read_(message: Any, data: bytes, start: int) -> int:
        size, start = _size(data, start, kind.length)
        end = start + size * width
        set_(message, numpy.frombuffer(data[start:end], dtype, size))
        return end

    return Step(write, read_)


def _elements(value: Any, kind: Kind, out: Write, name: str) -> Any:
    """Write or check an array's length, and return its elements."""
    if kind.length is None:
        out(LENGTH.pack(len(value)))
    elif len(value) != kind.length:
        raise LengthError(f"Expecting {kind.length} items but found {len(value)} when writing '{name}'")
    return value


def _strings(name: str, kind: Kind, path: str) -> Step:
    get, set_ = attrgetter(name), _setter(name)

    def write(message: Any, out: Write, at: list[Any]) -> None:
        for item in _elements(get(message), kind, out, f"{path}.{name}"):
            len(item)
            text = item.encode("utf-8")
            out(LENGTH.pack(len(text)) + text)

    def read_(message: Any, data: bytes, start: int) -> int:
        size, start = _size(data, start, kind.length)
        found = []
        for _ in range(size):
            text, start = _text(data, start)
            found.append(text)
        set_(message, found)
        return start

    return Step(write, read_)


def _messages(name: str, kind: Kind, nested: Nested, array: Array, path: str) -> Step:
    """An array of messages or of times."""
    get, set_ = attrgetter(name), _setter(name)
    inner = nested(kind.base)
    assert inner
    fields, make = inner
    element = f"val{1 if path == 'self' else int(path.removeprefix('val')) + 1}"
    steps = plan(fields, nested, array, element, flat=False)

    def write(message: Any, out: Write, at: list[Any]) -> None:
        for item in _elements(get(message), kind, out, f"{path}.{name}"):
            for step in steps:
                step.write(item, out, at)

    def read_(message: Any, data: bytes, start: int) -> int:
        size, start = _size(data, start, kind.length)
        found = []
        for _ in range(size):
            item = make()
            start = read(steps, item, data, start)
            found.append(item)
        set_(message, found)
        return start

    return Step(write, read_)
