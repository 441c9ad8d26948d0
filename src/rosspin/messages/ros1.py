"""Message classes as genpy generates them (source: genpy/message.py and generator.py)."""

from __future__ import annotations

import hashlib
import io
import struct
import sys
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, ClassVar, TypeVar

from . import classes
from . import genpy as rostime
from .definitions import BUILTIN, Definition, Field, Kind, limits
from .genpy import Duration, Time, TVal
from .wire import SIMPLE, LengthError, Step, plan, read, safe

__all__ = [
    "DeserializationError",
    "Message",
    "MessageException",
    "Messages",
    "SerializationError",
    "Service",
    "check_type",
    "rostime",
    "strify_message",
    "transfer",
]

M = TypeVar("M", bound="Message")

TIMES: dict[str, type[TVal]] = {"time": Time, "duration": Duration}
TIME_FIELDS = {
    base: (Field(Kind(number), "secs", None, 0), Field(Kind(number), "nsecs", None, 0))
    for base, number in (("time", "uint32"), ("duration", "int32"))
}
HEADERS = ("Header", "std_msgs/Header", "roslib/Header")
NUMPY_NUMBERS = {f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)} | {"float32", "float64"}


class MessageException(Exception):
    """Base of genpy's errors."""


class SerializationError(MessageException):
    """A field has a value that its type does not have."""


class DeserializationError(MessageException):
    """These bytes are not a whole message."""


for _error in (MessageException, SerializationError, DeserializationError):
    _error.__module__ = "genpy.message"  # so that tracebacks name them as on a real ROS


class Message:
    """Base of all messages.

    The arguments are all fields in their order, or some by keyword; None stands for the default. Raises TypeError for
    too many or too few, AttributeError for an unknown name. Values are checked only when the message is serialised.
    """

    __slots__: list[str] = ["_connection_header"]
    _type: ClassVar[str]
    _md5sum: ClassVar[str]
    _full_text: ClassVar[str]
    _has_header: ClassVar[bool]
    _slot_types: ClassVar[list[str]]
    _defaults: ClassVar[list[tuple[str, Callable[[], Any]]]]
    _made_of: ClassVar[list[tuple[str, Callable[[], Any]]]]  # its nested messages and times
    _times: ClassVar[list[str]]
    _plan: ClassVar[Callable[..., list[Step]]]  # makes its steps, for any kind of arrays
    _steps: ClassVar[list[Step]]

    def __init__(self, *args: Any, **kwds: Any) -> None:
        if not args and not kwds:  # as for each message that is received
            for name, default in self._defaults:
                setattr(self, name, default())
            return
        if args and kwds:
            raise TypeError("Message constructor may only use args OR keywords, not both")
        if args and len(args) != len(self.__slots__):
            raise TypeError(f"Invalid number of arguments, args should be {self.__slots__} args are{args}")
        for name in kwds:
            if name not in self.__slots__:
                raise AttributeError(f"{name} is not an attribute of {type(self).__name__}")
        values = args or map(kwds.get, self.__slots__)
        for (name, default), value in zip(self._defaults, values):
            setattr(self, name, default() if value is None else value)

    def __getstate__(self) -> list[Any]:
        return [getattr(self, name) for name in self.__slots__]

    def __setstate__(self, state: Sequence[Any]) -> None:
        for name, value in zip(self.__slots__, state, strict=False):
            setattr(self, name, value)

    def _get_types(self) -> list[str]:
        return self._slot_types

    def _check_types(self, exc: Exception | None = None) -> None:
        """Raise SerializationError for the first field that has a wrong value, or else with the text of ``exc``."""
        for name, type_ in zip(self.__slots__, self._get_types(), strict=True):
            check_type(name, type_, getattr(self, name))
        if exc:
            raise SerializationError(str(exc))

    def serialize(self, buff: Any) -> None:
        """Write the message into a binary file or buffer, in pieces. SerializationError for a wrong value.

        As in genpy, a value without the needed attributes raises AttributeError, and an error leaves half a message in
        the buffer.
        """
        at: list[Any] = [self]
        try:
            for step in self._steps:
                step.write(self, buff.write, at)
        except LengthError as error:
            self._check_types(error)
        except (struct.error, TypeError) as error:
            self._check_types(ValueError(f"{type(error)}: '{error}' when writing '{at[0]}'"))

    def deserialize(self: M, data: bytes) -> M:
        """Fill this message from its bytes, and return it. DeserializationError if there are too few."""
        for name, make in self._made_of:
            if getattr(self, name) is None:
                setattr(self, name, make())
        try:
            read(self._steps, self, data)
        except struct.error as error:
            raise DeserializationError(error) from error
        for name in self._times:
            getattr(self, name).canon()
        return self

    def __repr__(self) -> str:
        return strify_message(self)

    # Lists and tuples of the same elements are equal.
    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return False
        for name in self.__slots__:
            try:
                ours, theirs = getattr(self, name), getattr(other, name)
            except AttributeError:
                return False
            if type(ours) in (list, tuple) and type(theirs) in (list, tuple):
                ours, theirs = tuple(ours), tuple(theirs)
            if not ours == theirs:
                return False
        return True


