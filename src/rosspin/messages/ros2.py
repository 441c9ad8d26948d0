"""Message classes as rosidl generates them for Python (measured on Jazzy; source: rosidl_generator_py's templates).

Fields are always checked when they are set, as with ROS_PYTHON_CHECK_FIELDS=1: unchecked, as rosidl's are by default, a
wrong value arrives as garbage. Arrays of numbers are ``array.array``; with a fixed length they are numpy's where numpy
can be imported, as in ROS 2, and ``array.array`` elsewhere.

PYTEST_DONT_REWRITE: the assertions say what they say on a real ROS.
"""

from __future__ import annotations

import math
import re
import struct
from array import array
from collections import UserList, UserString
from collections.abc import Sequence, Set
from functools import cache
from importlib import import_module
from operator import attrgetter
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from . import classes, rosidl_parser
from .definitions import BUILTIN, CODES, Definition, Field, Kind, limits

__all__ = ["Action", "Message", "Messages", "Service", "received", "transfer"]

M = TypeVar("M", bound="Message")

IDL = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}
PYTHON: dict[str, type[Any]] = {
    "bool": bool,
    "byte": bytes,
    "string": str,
    "wstring": str,
    "float32": float,
    "float64": float,
}
# What rosidl takes for a float's greatest value.
GREATEST = {"float32": ("3.402823466e+38", "float"), "float64": ("1.7976931348623157e+308", "double")}


class Message:
    """Base of all messages. The arguments are fields by keyword; AssertionError for a wrong name or value."""

    __slots__ = ()
    if TYPE_CHECKING:
        _fields_and_field_types: ClassVar[dict[str, str]]
        SLOT_TYPES: ClassVar[tuple[Any, ...]]
        _rosspin_fields: ClassVar[dict[str, _Field]]  # of the metaclass, so that a message has no such name

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Names and types of the fields, in ROS 2's interface language."""
        return dict(cls._fields_and_field_types)

    def __repr__(self) -> str:
        fields = (f"{name}={field.show(getattr(self, name))}" for name, field in type(self)._rosspin_fields.items())
        home = type(self).__module__.split(".")[:-1]
        return f"{'.'.join([*home, type(self).__name__])}({', '.join(fields)})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return False
        return all(
            field.equal(getattr(self, name), getattr(other, name)) for name, field in type(self)._rosspin_fields.items()
        )

    # rosidl's classes have no hash either: two equal messages may change apart.
    __hash__ = None  # type: ignore[assignment]


class _Interface:
    """Base of services and actions, which have no instances."""

    def __init__(self) -> None:
        raise NotImplementedError("Service classes can not be instantiated")


class Service(_Interface):
    """Base of all services."""

    if TYPE_CHECKING:
        Request: ClassVar[type[Message]]
        Response: ClassVar[type[Message]]
        Event: ClassVar[type[Message]]


class Action(_Interface):
    """Base of all actions. ``Impl`` has the services and messages that an action consists of."""

    if TYPE_CHECKING:
        Goal: ClassVar[type[Message]]
        Result: ClassVar[type[Message]]
        Feedback: ClassVar[type[Message]]
        Impl: ClassVar[Any]


def transfer(message: Message, data_class: type[M]) -> M:
    """Check a message that is sent, and copy it as ``received`` does.

    Raises AssertionError for a wrong value that was never checked: ``data.append``.
    """
    _check(message)
    return received(message, data_class)


def received(message: Message, data_class: type[M]) -> M:
    """Make the message that a receiver with this class gets, which may be in another process: a new one.

    Floats of 32 bits are rounded.
    """
    copy = data_class.__new__(data_class)
    for field in data_class._rosspin_fields.values():
        setattr(copy, field.slot, field.copy(getattr(message, field.slot)))
    return copy


def _check(message: Message) -> None:
    for field in type(message)._rosspin_fields.values():
        value = field.check(getattr(message, field.slot))
        if field.message:
            for each in value if field.kind.array else (value,):
                _check(each)


