"""YAML from strangers: as PyYAML reads it, but what would take hours of it ends in an error."""

from __future__ import annotations

from typing import IO, Any

__all__ = ["compose", "load"]

# Of so many values may aliases repeat what is in a text; some lines of them could stand for more than a machine holds.
_MOST = 100_000


def load(text: str | IO[str]) -> Any:
    """Return what ``yaml.safe_load`` does. Raises yaml.YAMLError, and ValueError for a value that is none."""
    from yaml.constructor import SafeConstructor

    node = compose(text)
    return None if node is None else SafeConstructor().construct_document(node)


def compose(text: str | IO[str]) -> Any:
    """Return the root node. Raises yaml.YAMLError for what is no YAML, nested too deeply, or a bomb of aliases."""
    import yaml  # slow to import, and many runs read none

    try:
        root = yaml.compose(text, yaml.SafeLoader)
        sizes = dict[int, int]()
        if root is not None and _size(root, sizes) - len(sizes) > _MOST:
            raise yaml.YAMLError(f"its aliases repeat more than {_MOST:,} values")
    except RecursionError:
        raise yaml.YAMLError("it is nested too deeply") from None
    return root


def _size(node: Any, sizes: dict[int, int]) -> int:
    """Return how many values a node stands for. One that holds itself counts once: others refuse it."""
    if id(node) not in sizes:
        sizes[id(node)] = 1
        parts = node.value if isinstance(node.value, list) else []
        pairs = [part if isinstance(part, tuple) else (part,) for part in parts]
        sizes[id(node)] = 1 + sum(_size(part, sizes) for pair in pairs for part in pair)
    return sizes[id(node)]
