"""rosidl_runtime_py for nodes of ROS 2 (source: rosidl_runtime_py 0.13). Loaded when a node imports it."""

from __future__ import annotations

import array
import re
import sys
from collections import OrderedDict
from collections.abc import Mapping
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

from ..world.world import refusing

__all__ = [
    "get_action",
    "get_interface",
    "get_message",
    "get_service",
    "is_action",
    "is_message",
    "is_service",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
    "set_message_fields",
]

_LONGEST = sys.maxsize
_ARRAY = re.compile(r"(?:sequence<)?([\w/]+)(?:<\d+>)?(?:\[(\d+)\]|(?:, (\d+))?>)")


def message_to_ordereddict(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> OrderedDict[str, Any]:
    """Return the fields of a message as a dictionary, messages in it likewise.

    Arrays and texts longer than ``truncate_length`` are cut; ``no_arr`` and ``no_str`` describe them instead.
    """
    plain = partial(_plain, length=truncate_length, no_arr=no_arr, no_str=no_str)
    fields = msg.get_fields_and_field_types().items()
    return OrderedDict((name, plain(getattr(msg, name), kind)) for name, kind in fields)


def _plain(value: Any, kind: str = "", *, length: int | None, no_arr: bool, no_str: bool) -> Any:
    plain = partial(_plain, length=length, no_arr=no_arr, no_str=no_str)
    most = _LONGEST if length is None else length
    if isinstance(value, (bytes, str)):
        if isinstance(value, str) and no_str:
            return f"<string length: <{len(value)}>>"
        text = value if isinstance(value, str) else value.decode("latin-1")
        return text if len(text) <= most else f"{text[:most]}..."
    if _is_array(value):
        if no_arr and kind:
            return _described(value, kind)
        more = ["..."] if len(value) > most else []
        return (tuple if isinstance(value, tuple) else list)([*map(plain, value[:most]), *more])
    if hasattr(value, "item"):  # a number of numpy's, which may be a float, too
        return value.item()
    if isinstance(value, (bool, float, int)):
        return value
    return message_to_ordereddict(value, truncate_length=length, no_arr=no_arr, no_str=no_str)


def _is_array(value: Any) -> bool:
    return isinstance(value, (list, tuple, array.array)) or hasattr(value, "dtype") and hasattr(value, "__len__")


def _described(value: Any, kind: str) -> str:
    """Describe an array instead of showing it."""
    match = _ARRAY.fullmatch(kind)
    if not match:
        return "unknown"
    base = match[1].replace("/", "/msg/")
    if match[2]:
        return f"<array type: {base}[{match[2]}]>"
    return f"<sequence type: {base}{f'[{match[3]}]' if match[3] else ''}, length: {len(value)}>"


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return a message as YAML, its fields in their order. The rest is as in ``message_to_ordereddict``."""
    yaml = import_module("yaml")
    values = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    dumper: Any = type("Dumper", (yaml.Dumper,), {})

    def in_order(own: Any, fields: OrderedDict[str, Any]) -> Any:
        items = [(own.represent_data(name), own.represent_data(value)) for name, value in fields.items()]
        return yaml.nodes.MappingNode("tag:yaml.org,2002:map", items)

    dumper.add_representer(OrderedDict, in_order)
    return str(yaml.dump(values, Dumper=dumper, allow_unicode=True, width=_LONGEST, default_flow_style=flow_style))


def message_to_csv(msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False) -> str:
    """Return all values of a message with commas between them. The rest is as in ``message_to_ordereddict``."""
    most = _LONGEST if truncate_length is None else truncate_length

    def shown(value: Any, kind: str = "") -> str:
        if _is_array(value):
            if no_arr and kind:
                return _described(value, kind)
            return ",".join([*map(shown, value[:most]), *(["..."] if len(value) > most else [])])
        if isinstance(value, str):
            if no_str:
                return f"<string length: <{len(value)}>>"
            return value if len(value) <= most else f"{value[:most]}..."
        if isinstance(value, bytes):
            return str(value if len(value) <= most else value[:most] + b"...")
        if isinstance(value, (bool, float, int)) or hasattr(value, "item"):
            return str(value)
        return message_to_csv(value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)

    return ",".join(shown(getattr(msg, name), kind) for name, kind in msg.get_fields_and_field_types().items())


def set_message_fields(
    msg: Any, values: Mapping[str, Any], expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[Any]:
    """Set fields of a message, and of messages in it, from a dictionary.

    With ``expand_header_auto`` a header may be "auto", with ``expand_time_now`` a time "now": what sets these is
    returned. Raises AttributeError for an unknown field, TypeError for what is no dictionary.
    """
    if not hasattr(values, "items"):
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}")
    setters: list[Any] = []
    fill = partial(set_message_fields, expand_header_auto=expand_header_auto, expand_time_now=expand_time_now)
    kinds = msg.get_fields_and_field_types()
    for name, given in values.items():
        field = getattr(msg, name)
        type_, kind = type(field), kinds[name]
        value: Any
        if type_ is array.array:
            value = array.array(field.typecode, given)
        elif hasattr(field, "dtype"):
            value = import_module("numpy").array(given, dtype=field.dtype)
        elif type(given) is type_:
            value = given
        elif kind == "std_msgs/Header" and given == "auto" and expand_header_auto:
            setters.append(partial(setattr, field, "stamp"))
            continue
        elif kind == "builtin_interfaces/Time" and given == "now" and expand_time_now:
            setters.append(partial(setattr, msg, name))
            continue
        else:
            try:
                value = type_(given)
            except TypeError:
                value = type_()
                setters += fill(value, given)
        match = _ARRAY.fullmatch(kind)
        if match and "/" in match[1]:
            element = get_message(match[1])
            for number, each in enumerate(value):
                value[number] = element()
                setters += fill(value[number], each)
        setattr(msg, name, value)
    return setters


def get_interface(identifier: str) -> Any:
    """Return the class of a full name, as in std_msgs/msg/String."""
    *home, name = identifier.split("/")
    return getattr(import_module(".".join(home)), name)


def _get(identifier: str, folder: str, what: str) -> Any:
    *home, name = identifier.split("/")
    found = get_interface("/".join([*home, folder, name] if len(home) == 1 else [*home, name]))
    if not {"msg": is_message, "srv": is_service, "action": is_action}[folder](found):
        raise ValueError(f"Expected the full name of {what}, got '{identifier}'")
    return found


def get_message(identifier: str) -> Any:
    """Return the class of a message, as in std_msgs/msg/String or std_msgs/String. Raises ValueError for others."""
    return _get(identifier, "msg", "a message")


def get_service(identifier: str) -> Any:
    """Return the class of a service. Raises ValueError for others."""
    return _get(identifier, "srv", "a service")


def get_action(identifier: str) -> Any:
    """Return the class of an action. Raises ValueError for others."""
    return _get(identifier, "action", "an action")


def is_message(interface: Any) -> bool:
    """Whether a class is a message's."""
    return hasattr(interface, "get_fields_and_field_types")


def is_service(interface: Any) -> bool:
    """Whether a class is a service's."""
    return hasattr(interface, "Request") and hasattr(interface, "Response")


def is_action(interface: Any) -> bool:
    """Whether a class is an action's."""
    return all(hasattr(interface, part) for part in ("Goal", "Result", "Feedback"))


__getattr__ = refusing(
    "rosidl_runtime_py",
    {
        *("get_action_interfaces", "get_interface_packages", "get_interface_path", "get_interfaces"),
        *("get_message_interfaces", "get_message_slot_types", "get_service_interfaces"),
        "import_message_from_namespaced_type",
    },
)

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(
    ("rosidl_runtime_py", *(f"rosidl_runtime_py.{name}" for name in ("convert", "set_message", "utilities"))),
    sys.modules[__name__],
)
convert = set_message = utilities = sys.modules[__name__]