class _Field:
    """One field of a class: its default, its check, and how it is shown, compared and copied.

    ``message`` is the class of a nested message, or None.
    """

    def __init__(self, field: Field, message: type[Message] | None) -> None:
        self.name = field.name
        self.slot = f"_{field.name}"
        self.kind = field.kind
        self.message = message
        self.given = _octets(field.default) if self.kind.base == "byte" else field.default
        self.type: Any = message or PYTHON.get(self.kind.base, int)
        self.code = CODES.get(self.kind.base) if self.kind.array else None  # of an array of numbers

    @property
    def idl(self) -> str:
        base, kind = IDL.get(self.kind.base, self.kind.base), self.kind
        if kind.size is not None:
            base += f"<{kind.size}>"
        if kind.length is not None:
            return f"{base}[{kind.length}]"
        if kind.array:
            return f"sequence<{base}>" if kind.bound is None else f"sequence<{base}, {kind.bound}>"
        return base

    @property
    def slot_type(self) -> Any:
        """What describes the type in ``SLOT_TYPES``."""
        kind, value_type = self.kind, self._value_type()
        if kind.length is not None:
            return rosidl_parser.Array(value_type, kind.length)
        if kind.bound is not None:
            return rosidl_parser.BoundedSequence(value_type, kind.bound)
        return rosidl_parser.UnboundedSequence(value_type) if kind.array else value_type

    def _value_type(self) -> Any:
        base, size = self.kind.base, self.kind.size
        if self.message:
            package, folder, _ = self.message.__module__.split(".")
            return rosidl_parser.NamespacedType([package, folder], self.message.__name__)
        if base == "string":
            return rosidl_parser.UnboundedString() if size is None else rosidl_parser.BoundedString(size)
        if base == "wstring":
            return rosidl_parser.UnboundedWString() if size is None else rosidl_parser.BoundedWString(size)
        return rosidl_parser.BasicType(IDL.get(base, base))

    def default(self) -> Any:
        """A new default value."""
        if not self.kind.array:
            return self._zero() if self.given is None else self.given
        if self.code and self.kind.length is not None:
            return _fixed(self.code, self.given or [0] * self.kind.length)
        values: Any = self.given if self.given is not None else [self._zero() for _ in range(self.kind.length or 0)]
        return array(self.code, values) if self.code else list(values)

    def _zero(self) -> Any:
        if self.message:
            return self.message()
        if self.kind.base == "byte":
            return b"\0"
        return self.type()

    def construct(self, value: Any) -> Any:
        """Turn a constructor's argument into an array of numbers, if the field is one; the check comes later."""
        return array(self.code, value) if self.code and self.kind.length is None else value

    def check(self, value: Any) -> Any:
        """The value as the field takes it. Raises AssertionError, in rosidl's words, if it does not."""
        if self.kind.array:
            return self._check_array(value)
        what, kind = f"The '{self.name}' field must be", self.kind
        if self.message:
            assert isinstance(value, self.message), f"{what} a sub message of type '{self.message.__name__}'"
        elif kind.base == "byte":
            right = isinstance(value, (bytes, bytearray)) and len(value) == 1
            assert right, f"{what} of type 'bytes' or 'ByteString' with length 1"
        elif kind.size is not None:
            right = isinstance(value, (str, UserString)) and len(value) <= kind.size
            assert right, f"{what} string value not longer than {kind.size}"
        else:
            assert isinstance(value, self.type), f"{what} of type '{self.type.__name__}'"
            if self.type is int:
                lowest, highest = limits(kind.base, 2)
                sign = "an integer" if lowest else "an unsigned integer"
                assert lowest <= value <= highest, f"{what} {sign} in [{lowest}, {highest}]"
            elif self.type is float:
                greatest, name = GREATEST[kind.base]
                assert _in_range(value, kind), f"{what} a {name} in [-{greatest}, {greatest}]"
        return value

    def _check_array(self, value: Any) -> Any:
        kind, code = self.kind, self.code
        if code and kind.length is None and isinstance(value, array):
            assert value.typecode == code, f"The '{self.name}' array.array() must have the type code of '{code}'"
            if kind.bound is not None:
                assert len(value) <= kind.bound, f"The '{self.name}' array.array() must have a size <= {kind.bound}"
            return value
        if code and kind.length is not None:
            if (numpy := _numpy()) and isinstance(value, numpy.ndarray):
                what, dtype = f"The '{self.name}' numpy.ndarray() must have", numpy.dtype(code)
                assert value.dtype == dtype, f"{what} the dtype of 'numpy.{dtype.name}'"
                assert value.size == kind.length, f"{what} a size of {kind.length}"
                return value
        right = (
            isinstance(value, (Sequence, Set, UserList))
            and not isinstance(value, (str, UserString))
            and (kind.length is None or len(value) == kind.length)
            and (kind.bound is None or len(value) <= kind.bound)
            and all(isinstance(item, self.type) for item in value)
            and all(_in_range(item, kind) for item in value)
        )
        assert right, (
            f"The '{self.name}' field must be a set or sequence{self._length()} "
            f"each value of type '{self.type.__name__}'{_range(kind)}"
        )
        if not code:
            return value
        return array(code, value) if kind.length is None else _fixed(code, value)

    def _length(self) -> str:
        if self.kind.length is not None:
            return f" with length {self.kind.length} and"
        return " and" if self.kind.bound is None else f" with length <= {self.kind.bound} and"

    def show(self, value: Any) -> str:
        """A value as it is printed: an array as a list."""
        if self.code and self.kind.length is None:
            return repr(value.tolist())
        return repr(value)

    def equal(self, ours: Any, theirs: Any) -> bool:
        """Whether two values are equal."""
        if self.code and self.kind.length is not None:
            return list(ours) == list(theirs)
        return bool(ours == theirs)

    def copy(self, value: Any) -> Any:
        """Copy a value, as it arrives at a subscription."""
        if self.code:
            return value[:] if self.kind.length is None else _fixed(self.code, value)
        return [self._copy_one(item) for item in value] if self.kind.array else self._copy_one(value)

    def _copy_one(self, value: Any) -> Any:
        if self.message:
            return received(value, self.message)
        if self.kind.base == "float32":
            return _rounded(value)
        if self.type is str and "\0" in value:
            return str(value).partition("\0")[0]  # where a string ends in C
        return self.type(value)


