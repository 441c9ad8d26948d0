"""Names of the ROS graph: namespaces, remappings from the command line, resolution (source: rosgraph/names.py)."""

from __future__ import annotations

import os
import re
import sys

SEP = "/"
PRIV_NAME = "~"
REMAP = ":="

_REMAPPING = re.compile(r"([~/A-Za-z]|_|__)[\w/]*:=.*")
_NAME = re.compile(r"[~/A-Za-z][\w/]*")
_BASE_NAME = re.compile(r"[A-Za-z]\w*")


def is_legal_remap(arg: str) -> bool:
    """Whether an argument is a remapping, such as ``__ns:=/mrp`` or ``_rate:=10``."""
    return bool(_REMAPPING.fullmatch(arg))


def is_legal_name(name: str) -> bool:
    """Whether a name may stand for something in the graph; the empty one stands for the namespace."""
    return not name or bool(_NAME.fullmatch(name)) and "//" not in name


def is_legal_base_name(name: str) -> bool:
    """Whether a name is a letter followed by letters, digits and underscores."""
    return bool(_BASE_NAME.fullmatch(name))


def is_global(name: str) -> bool:
    """Whether a name begins with ``/``."""
    return name.startswith(SEP)


def is_private(name: str) -> bool:
    """Whether a name begins with ``~``."""
    return name.startswith(PRIV_NAME)


def split_remappings(argv: list[str]) -> list[tuple[str, str]]:
    """The remappings on a command line as pairs. More than one ``:=`` in an argument: ValueError."""
    pairs = []
    for arg in filter(is_legal_remap, argv):
        source, target = (part.strip() for part in arg.split(REMAP))
        if source and target:
            pairs.append((source, target))
    return pairs


def is_parameter(source: str) -> bool:
    """Whether the left side of a remapping sets a private parameter: ``_rate``, but not ``__name``."""
    return len(source) > 1 and source[0] == "_" and source[1] != "_"


def load_mappings(argv: list[str]) -> dict[str, str]:
    """The remappings of names on a command line; an argument that is none is reported on stderr."""
    mappings: dict[str, str] = {}
    for arg in argv:
        try:
            mappings.update(pair for pair in split_remappings([arg]) if not is_parameter(pair[0]))
        except ValueError:
            sys.stderr.write(f"ERROR: Invalid remapping argument '{arg}'\n")
    return mappings


def get_ros_namespace(argv: list[str]) -> str:
    """The namespace set by ``__ns:=`` or ROS_NAMESPACE, beginning and ending in ``/``. Private: ValueError."""
    for arg in argv:
        if arg.startswith("__ns:="):
            return make_global_ns(arg.removeprefix("__ns:="))
    return make_global_ns(os.environ.get("ROS_NAMESPACE", SEP))


def make_global_ns(name: str) -> str:
    """A name as a namespace: beginning and ending in ``/``. Private: ValueError."""
    if is_private(name):
        raise ValueError(f"cannot turn [{name}] into a global name")
    if not is_global(name):
        name = SEP + name
    return name if name.endswith(SEP) else name + SEP


def namespace(name: str) -> str:
    """The namespace that holds a name, ending in ``/``."""
    name = name.removesuffix(SEP)
    return name[: name.rfind(SEP) + 1] or SEP


def canonicalize_name(name: str) -> str:
    """A name without doubled or trailing slashes."""
    if not name or name == SEP:
        return name
    return (SEP if is_global(name) else "") + SEP.join(part for part in name.split(SEP) if part)


def resolve_under(name: str, node: str) -> str:
    """A name in full, for the node of that full name; remappings are not looked at."""
    if not name:
        return namespace(node)
    name = canonicalize_name(name)
    if is_global(name):
        return name
    if is_private(name):
        return canonicalize_name(node + SEP + name[1:])
    return namespace(node) + name


def resolve_mappings(mappings: dict[str, str], node: str) -> dict[str, str]:
    """Remappings with both sides in full; ``__name`` and the like stay as they are."""
    return {
        source if source.startswith("__") else resolve_under(source, node): target
        if source.startswith("__")
        else resolve_under(target, node)
        for source, target in mappings.items()
    }
