"""The headers that a C++ node is compiled with: the stand-ins', and those made from message definitions."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from ..messages.definitions import BUILTIN, Constant, Definition, Kind
from ..messages.library import Library
from .macros import ros1_macros

__all__ = ["included", "messages", "stand_ins"]

_FOLDER = Path(__file__).with_name("include")

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)

_MADE = {"ros/console_macros.h": ros1_macros}

# Of C++, by the types of fields. A bool is a number in roscpp, too.
_TYPES = {
    "bool": "std::uint8_t",
    "byte": "std::int8_t",
    "char": "std::uint8_t",
    "float32": "float",
    "float64": "double",
    "string": "std::string",
    "time": "ros::Time",
    "duration": "ros::Duration",
    **{f"{sign}int{bits}": f"std::{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}


@cache
def stand_ins() -> Mapping[str, str]:
    """Return the headers of the stand-ins, by the names under which nodes include them."""
    files = {path.relative_to(_FOLDER).as_posix(): path.read_text(encoding="utf-8") for path in _FOLDER.rglob("*.h*")}
    return files | {name: make() for name, make in _MADE.items()}


def included(source: str) -> list[str]:
    """List the headers that a text includes."""
    return _INCLUDE.findall(source)


def messages(names: list[str], library: Library) -> dict[str, str]:
    """Make the headers of messages among these names, and those that they include, from a library's definitions.

    Raises DefinitionError for a faulty definition.
    """
    made: dict[str, str] = {}
    left = list(names)
    while left:
        name = left.pop()
        match = re.fullmatch(r"(\w+)/(\w+)\.h", name)
        if name in made or not match or match[2] not in library.names(match[1]):
            continue
        definition = library.definition(f"{match[1]}/{match[2]}")
        made[name] = _header(definition)
        left += _nested(definition)
    return made


def _nested(definition: Definition) -> list[str]:
    """List the headers of the messages in a message."""
    bases = [field.kind.base for field in definition.fields if field.kind.base not in BUILTIN[1]]
    return [f"{base}.h" for base in dict.fromkeys(bases)]


def _header(definition: Definition) -> str:
    package, _, name = definition.name.partition("/")
    guard = f"ROSSPIN_MESSAGE_{package}_{name}".upper()
    lines = [
        f"// Made from the definition of {definition.name}.",
        f"#ifndef {guard}",
        f"#define {guard}",
        *(f'#include "{file}"' for file in ["ros/message.h", *_nested(definition)]),
        f"namespace {package}",
        "{",
        f"struct {name}",
        "{",
        f'  static constexpr const char* rosspin_type = "{definition.name}";',
        f"  typedef boost::shared_ptr<{name}> Ptr;",
        f"  typedef boost::shared_ptr<{name} const> ConstPtr;",
        *(f"  {_constant(constant)}" for constant in definition.constants),
        *(f"  {_type(field.kind)} {field.name}{{}};" for field in definition.fields),
        "  template<class Self, class Visitor>",
        "  static void visit(Self& self, Visitor& visitor)",
        "  {",
        *(f'    visitor("{field.name}", self.{field.name});' for field in definition.fields),
        "  }",
        "};",
        f"ROSSPIN_MESSAGE({name})",
        "}",
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _constant(constant: Constant) -> str:
    if isinstance(constant.value, str):
        return f"static inline const std::string {constant.name} = {_quoted(constant.value)};"
    value = str(constant.value).lower() if isinstance(constant.value, bool) else repr(constant.value)
    return f"static constexpr {_TYPES[constant.type]} {constant.name} = static_cast<{_TYPES[constant.type]}>({value});"


def _quoted(text: str) -> str:
    plain = (chr(byte) if 32 <= byte < 127 and chr(byte) not in '"\\' else f"\\{byte:03o}" for byte in text.encode())
    return f'"{"".join(plain)}"'


def _type(kind: Kind) -> str:
    """Return the type in C++."""
    if kind.array:
        element = _type(kind.element)
        return f"std::vector<{element}>" if kind.length is None else f"std::array<{element}, {kind.length}>"
    return _TYPES.get(kind.base) or kind.base.replace("/", "::")
