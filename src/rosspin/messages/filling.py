"""Messages of ROS 1 by name, and filled from lists and dictionaries, as of YAML (source: genpy/message.py)."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

from .genpy import Duration, Time, TVal
from .ros1 import DeserializationError, Message, MessageException, SerializationError, check_type, strify_message
from .wire import SIMPLE

__all__ = [
    "DeserializationError",
    "Duration",
    "Message",
    "MessageException",
    "SerializationError",
    "TVal",
    "Time",
    "check_type",
    "fill_message_args",
    "get_message_class",
    "get_printable_message_args",
    "get_service_class",
    "strify_message",
]


def get_message_class(message_type: str, reload_on_error: bool = False) -> Any:
    """Return the class with a name such as std_msgs/String, or None. Raises ValueError for a name without a package."""
    return _class_of("msg", message_type)


def get_service_class(service_type: str, reload_on_error: bool = False) -> Any:
    """The same for a service."""
    return _class_of("srv", service_type)


def _class_of(folder: str, name: str) -> Any:
    if name.count("/") > 1:
        raise ValueError(f"invalid name [{name}]")
    package, _, short = name.rpartition("/")
    if not package and short != "Header":
        raise ValueError(f"message type is missing package name: {name}")
    try:
        return getattr(import_module(f"{package or 'std_msgs'}.{folder}"), short, None)
    except ImportError:
        return None


def get_printable_message_args(msg: Message, buff: Any = None, prefix: str = "") -> str:
    """Return the names of all fields; in a message inside, they follow its name and a dot."""
    names = []
    for name in msg.__slots__:
        value = getattr(msg, name)
        inside = isinstance(value, Message)
        names.append(get_printable_message_args(value, prefix=f"{prefix}{name}.") if inside else prefix + name)
    return " ".join(names)


def fill_message_args(msg: Any, msg_args: Any, keys: Mapping[str, Any] = {}) -> None:  # noqa: B006, never changed
    """Set fields from a list of all values, or from a list with one dictionary of some.

    A time may be a number of nanoseconds; ``keys`` has what stands for a time or a message by a word, as ``now``.
    Values are not checked here. Raises MessageException for wrong names, words and numbers of values, ValueError for
    what is no list.
    """
    args = [] if msg_args is None else msg_args
    _fill_message_args(msg, args[0] if len(args) == 1 and type(args[0]) is dict else args, keys, "")


def _fill_message_args(msg: Any, args: Any, keys: Mapping[str, Any], prefix: str) -> None:
    if not isinstance(msg, (Message, TVal)):
        raise ValueError(f"msg must be a Message instance: {msg}")
    if type(args) is list:
        if len(args) != len(msg.__slots__):
            how = "Too many" if len(args) > len(msg.__slots__) else "Not enough"
            raise MessageException(f"{how} arguments:\n * Given: {args}\n * Expected: {msg.__slots__}")
        args = dict(zip(msg.__slots__, args, strict=True))
    elif type(args) is dict:
        args = {name: "" if value is None else value for name, value in args.items()}
    else:
        raise ValueError(f"invalid msg_args type: {args}")
    for name, value in args.items():
        _set(msg, name, value, keys, prefix)


def _set(msg: Any, name: str, value: Any, keys: Mapping[str, Any], prefix: str) -> None:
    if name not in msg.__slots__:
        raise MessageException(f"No field name [{prefix}{name}]")
    now, what = getattr(msg, name), f"Field [{prefix}{name}]"
    if isinstance(now, (Message, TVal)):
        if type(value) is str:
            if value not in keys:
                raise MessageException(f"No key named [{value}]")
            value = keys[value]
        else:
            value = _made(now, value, keys, f"{prefix}{name}.")
    elif type(now) is list:
        if type(value) not in (list, tuple):
            raise MessageException(f"{what} must be a list or tuple instead of: {type(value).__name__}")
        base, _, length = msg._slot_types[msg.__slots__.index(name)].partition("[")
        if (most := length.rstrip("]")) and len(value) != int(most):
            raise MessageException(f"{what} has incorrect number of elements: {len(value)} != {most}")
        if base not in SIMPLE and base != "string":
            times: dict[str, Any] = {"time": Time, "duration": Duration}
            kind = times.get(base) or get_message_class(base)
            value = [_made(kind(), each, keys, prefix) for each in value]
    setattr(msg, name, value)


def _made(new: Any, value: Any, keys: Mapping[str, Any], prefix: str) -> Any:
    """Fill a message or a time that stands in a field."""
    if isinstance(new, TVal) and type(value) is int:
        return type(new).from_sec(value / 1e9)
    _fill_message_args(new, value, keys, prefix)
    return new
