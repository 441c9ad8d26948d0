"""What an answer reaches for that no exercise needs.

An answer runs in the same Python as the check. One that somebody else judges could change what is said of it; this
finds those that look like it, so that they are read and not judged. It reads the text alone, and stops no one who is
determined: Python has too many ways.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

__all__ = ["reaches_for"]

# What answers may import, beside messages: ROS, and what nodes commonly use of the standard library.
_MODULES = {
    *("rospy", "rclpy", "__future__", "argparse", "array", "atexit", "bisect", "collections", "contextlib", "copy"),
    *("dataclasses", "datetime", "decimal", "enum", "fractions", "functools", "heapq", "itertools", "json", "logging"),
    *("math", "os", "queue", "random", "re", "signal", "statistics", "string", "sys", "textwrap", "threading", "time"),
    *("traceback", "typing"),
}

# Names by which code gets at what is not its own: calls that take names or code as texts, and what Python is made of.
_NAMES = {
    *("breakpoint", "compile", "delattr", "eval", "exec", "getattr", "globals", "locals", "open", "setattr", "vars"),
    *("meta_path", "modules", "path_hooks", "setprofile", "settrace", "tb_frame", "f_back", "gi_frame", "cr_frame"),
}

# Of the names that begin with an underscore, those that any node may have.
_COMMON = {"_", "__name__", "__file__", "__doc__", "__init__"}


def reaches_for(answer: str) -> str:
    """The first name in an answer, a text, that no exercise needs; empty if there is none, or if it is not Python."""
    try:
        tree = ast.parse(answer)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    return next((name for node in ast.walk(tree) for name in _foreign(node)), "")


def _foreign(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names if not _may_import(alias.name))
    elif isinstance(node, ast.ImportFrom):
        if not _may_import(node.module or ""):
            yield node.module or "."
        yield from (alias.name for alias in node.names if _is_hidden(alias.name) or alias.name in _NAMES)
    elif isinstance(node, ast.Attribute):
        of_self = isinstance(node.value, ast.Name) and node.value.id in ("self", "cls")
        if node.attr in _NAMES or (_is_hidden(node.attr) and (not of_self or node.attr.startswith("__"))):
            yield node.attr
    elif isinstance(node, ast.Name):
        if node.id in _NAMES or (node.id.startswith("__") and _is_hidden(node.id)):
            yield node.id
    elif isinstance(node, ast.MatchClass):
        yield from (name for name in node.kwd_attrs if _is_hidden(name) or name in _NAMES)


def _may_import(module: str) -> bool:
    package, *inner = module.split(".")
    return (package in _MODULES or package.endswith(("_msgs", "_interfaces"))) and not any(map(_is_hidden, inner))


def _is_hidden(name: str) -> bool:
    return name.startswith("_") and name not in _COMMON
