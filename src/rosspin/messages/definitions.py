"""The text of a message definition, read line by line: a ``.msg`` file, or a part of a ``.srv`` or ``.action`` file.

The grammar of ROS 1 is genmsg's (source: genmsg/msg_loader.py and msgs.py), ROS 2's is rosidl's (source:
rosidl_adapter/parser.py): ROS 2 has bounds and default values, ROS 1 has ``time``, ``duration`` and ``Header``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from typing import NoReturn

__all__ = [
    "BUILTIN",
    "CODES",
    "INTEGERS",
    "Constant",
    "Definition",
    "DefinitionError",
    "Field",
    "Kind",
    "Value",
    "limits",
    "parse",
    "split",
    "unknown",
]

Value = bool | int | float | str

INTEGERS = {f"{sign}int{bits}": bits for sign in ("", "u") for bits in (8, 16, 32, 64)}
PRIMITIVE = {*INTEGERS, "bool", "byte", "char", "float32", "float64", "string"}  # what constants may be
CODES = dict(zip(INTEGERS, "bhiqBHIQ")) | {"char": "B", "float32": "f", "float64": "d"}  # of arrays, and in struct
BUILTIN = {1: PRIMITIVE | {"time", "duration"}, 2: PRIMITIVE | {"wstring"}}

LINE = re.compile(
    r"(?P<type>[A-Za-z][\w/]*)(?P<size><=\d+)?(?P<array>\[(?:<=)?\d*\])? +"
    r"(?P<name>[A-Za-z]\w*) *(?P<rest>.*)"
)
QUOTED = re.compile(r""" *("(?:\\.|[^"])*"|'(?:\\.|[^'])*'|[^,]+?) *(?:,|$)""")
BOOLS = {1: ("True", "False", "1", "0"), 2: ("true", "false", "1", "0")}
ROS2_FIELD = re.compile(r"[a-z](_?[a-z0-9])*")
ROS2_CONSTANT = re.compile(r"[A-Z](_?[A-Z0-9])*")


class DefinitionError(SyntaxError):
    """A message definition is faulty: ``filename``, ``lineno``, ``text`` (the line) and ``msg`` say where and what."""


@dataclass(frozen=True)
class Kind:
    """The type of a field.

    ``base`` is a built-in type or a message with its package. ``length`` is a fixed array's, else None; ``bound``
    and ``size`` are the greatest length of an array and of a string, if there is one.
    """

    base: str
    array: bool = False
    length: int | None = None
    bound: int | None = None
    size: int | None = None

    @property
    def element(self) -> Kind:
        """The type of an array's elements."""
        return Kind(self.base, size=self.size)

    @property
    def bounds(self) -> str:
        """What follows the base: [], [9] or [<=9] for an array, else nothing."""
        if not self.array:
            return ""
        return f"[<={self.bound}]" if self.bound is not None else f"[{'' if self.length is None else self.length}]"

    def __str__(self) -> str:
        return self.base + self.bounds


@dataclass(frozen=True)
class Field:
    """A field: its type, its name, its default value (ROS 2; None: the type's own), the line's number, from 1."""

    kind: Kind
    name: str
    default: Value | list[Value] | None
    line: int


@dataclass(frozen=True)
class Constant:
    """A constant; ``text`` is its value as written, which counts for the md5 sum."""

    type: str
    name: str
    value: Value
    text: str


@dataclass(frozen=True)
class Definition:
    """A message's definition; ``name`` as in std_msgs/Header, ``file`` is where ``text`` comes from.

    For a part of a service or action, ``part_of`` names that, as in srv/SetBool, and ``above`` is how many lines of the
    file are above the text.
    """

    name: str
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...]
    text: str
    file: str
    part_of: str = ""
    above: int = 0

    def fault(self, line: int, what: str) -> NoReturn:
        """Raise DefinitionError, which says ``what`` is wrong in a line, counted from 1."""
        raise DefinitionError(what, (self.file, self.above + line, None, self.text.split("\n")[line - 1]))


def parse(text: str, name: str, file: str, ros: int, part_of: str = "", above: int = 0) -> Definition:
    """Read the definition of the message ``name``, as in std_msgs/Header, by the rules of ROS 1 or 2.

    Raises DefinitionError, which names ``file``, for a line that those rules do not allow.
    """
    fields: list[Field] = []
    constants: list[Constant] = []
    names: set[str] = set()
    for number, line in enumerate(text.split("\n"), start=1):
        code = line.partition("#")[0].strip()
        if not code:
            continue
        try:
            found = _line(code, line, number, name.partition("/")[0], ros)
            if found.name in names:
                raise ValueError(f"the name {found.name} is there twice")
        except ValueError as error:
            raise DefinitionError(str(error), (file, above + number, None, line)) from None
        names.add(found.name)
        if isinstance(found, Constant):
            constants.append(found)
        else:
            fields.append(found)
    return Definition(name, tuple(fields), tuple(constants), text, file, part_of, above)


