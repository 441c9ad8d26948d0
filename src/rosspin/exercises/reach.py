"""Find what an answer uses and no exercise needs, as a hint for whoever reads it: no verdict depends on it.

Only the text is read, and Python has many ways around that.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Collection, Iterator
from importlib.util import find_spec

from ..messages.library import Library

__all__ = ["reaches_for"]

# What answers may import besides messages: ROS, and what nodes commonly use with it.
_MODULES = {
    *("rospy", "rclpy", "std_srvs", "__future__", "argparse", "array", "asyncio", "atexit", "bisect", "collections"),
    *("concurrent", "contextlib", "copy", "dataclasses", "datetime", "decimal", "enum", "fractions", "functools"),
    *("heapq", "itertools", "json", "logging", "math", "numpy", "operator", "os", "queue", "random", "re", "signal"),
    *("statistics", "string", "sys", "textwrap", "threading", "time", "traceback", "typing"),
}

# Modules that only a page's Python has.
_OF_A_PAGE = {"js", "pyodide", "pyodide_js"}

# Python's functions that take code, or files.
_FUNCTIONS = {"breakpoint", "compile", "eval", "exec", "globals", "open"}

# Names with a leading underscore that any node may have.
_COMMON = {
    *("_", "__name__", "__qualname__", "__file__", "__doc__", "__version__", "__author__", "__all__", "__slots__"),
    *("__init__", "__enter__", "__exit__", "__call__", "__str__", "__repr__", "__len__", "__iter__", "__next__"),
    *("__class__", "__dict__"),
}


def reaches_for(answer: str) -> str:
    """Find the first name in an answer that no exercise needs; empty if there is none, or the text is not Python."""
    try:
        nodes = list(ast.walk(ast.parse(answer)))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    own = {name for node in nodes for name in _defined(node)}
    return next((name for node in nodes for name in _foreign(node, own)), "")


def _defined(node: ast.AST) -> Iterator[str]:
    """Yield the names that the answer itself gives: to functions, classes, parameters, variables and attributes."""
    match node:
        case ast.FunctionDef(name) | ast.AsyncFunctionDef(name) | ast.ClassDef(name) | ast.arg(name):
            yield name
        case ast.Name(name, ast.Store()) | ast.Attribute(_, name, ast.Store()):
            yield name


def _foreign(node: ast.AST, own: Collection[str]) -> Iterator[str]:
    """Yield the names in a part of the answer, ``node``, that no exercise needs; ``own`` are the answer's."""
    match node:
        case ast.Import(names):
            yield from (each.name for each in names if not _may_import(each.name))
        case ast.ImportFrom(module, names):
            yield from (name for name in (module or ".",) if not _may_import(name))
            yield from (each.name for each in names if _is_hidden(each.name))
        case ast.Name(name) if name not in own and (name in _FUNCTIONS or _is_hidden(name)):
            yield name
        case ast.Attribute(ast.Name("self" | "cls") | ast.Call(ast.Name("super"))):
            pass  # it may come from a class of ROS
        case ast.Attribute(_, name) if name not in own and _is_hidden(name):
            yield name


def _may_import(module: str) -> bool:
    package, *inner = module.split(".")
    if any(map(_is_hidden, inner)):
        return False
    return package in _MODULES or any(Library(ros).has(package) for ros in (1, 2)) or not _is_there(package)


def _is_there(package: str) -> bool:
    """Whether there is such a package. The check itself says that one is missing, such as numpy in a page."""
    if package in _OF_A_PAGE or package.startswith("_") or not package or package in sys.modules:
        return True
    return find_spec(package) is not None


def _is_hidden(name: str) -> bool:
    return name == "modules" or (name.startswith("_") and name not in _COMMON)
