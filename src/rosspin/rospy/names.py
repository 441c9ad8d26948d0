"""The node's own name and names as it sees them (source: rospy/names.py)."""

from __future__ import annotations

from typing import Any

from . import rosgraph
from .state import state

__all__ = ["get_caller_id", "get_name", "get_namespace", "remap_name", "resolve_name"]


def get_namespace() -> str:
    """The node's namespace; it ends in ``/``."""
    return state().namespace


def get_name() -> str:
    """The node's full name; ``/unnamed`` before ``init_node``."""
    return state().name


get_caller_id = get_name


def resolve_name(name: Any, caller_id: str | None = None) -> str:
    """A name in full, as seen from the node (or from ``caller_id``), remapped if the command line says so."""
    own = state()
    node = caller_id or own.name
    if not name:
        return rosgraph.namespace(node)
    full = rosgraph.canonicalize_name(str(name))
    if rosgraph.is_private(full):
        # Joined, as rospy does it: "~/rate" is "/rate".
        rest = full[1:]
        resolved = rest if rosgraph.is_global(rest) else node + rosgraph.SEP + rest
    else:
        resolved = rosgraph.resolve_under(full, node)
    return own.resolved_mappings.get(resolved, resolved)


def remap_name(name: str, caller_id: str | None = None, resolved: bool = True) -> str:
    """A name in full if the command line remaps it, else as it is."""
    node = state()
    return rosgraph.resolve_under(node.mappings[name], caller_id or node.name) if name in node.mappings else name