def split(text: str, file: str, suffixes: Sequence[str]) -> dict[str, tuple[str, int]]:
    """Split a service or action at its lines ``---``: return, for each suffix, a text and how many lines are above it.

    Raises DefinitionError unless there are as many parts as suffixes.
    """
    parts: list[list[str]] = [[]]
    starts = [0]
    for number, line in enumerate(text.split("\n"), start=1):
        if line.startswith("---"):
            if len(parts) == len(suffixes):
                raise DefinitionError(f"one line --- too many, after {len(parts)} parts", (file, number, None, line))
            parts.append([])
            starts.append(number)
        else:
            parts[-1].append(line)
    if len(parts) < len(suffixes):
        what = " and ".join(suffix.strip("_").lower() for suffix in suffixes)
        raise DefinitionError(f"a line --- is missing between {what}", (file, len(text.split("\n")), None, ""))
    texts = ["".join(f"{line}\n" for line in lines) for lines in parts]
    return dict(zip(suffixes, zip(texts, starts, strict=True), strict=True))


def unknown(base: str, ros: int) -> str:
    """Say what is wrong with a type that is neither built in nor a message that could be found."""
    short = base.rpartition("/")[2]
    if ros == 2 and short in ("time", "duration"):
        return f"ROS 2 has no type {short}: write builtin_interfaces/{short.title()}"
    if ros == 2 and short == "Header":
        return "in ROS 2 a header is written std_msgs/Header"
    close = get_close_matches(short, BUILTIN[ros], n=1)
    return f"there is no message {base}" + (f"; did you mean {close[0]}?" if close else "")


@cache
def limits(type_: str, ros: int) -> tuple[int, int]:
    """The least and the greatest value of an integer type; a byte is signed in ROS 1 only, a char never."""
    bits = INTEGERS.get(type_, 8)
    if type_.startswith("u") or type_ == "char" or (type_ == "byte" and ros == 2):
        return 0, 2**bits - 1
    return -(2 ** (bits - 1)), 2 ** (bits - 1) - 1


def _line(code: str, line: str, number: int, package: str, ros: int) -> Field | Constant:
    """Read a line, of which ``code`` is the part before the comment. Raises ValueError, which says what is wrong."""
    match = LINE.fullmatch(code.replace("\t", " ") if ros == 2 else code)
    if not match:
        raise ValueError("expected a type, a space and a name, as in: uint32 counter")
    base, size, array, name, rest = match.group("type", "size", "array", "name", "rest")
    bounds = (array or "").strip("[]")
    if ros == 1 and (size or bounds.startswith("<=")):
        raise ValueError("only ROS 2 has bounds (<=)")
    if size and base not in ("string", "wstring"):
        raise ValueError(f"only a string or an array has a bound, not {base}")
    if rest.startswith("="):
        if array or base not in PRIMITIVE:
            raise ValueError(f"a constant is a number, a bool or a string, not {base}{array or ''}")
        if ros == 2 and not ROS2_CONSTANT.fullmatch(name):
            raise ValueError(f"ROS 2 wants constants in upper case, as in MAX_SPEED, not {name}")
        # In ROS 1 a string continues to the end of its line, a # belongs to it.
        written = (line.partition("=")[2] if base == "string" and ros == 1 else rest[1:]).strip()
        return Constant(base, name, _value(base, written, ros), written)
    if ros == 2 and not ROS2_FIELD.fullmatch(name):
        raise ValueError(f"ROS 2 wants fields in lower case, as in max_speed, not {name}")
    if base == "Header" and ros == 1 and not array:
        base = "std_msgs/Header"
    elif base not in BUILTIN[ros] and "/" not in base:
        base = f"{package}/{base}"
    if base.count("/") > 1 or base.endswith("/"):
        raise ValueError(f"a type is written package/Name, not {base}")
    if rest and (ros == 1 or base not in BUILTIN[2]):
        raise ValueError(f"{rest!r} is too much after the name")
    kind = Kind(
        base,
        array=bool(array),
        length=int(bounds) if bounds.isdigit() else None,
        bound=int(bounds[2:]) if bounds.startswith("<=") else None,
        size=int(size[2:]) if size else None,
    )
    return Field(kind, name, _default(kind, rest) if rest else None, number)


def _default(kind: Kind, text: str) -> Value | list[Value]:
    if not kind.array:
        return _value(kind.base, text, 2)
    if not (text.startswith("[") and text.endswith("]")):
        raise ValueError(f"an array's default is written as in [1, 2], not {text}")
    found = [_value(kind.base, item, 2) for item in QUOTED.findall(text[1:-1])]
    if kind.length not in (None, len(found)) or (kind.bound is not None and len(found) > kind.bound):
        raise ValueError(f"{len(found)} values are not right for {kind.base}{kind.bounds}")
    return found


def _value(type_: str, text: str, ros: int) -> Value:
    """Read a value of a type that constants may have. Raises ValueError if the text is no such value."""
    if type_ in ("string", "wstring"):
        quoted = ros == 2 and text[:1] in ('"', "'") and text.endswith(text[:1])
        return text[1:-1].replace("\\" + text[0], text[0]) if quoted else text
    if type_ == "bool":
        if (text.lower() if ros == 2 else text) not in BOOLS[ros]:
            raise ValueError(f"{text!r} is not a bool: {' or '.join(BOOLS[ros][:2])}")
        return text.lower() in ("true", "1")
    try:
        number = float(text) if type_.startswith("float") else int(text, 10 if ros == 1 or text.isdigit() else 0)
    except ValueError:
        raise ValueError(f"{text!r} is not a value of {type_}") from None
    if isinstance(number, int):
        lowest, highest = limits(type_, ros)
        if not lowest <= number <= highest:
            raise ValueError(f"{number} is not a value of {type_}: {lowest} to {highest}")
    return number
