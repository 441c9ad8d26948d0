"""Names of the ROS graph: namespaces, remappings from the command line, resolution (source: rosgraph/names.py)."""

from __future__ import annotations

import os
import random
import re
import sys
from collections.abc import Mapping

MSG_EXT, SRV_EXT = ".msg", ".srv"
SEP = GLOBALNS = "/"
PRIV_NAME = "~"
REMAP = ":="
ANYTYPE = "*"  # any type of a topic

_REMAPPING = re.compile(r"([~/A-Za-z]|_|__)[\w/]*:=.*")
_NAME = re.compile(r"[~/A-Za-z][\w/]*")
_BASE_NAME = re.compile(r"[A-Za-z]\w*")


def isstring(s: object) -> bool:
    """Whether a value is a text."""
    return isinstance(s, str)


def is_legal_remap(arg: str | None) -> bool:
    """Whether an argument is a remapping, such as ``__ns:=/mrp`` or ``_rate:=10``."""
    return arg is not None and bool(_REMAPPING.fullmatch(arg))


def is_legal_name(name: str | None) -> bool:
    """Whether a name may stand for something in the graph; the empty one stands for the namespace."""
    return name is not None and (not name or bool(_NAME.fullmatch(name)) and "//" not in name)


def is_legal_base_name(name: str | None) -> bool:
    """Whether a name is a letter followed by letters, digits and underscores."""
    return name is not None and bool(_BASE_NAME.fullmatch(name))


def is_global(name: str | None) -> bool:
    """Whether a name begins with ``/``."""
    return bool(name) and name[0] == SEP  # type: ignore[index]


def is_private(name: str | None) -> bool:
    """Whether a name begins with ``~``."""
    return bool(name) and name[0] == PRIV_NAME  # type: ignore[index]


def split_remappings(argv: list[str]) -> list[tuple[str, str]]:
    """Return the remappings on a command line as pairs. Raises ValueError for an argument with more than one ``:=``."""
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
    """Return the remappings of names on a command line. A faulty one is reported on stderr."""
    mappings: dict[str, str] = {}
    for arg in argv:
        try:
            mappings.update(pair for pair in split_remappings([arg]) if not is_parameter(pair[0]))
        except ValueError:
            sys.stderr.write(f"ERROR: Invalid remapping argument '{arg}'\n")
    return mappings


def get_ros_namespace(env: Mapping[str, str] | None = None, argv: list[str] | None = None) -> str:
    """Return the namespace that ``__ns:=`` or ROS_NAMESPACE sets, between slashes. Raises ValueError if it is private.

    ``env`` stands in for the environment, ``argv`` for the command line.
    """
    for arg in sys.argv if argv is None else argv:
        if arg.startswith("__ns:="):
            return make_global_ns(arg.removeprefix("__ns:="))
    return make_global_ns((os.environ if env is None else env).get("ROS_NAMESPACE", GLOBALNS))


def make_global_ns(name: str) -> str:
    """Make a name a namespace, which begins and ends with ``/``. Raises ValueError for a private name."""
    if is_private(name):
        raise ValueError(f"cannot turn [{name}] into a global name")
    if not is_global(name):
        name = SEP + name
    return name if name.endswith(SEP) else name + SEP


def ns_join(ns: str, name: str) -> str:
    """Put a name below a namespace. A global or private name stays as it is."""
    if is_private(name) or is_global(name) or not ns:
        return name
    return ns + name if ns == PRIV_NAME or ns.endswith(SEP) else ns + SEP + name


def namespace(name: str) -> str:
    """Return the namespace of a name, ending in ``/``. Raises ValueError for None, TypeError for what is no text."""
    if name is None:
        raise ValueError("name")
    if not isstring(name):
        raise TypeError("name")
    name = name.removesuffix(SEP)
    return name[: name.rfind(SEP) + 1] or SEP


def canonicalize_name(name: str) -> str:
    """Remove doubled and trailing slashes from a name."""
    if not name or name == SEP:
        return name
    return (SEP if is_global(name) else "") + SEP.join(part for part in name.split(SEP) if part)


def resolve_name(name: str, namespace_: str, remappings: Mapping[str, str] | None = None) -> str:
    """Return the full name that a name has in the node ``namespace_``, or what ``remappings`` make of that."""
    if not name:
        return namespace(namespace_)
    name = canonicalize_name(name)
    if is_private(name):
        name = canonicalize_name(namespace_ + SEP + name[1:])
    elif not is_global(name):
        name = namespace(namespace_) + name
    return (remappings or {}).get(name, name)


def make_caller_id(name: str) -> str:
    """Return the full name of a node, with a slash at its end."""
    return make_global_ns(ns_join(get_ros_namespace(), name))


def script_resolve_name(script_name: str, name: str) -> str:
    """Return the full name that a name has in a script, without remapping."""
    if not name:
        return get_ros_namespace()
    if is_private(name):
        return ns_join(make_caller_id(script_name), name[1:])
    return name if is_global(name) else get_ros_namespace() + name


def anonymous_name(id: str) -> str:
    """Make a name unique."""
    return f"{id}_rosspin_{os.getpid()}_{random.randint(0, sys.maxsize)}"
