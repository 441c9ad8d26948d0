"""The headers that a C++ node is compiled with: the stand-ins', and those made from message definitions."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

from ..messages.definitions import BUILTIN, Constant, Definition, Kind, Value
from ..messages.library import Library
from ..messages.library import carried as carried_definitions
from ..messages.ros2 import Messages
from .macros import ros1_macros, ros2_macros

__all__ = ["carried", "included", "messages", "stand_ins"]

_FOLDER = Path(__file__).with_name("include")

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)

# A header of ROS 2 that editors like to include: a part of a message's own.
_PART = re.compile(r"(\w+/(?:msg|srv)/)detail/(\w+?)__(?:struct|traits|builder|type_support)\.hpp")

# The headers of message_filters, which are one.
_FILTERS = (
    *("cache", "chain", "connection", "pass_through", "simple_filter", "subscriber", "synchronizer"),
    *("time_sequencer", "time_synchronizer"),
    *("sync_policies/approximate_time", "sync_policies/exact_time"),
)

# The folders of the stand-in for each ROS, and what is made for it.
_FOLDERS = {
    1: ("rosspin", "__chrono", "bits", "boost", "ros"),
    2: ("rosspin", "__chrono", "bits", "rcl", "rclcpp", "rclcpp_components", "rcutils", "rmw"),
}
_MADE = {1: ("ros/console_macros.h", ros1_macros), 2: ("rclcpp/logging_macros.hpp", ros2_macros)}

# The messages and services of ROS 2 that rclcpp itself uses.
_OF_RCLCPP = [
    *(f"builtin_interfaces/msg/{name}.hpp" for name in ("duration", "time")),
    *(
        f"rcl_interfaces/msg/{name}.hpp"
        for name in (
            *("list_parameters_result", "parameter", "parameter_descriptor", "parameter_event", "parameter_type"),
            *("parameter_value", "set_parameters_result"),
        )
    ),
    *(
        f"rcl_interfaces/srv/{name}.hpp"
        for name in (
            *("describe_parameters", "get_parameter_types", "get_parameters", "list_parameters", "set_parameters"),
            "set_parameters_atomically",
        )
    ),
    "rosgraph_msgs/msg/clock.hpp",
]

# Of C++, by the types of fields. A bool is a number in roscpp, too.
_NUMBERS = {
    "float32": "float",
    "float64": "double",
    "string": "std::string",
    **{f"{sign}int{bits}": f"std::{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}
_TYPES = {
    1: {
        **_NUMBERS,
        "bool": "std::uint8_t",
        "byte": "std::int8_t",
        "char": "std::uint8_t",
        "time": "ros::Time",
        "duration": "ros::Duration",
    },
    2: {**_NUMBERS, "bool": "bool", "byte": "std::uint8_t", "char": "std::uint8_t", "wstring": "std::u16string"},
}


@cache
def stand_ins(ros: int) -> Mapping[str, str]:
    """Return the headers of the stand-in for a ROS, by the names under which nodes include them."""
    paths = [path for folder in _FOLDERS[ros] for path in (_FOLDER / folder).rglob("*.h*")]
    files = {path.relative_to(_FOLDER).as_posix(): path.read_text(encoding="utf-8") for path in paths}
    name, make = _MADE[ros]
    made = {} if ros == 1 else _made(_OF_RCLCPP, Library(2), {})
    filters = dict.fromkeys(_FILTERS, "rosspin/filters.hpp")
    if ros == 2:
        filters["sync_policies/latest_time"] = "rclcpp/latest_time.hpp"
    kinds = ("h",) if ros == 1 else ("h", "hpp")
    told = {f"message_filters/{each}.{kind}": f'#include "{at}"\n' for each, at in filters.items() for kind in kinds}
    return {**files, name: make(), **made, **told}


def included(source: str) -> list[str]:
    """List the headers that a text includes."""
    return _INCLUDE.findall(source)


def messages(names: Sequence[str], library: Library) -> dict[str, str]:
    """Make the headers of messages and services among these names, and those that they include, from a library.

    Raises DefinitionError for a faulty definition.
    """
    return _made(names, library, stand_ins(library.ros))


def carried(ros: int) -> dict[str, str]:
    """Make the headers of all messages and services that rosspin carries."""
    names = []
    for folder, whole in carried_definitions(ros):
        package, _, name = whole.partition("/")
        names.append(f"{package}/{folder}/{_file(name)}.hpp" if ros == 2 else f"{package}/{name}.h")
    return messages(names, Library(ros))


def _made(names: Sequence[str], library: Library, known: Mapping[str, str]) -> dict[str, str]:
    made: dict[str, str] = {}
    left = list(names)
    while left:
        name = left.pop()
        if name in made or name in known:
            continue
        if ros2_part := _PART.fullmatch(name):
            whole = f"{ros2_part[1]}{ros2_part[2]}.hpp"
            made[name] = f'#include "{whole}"\n'
            left.append(whole)
            continue
        definitions = _definitions(name, library)
        if definitions:
            nested = list(
                dict.fromkeys(each for definition in definitions for each in _nested(definition, library.ros))
            )
            made[name] = _header(name, definitions, nested, library.ros)
            left += nested
    return made


def _definitions(header: str, library: Library) -> list[Definition]:
    """Return what a header defines, a message or the parts of a service; nothing if it is of no message."""
    if library.ros == 1:
        match = re.fullmatch(r"(\w+)/(\w+)\.h", header)
        if not match or match[2] not in library.names(match[1]) + library.names(match[1], "srv"):
            return []
        parts = ("",) if match[2] in library.names(match[1]) else ("Request", "Response")
        return [library.definition(f"{match[1]}/{match[2]}{part}") for part in parts]
    match = re.fullmatch(r"(\w+)/(msg|srv)/(\w+)\.hpp", header)
    if not match:
        return []
    package, folder, file = match.groups()
    short = next((name for name in library.names(package, folder) if _file(name) == file), "")
    suffixes = ("",) if folder == "msg" else ("_Request", "_Response")
    return [library.definition(f"{package}/{short}{suffix}") for suffix in suffixes] if short else []


def _file(name: str) -> str:
    """The name of the header of a message in ROS 2, as in u_int32."""
    return Messages.module(name).removeprefix("_")


def _nested(definition: Definition, ros: int) -> list[str]:
    """List the headers of the messages in a message."""
    bases = [field.kind.base for field in definition.fields if field.kind.base not in BUILTIN[ros]]
    if ros == 1:
        return [f"{base}.h" for base in bases]
    return [f"{package}/msg/{_file(name)}.hpp" for package, _, name in (base.partition("/") for base in bases)]


def _header(file: str, definitions: Sequence[Definition], nested: Sequence[str], ros: int) -> str:
    package = definitions[0].name.partition("/")[0]
    guard = re.sub(r"\W", "_", f"rosspin_message_{file}").upper()
    folder = file.split("/")[1]
    lines = [
        f"// Made from the definition of {definitions[0].name.removesuffix('Request').removesuffix('_')}.",
        f"#ifndef {guard}",
        f"#define {guard}",
        *(f'#include "{name}"' for name in ["ros/message.h" if ros == 1 else "rclcpp/message.hpp", *nested]),
        f"namespace {package}" if ros == 1 else f"namespace {package}::{folder}",
        "{",
        *(line for definition in definitions for line in _struct(definition, folder, ros)),
        *(_service(definitions[0], ros) if len(definitions) > 1 else ()),
        "}",
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _struct(definition: Definition, folder: str, ros: int) -> Iterator[str]:
    package, _, name = definition.name.partition("/")
    kind = definition.name if ros == 1 else f"{package}/{folder}/{name}"
    yield from (f"struct {name}", "{", f'  static constexpr const char* rosspin_type = "{kind}";')
    if ros == 1:
        yield f"  typedef boost::shared_ptr<{name}> Ptr;"
        yield f"  typedef boost::shared_ptr<{name} const> ConstPtr;"
    else:
        yield f"  static constexpr bool rosspin_is_empty = {'false' if definition.fields else 'true'};"
        yield f"  ROSSPIN_MESSAGE_TYPES({name})"
    yield from (f"  {_constant(constant, ros)}" for constant in definition.constants)
    for field in definition.fields:
        type_ = _type(field.kind, ros)
        yield f"  {type_} {field.name}{{{_default(field.default)}}};"
        if ros == 2:
            yield f"  {name}& set__{field.name}(const {type_}& rosspin) {{ {field.name} = rosspin; return *this; }}"
    yield from ("  template<class Self, class Visitor>", "  static void visit(Self& self, Visitor& visitor)", "  {")
    yield from (f'    visitor("{field.name}", self.{field.name});' for field in definition.fields)
    yield from ("  }", "};", f"ROSSPIN_MESSAGE({name})")


def _service(request: Definition, ros: int) -> Iterator[str]:
    package, _, name = request.name.removesuffix("Request").removesuffix("_").partition("/")
    if ros == 1:
        yield from (f"struct {name}", "{", f"  typedef {name}Request Request;", f"  typedef {name}Response Response;")
        yield from ("  Request request;", "  Response response;", "};")
        return
    yield from (f"struct {name}", "{", f'  static constexpr const char* rosspin_type = "{package}/srv/{name}";')
    yield from (f"  using Request = {name}_Request;", f"  using Response = {name}_Response;", "};")


def _constant(constant: Constant, ros: int) -> str:
    type_ = _TYPES[ros][constant.type]
    if isinstance(constant.value, str):
        return f"static inline const {type_} {constant.name} = {_literal(constant.value)};"
    return f"static constexpr {type_} {constant.name} = static_cast<{type_}>({_literal(constant.value)});"


def _default(value: Value | list[Value] | None) -> str:
    if value is None:
        return ""
    return ", ".join(map(_literal, value)) if isinstance(value, list) else _literal(value)


def _literal(value: Value) -> str:
    if isinstance(value, str):
        plain = (
            chr(byte) if 32 <= byte < 127 and chr(byte) not in '"\\' else f"\\{byte:03o}" for byte in value.encode()
        )
        return f'"{"".join(plain)}"'
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value!r}ull" if value == 2**63 or isinstance(value, int) and value > 2**63 else repr(value)


def _type(kind: Kind, ros: int) -> str:
    """Return the type in C++."""
    if kind.array:
        element = _type(kind.element, ros)
        return f"std::vector<{element}>" if kind.length is None else f"std::array<{element}, {kind.length}>"
    return _TYPES[ros].get(kind.base) or kind.base.replace("/", "::" if ros == 1 else "::msg::")