class Messages(classes.Messages[Message]):
    """The classes that rosidl would generate."""

    @staticmethod
    def module(name: str) -> str:
        """The module in which rosidl puts the class of this name, as in _u_int32 (source: rosidl_pycommon)."""
        words = re.sub("([a-z0-9])([A-Z])", r"\1_\2", re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name))
        return f"_{words.lower()}"

    def _assemble(self, folder: str, name: str, parts: dict[str, type[Message]]) -> type[Service | Action]:
        package, _, short = name.partition("/")
        module = f"{package}.{folder}.{self.module(short)}"
        if folder == "srv":
            return self._service(module, name)
        impl = {
            "SendGoalService": self._service(module, f"{name}_SendGoal", events=False),
            "GetResultService": self._service(module, f"{name}_GetResult", events=False),
            "FeedbackMessage": self[f"{name}_FeedbackMessage"],
            "CancelGoalService": self.whole("srv", "action_msgs/CancelGoal"),
            "GoalStatusMessage": self["action_msgs/GoalStatusArray"],
        }
        namespace: dict[str, Any] = {suffix[1:]: part for suffix, part in parts.items()}
        namespace |= {"__doc__": f"The action {name}.", "__module__": module, "Impl": type("Impl", (), impl)}
        return _metaclass(short, "action", module, {})(short, (Action,), namespace)  # type: ignore[no-any-return]

    def _service(self, module: str, name: str, events: bool = True) -> type[Service]:
        suffixes = ("Request", "Response", "Event") if events else ("Request", "Response")
        namespace: dict[str, Any] = {suffix: self[f"{name}_{suffix}"] for suffix in suffixes}
        short = name.partition("/")[2]
        namespace |= {"__doc__": f"The service {name}.", "__module__": module}
        return _metaclass(short, "service", module, {})(short, (Service,), namespace)  # type: ignore[no-any-return]

    def _make(self, definition: Definition) -> type[Message]:
        name = definition.name.partition("/")[2]
        fields = {
            field.name: _Field(field, None if field.kind.base in BUILTIN[2] else self[field.kind.base])
            for field in definition.fields
        }
        slots = {f"_{field}" for field in (*fields, "check_fields")}
        if any(field.code and field.kind.length is not None for field in fields.values()):
            _numpy()  # as rosidl's modules do; later, a node on the wall clock would have to wait for it

        def __init__(self: Any, **kwargs: Any) -> None:
            wrong = ", ".join(sorted(key for key in kwargs if f"_{key}" not in slots))
            assert not wrong, f"Invalid arguments passed to constructor: {wrong}"
            for key, field in fields.items():
                if key in kwargs:
                    setattr(self, key, field.construct(kwargs[key]))
                else:
                    setattr(self, field.slot, field.default())

        __init__.__qualname__ = f"{name}.__init__"  # which a TypeError names
        namespace: dict[str, Any] = {
            "__doc__": f"The message {definition.name}: {', '.join(fields) or 'no fields'}.",
            "__module__": self.home(definition),
            "__slots__": [*(f"_{field}" for field in fields), "_check_fields"],
            "__init__": __init__,
            "_fields_and_field_types": {field: each.idl for field, each in fields.items()},
            "SLOT_TYPES": tuple(each.slot_type for each in fields.values()),
        }
        constants: dict[str, Any] = {}
        for constant in definition.constants:
            octet = constant.type == "byte" and isinstance(constant.value, int)
            constants[constant.name] = bytes([int(constant.value)]) if octet else constant.value
        for each in definition.fields:
            namespace[each.name] = _property(fields[each.name])
            if each.default is not None:
                constants[f"{each.name.upper()}__DEFAULT"] = fields[each.name].given
        readable = {constant: _constant(value) for constant, value in constants.items()}
        metaclass = _metaclass(name, "message", namespace["__module__"], {**readable, "_rosspin_fields": fields})
        return metaclass(name, (Message,), {**namespace, **constants})  # type: ignore[no-any-return]