class Service:
    """Base of all services: the classes of its two messages, and the sum of both."""

    _type: ClassVar[str]
    _md5sum: ClassVar[str]
    _request_class: ClassVar[type[Message]]
    _response_class: ClassVar[type[Message]]


def transfer(message: Message, data_class: type[M]) -> M:
    """Make the message that a subscriber with this class receives: a new one, as it comes off the wire.

    Floats of 32 bits are rounded, arrays of numbers are tuples, of uint8 bytes. Raises SerializationError, or
    whatever else ``serialize`` raises, for a message that cannot be sent.
    """
    buffer = io.BytesIO()
    message.serialize(buffer)
    return data_class().deserialize(buffer.getvalue())


class Messages(classes.Messages[Message]):
    """The classes that genpy would generate."""

    @staticmethod
    def module(name: str) -> str:
        """The module in which genpy puts the class of this name."""
        return f"_{name}"

    def _make(self, definition: Definition) -> type[Message]:
        name = definition.name.partition("/")[2]
        slots = [safe(field.name) for field in definition.fields]
        first = definition.fields[0] if definition.fields else None
        needed = [definition, *self._nested(definition)]
        steps = partial(plan, definition.fields, self._inside)
        namespace = {
            "__doc__": f"The message {definition.name}: {', '.join(slots) or 'no fields'}.",
            "__module__": self.home(definition),
            "__slots__": slots,
            "_type": definition.name,
            "_md5sum": _md5(self._summed(definition)),
            "_full_text": ("\n" + "=" * 80 + "\n").join(
                f"MSG: {each.name}\n{each.text}" if each is not definition else each.text for each in needed
            ),
            "_has_header": bool(first and str(first.kind) == "std_msgs/Header" and first.name == "header"),
            "_slot_types": [str(field.kind) for field in definition.fields],
            "_defaults": [(safe(field.name), self._default(field.kind)) for field in definition.fields],
            "_made_of": [
                (safe(field.name), inside[1])
                for field in definition.fields
                if not field.kind.array and (inside := self._inside(field.kind.base))
            ],
            "_times": [safe(field.name) for field in definition.fields if str(field.kind) in TIMES],
            "_plan": steps,
            "_steps": steps(),
        }
        return type(name, (Message,), {**namespace, **{each.name: each.value for each in definition.constants}})

    def _inside(self, base: str) -> tuple[Sequence[Field], Callable[[], Any]] | None:
        if base in TIMES:
            return TIME_FIELDS[base], TIMES[base]
        return None if base in BUILTIN[1] else (self.library.definition(base).fields, self[base])

    def _default(self, kind: Kind) -> Callable[[], Any]:
        """A function that makes a type's default value."""
        if kind.array:
            length = kind.length or 0
            if kind.base in ("uint8", "char"):
                zeros = bytes(length)
                return lambda: zeros
            element = self._default(kind.element)
            return lambda: [element() for _ in range(length)]
        if inside := self._inside(kind.base):
            return inside[1]
        return {"string": str, "bool": bool, "float32": float, "float64": float}.get(kind.base, int)

    def _nested(self, definition: Definition) -> list[Definition]:
        """The definitions of all messages in a message, in genmsg's order."""
        found: dict[str, Definition] = {}
        for field in definition.fields:
            if field.kind.base not in BUILTIN[1]:
                inner = self.library.definition(field.kind.base)
                found |= {each.name: each for each in (inner, *self._nested(inner)) if each.name not in found}
        return list(found.values())

    def _assemble(self, folder: str, name: str, parts: dict[str, type[Message]]) -> type[Service]:
        package, _, short = name.partition("/")
        request, response = parts.values()
        text = "".join(self._summed(self.library.definition(part._type)) for part in parts.values())
        namespace = {
            "__doc__": f"The service {name}.",
            "__module__": f"{package}.{folder}.{self.module(short)}",
            "_type": name,
            "_md5sum": _md5(text),
            "_request_class": request,
            "_response_class": response,
        }
        return type(short, (Service,), namespace)

    def _summed(self, definition: Definition) -> str:
        """The text that the md5 sum is of: constants and fields; nested ones by theirs (source: genmsg/gentools.py)."""
        lines = [f"{each.type} {each.name}={each.text}" for each in definition.constants]
        for field in definition.fields:
            base = field.kind.base
            lines.append(f"{field.kind if base in BUILTIN[1] else self[base]._md5sum} {field.name}")
        return "\n".join(lines).strip()


