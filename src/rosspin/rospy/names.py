"""The node's own name, and names as it sees them (source: rospy/names.py)."""

from __future__ import annotations

from typing import Any

from . import rosgraph
from .exceptions import ROSException
from .rosgraph import (
    ANYTYPE,
    GLOBALNS,
    REMAP,
    SEP,
    canonicalize_name,
    get_ros_namespace,
    is_global,
    is_private,
    isstring,
    load_mappings,
    make_global_ns,
    namespace,
    ns_join,
)
from .state import state
from .validators import ParameterInvalid, Validator

__all__ = ["get_caller_id", "get_name", "get_namespace", "remap_name", "resolve_name"]

TOPIC_ANYTYPE = SERVICE_ANYTYPE = ANYTYPE


def get_namespace() -> str:
    """Return the node's namespace; it ends in ``/``."""
    return state().namespace


def get_name() -> str:
    """Return the node's full name; ``/unnamed`` before ``init_node``."""
    return state().name


get_caller_id = get_name


def _set_caller_id(caller_id: str) -> None:
    """Give the node a full name, and with it a namespace."""
    node = state()
    node.name, node.namespace = caller_id, namespace(caller_id)
    node.world.name = caller_id
    node.world.nodes.append(caller_id)


# --- names in full ----------------------------------------------------------------------------------------------------


def resolve_name(name: Any, caller_id: str | None = None) -> str:
    """Return the full name that a name has in this node (or in ``caller_id``), remapped as the command line says."""
    own = state()
    node = caller_id or own.name
    if not name:
        return namespace(node)
    resolved = canonicalize_name(str(name))
    if is_private(resolved):
        # Joined as in rospy: "~/rate" is "/rate".
        resolved = ns_join(node, resolved[1:])
    elif not is_global(resolved):
        resolved = namespace(node) + resolved
    return own.resolved_mappings.get(resolved, resolved)


def resolve_name_without_node_name(name: str) -> str:
    """Resolve and remap a name while the node has no name yet. Raises ValueError for a private one."""
    if is_private(name):
        raise ValueError("~name topics cannot be created before init_node() has been called")
    node = ns_join(get_namespace(), "node")
    resolved = rosgraph.resolve_name(name, node)
    for source, target in state().mappings.items():
        if rosgraph.resolve_name(source, node) == resolved:
            return rosgraph.resolve_name(target, node)
    return resolved


def remap_name(name: str, caller_id: str | None = None, resolved: bool = True) -> str:
    """Return the full name to which the command line remaps a name, or the name itself."""
    node = state()
    return rosgraph.resolve_name(node.mappings[name], caller_id or node.name) if name in node.mappings else name


def scoped_name(caller_id: str, name: str) -> str:
    """Cut the namespace of ``caller_id`` off a name within it. Raises ROSException if ``caller_id`` is not global."""
    if not is_global(caller_id):
        raise ROSException("caller_id must be global")
    return canonicalize_name(name)[len(namespace(caller_id)) :]


# --- remappings -------------------------------------------------------------------------------------------------------


def get_mappings() -> dict[str, str]:
    """Return the remappings of the command line, as they are written there."""
    return state().mappings


def get_resolved_mappings() -> dict[str, str]:
    """Return the remappings of the command line as full names; there are none before ``init_node``."""
    return state().resolved_mappings


def reload_mappings(argv: list[str]) -> None:
    """Take the remappings of another command line."""
    state().mappings = load_mappings(argv)


def initialize_mappings(node_name: str) -> None:
    """Resolve the remappings for the node with this full name; ``__name`` and the like stay as they are."""
    node = state()
    node.resolved_mappings = {
        source if source.startswith("__") else rosgraph.resolve_name(source, node_name): target
        if source.startswith("__")
        else rosgraph.resolve_name(target, node_name)
        for source, target in node.mappings.items()
    }


# --- checks of arguments ----------------------------------------------------------------------------------------------


def valid_name_validator_unresolved(param_name: str, param_value: Any, caller_id: str) -> str:
    """Return a name without a colon or a space, which a URI would have. Raises ParameterInvalid for another value."""
    value = _text(param_name, param_value)
    if ":" in value or " " in value:
        raise ParameterInvalid(f"ERROR: parameter [{param_name}] contains illegal chars")
    return value


def valid_name_validator_resolved(param_name: str, param_value: Any, caller_id: str) -> str:
    """Check a name as ``valid_name_validator_unresolved`` does, and return its full name in the node ``caller_id``."""
    return rosgraph.resolve_name(valid_name_validator_unresolved(param_name, param_value, caller_id), caller_id)


def valid_name(param_name: str, resolve: bool = True) -> Validator:
    """Return a check of names: it returns the full name, or the name as it is, or raises ParameterInvalid."""
    check = valid_name_validator_resolved if resolve else valid_name_validator_unresolved

    def validator(param_value: Any, caller_id: str) -> str:
        return check(param_name, param_value, caller_id)

    return validator


def global_name(param_name: str) -> Validator:
    """Return a check of names that begin with ``/``: it returns the name, or raises ParameterInvalid."""

    def validator(param_value: Any, caller_id: str) -> str:
        value = _text(param_name, param_value)
        if not is_global(value):
            raise ParameterInvalid(f"ERROR: parameter [{param_name}] must be a globally referenced name")
        return value

    return validator


def _text(param_name: str, value: Any) -> str:
    if not value or not isstring(value):
        raise ParameterInvalid(f"ERROR: parameter [{param_name}] must be a non-empty string")
    return str(value)