def _constant(value: Any) -> property:
    return property(lambda cls: value)


def _metaclass(name: str, what: str, module: str, namespace: dict[str, Any]) -> Any:
    """Make the class of a class, on which constants can only be read."""
    own = {"__doc__": f"Metaclass of {what} '{name}'.", "__module__": module, "_TYPE_SUPPORT": None}
    return type(f"Metaclass_{name}", (type,), {**own, **namespace})


def _property(field: _Field) -> property:
    def set_(message: Message, value: Any) -> None:
        setattr(message, field.slot, field.check(value))

    return property(attrgetter(field.slot), set_, doc=f"Message field '{field.name}'.")


def _octets(default: Any) -> Any:
    """A default value of bytes, which are written as numbers."""
    if isinstance(default, list):
        return [_octets(each) for each in default]
    return default if default is None else bytes([default])


def _in_range(value: Any, kind: Kind) -> bool:
    if kind.base in GREATEST:
        greatest = float(GREATEST[kind.base][0])
        return not (value < -greatest or value > greatest) or math.isinf(value)
    if kind.base in CODES:
        lowest, highest = limits(kind.base, 2)
        return bool(lowest <= value <= highest)
    return kind.size is None or len(value) <= kind.size


def _range(kind: Kind) -> str:
    """Say in which range an array's values must be."""
    if kind.base in GREATEST:
        greatest, name = GREATEST[kind.base]
        return f" and each {name} in [{-float(greatest):f}, {float(greatest):f}]"
    if kind.base in CODES:
        lowest, highest = limits(kind.base, 2)
        return f" and each {'' if lowest else 'unsigned '}integer in [{lowest}, {highest}]"
    return "" if kind.size is None else f" and each string value not longer than {kind.size}"


def _rounded(value: float) -> float:
    """A float as 32 bits hold it."""
    (rounded,) = struct.unpack("f", struct.pack("f", value))
    return float(rounded)


@cache
def _numpy() -> Any:
    try:
        return import_module("numpy")
    except ImportError:
        return None


def _fixed(code: str, values: Any) -> Any:
    numpy = _numpy()
    return numpy.array(list(values), dtype=code) if numpy else array(code, values)