def _md5(text: str) -> str:
    return hashlib.md5(text.encode(), usedforsecurity=False).hexdigest()


def check_type(name: str, type_: str, value: Any) -> None:
    """Raise SerializationError, in genpy's words, if a field cannot have this value.

    ``name`` is the field's, ``type_`` its type as in float64[9].
    """
    kind = type(value)
    if type_ in ("float32", "float64"):
        if kind not in (float, int) and not _is_numpy_number(kind):
            raise SerializationError(f"field {name} must be float type")
    elif type_ == "bool":
        if value not in [True, False, 0, 1]:
            raise SerializationError(f"field {name} is not a bool")
    elif type_ in SIMPLE:
        lowest, highest = limits(type_, 1)
        if lowest == 0 and (kind is not int or value < 0):
            raise SerializationError(f"field {name} must be unsigned integer type")
        if kind is not int:
            raise SerializationError(f"field {name} must be an integer type")
        if not lowest <= value <= highest:
            raise SerializationError(f"field {name} exceeds specified width [{type_}]")
    elif type_ == "string":
        if kind is str and not value.isascii():
            raise SerializationError(f"field {name} is a non-ascii string")
        if kind not in (str, bytes):
            raise SerializationError(f"field {name} must be of type bytes or an ascii string")
    elif type_ in TIMES:
        if not isinstance(value, TIMES[type_]):
            raise SerializationError(f"field {name} must be of type {TIMES[type_].__name__}")
    elif type_.endswith("]"):
        _check_array(name, type_.partition("[")[0], value)
    else:
        _check_message(name, type_, value)


def _check_array(name: str, base: str, value: Any) -> None:
    if type(value) in (bytes, str):
        if base not in ("char", "uint8"):
            raise SerializationError(f"field {name} must be a list or tuple type. Only uint8[] can be a string")
    elif type(value) not in (list, tuple):
        raise SerializationError(f"field {name} must be a list or tuple type")
    else:
        for item in value:
            check_type(f"{name}[]", base, item)


def _check_message(name: str, type_: str, value: Any) -> None:
    if not isinstance(value, Message):
        raise SerializationError(f"field {name} must be of type [{type_}]")
    if value._type in HEADERS:
        if type_ not in HEADERS:
            raise SerializationError(f"field {name} must be a Header instead of a {value._type}")
    elif value._type != type_:
        raise SerializationError(f"field {name} must be of type {type_} instead of {value._type}")
    for slot, inner in zip(value.__slots__, value._get_types(), strict=True):
        check_type(f"{name}.{slot}", inner, getattr(value, slot))


def _is_numpy_number(kind: type) -> bool:
    # Without an import: where numpy is not loaded, no value is numpy's.
    numpy = sys.modules.get("numpy")
    return numpy is not None and kind in {getattr(numpy, name) for name in NUMPY_NUMBERS}


def strify_message(val: Any, indent: str = "") -> str:
    """Write a message, or a field's value, as YAML; with an indent, a text of several lines begins on a new one."""
    kind = type(val)
    if kind in (int, float, bool):
        return str(val)
    if isinstance(val, str):
        return _yaml(val, default_style='"') if val else "''"
    if isinstance(val, TVal):
        return "\n%ssecs: %s\n%snsecs: %9d" % (indent, val.secs, indent, val.nsecs)  # noqa: UP031, %d takes floats
    if kind in (list, tuple):
        return _strify_array(val, indent)
    if isinstance(val, Message):
        lines = [f"{indent}{name}: {strify_message(item, '  ' + indent)}" for name, item in _items(val)]
        return ("\n" if indent else "") + "\n".join(lines)
    return str(val)


def _strify_array(val: Sequence[Any], indent: str) -> str:
    if not val:
        return "[]"
    if isinstance(val[0], str):
        text = _yaml(val)
        assert text[0] in "[-"  # genpy cannot print a tuple of strings
        return text if text.startswith("[") else "\n" + "\n".join(indent + line for line in text.splitlines())
    if type(val[0]) in (int, float, bool):
        return str(list(val))
    return "\n" + "\n".join(f"{indent}- {strify_message(item, indent + '  ')}" for item in val)


def _items(message: Message) -> Iterator[tuple[str, Any]]:
    """Names and values of a message's fields; a uint8 array in bytes or a string is turned into numbers."""
    for name, type_ in zip(message.__slots__, message._slot_types, strict=True):
        value = getattr(message, name)
        if "uint8[" in type_ and isinstance(value, str):
            value = [ord(letter) for letter in value]
        elif "uint8[" in type_ and isinstance(value, bytes):
            value = list(value)
        yield name, value


def _yaml(value: Any, **style: Any) -> str:
    import yaml  # here: it is needed only where a string is printed

    return str(yaml.dump(value, **style)).rstrip("\n")
