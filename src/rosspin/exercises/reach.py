"""What an answer reaches for that no exercise needs.

An answer runs in the same Python as the check. One that somebody else judges could change what is said of it; this
finds those that look like it, so that they are read and not judged. It reads the text alone, and stops no one who is
determined: Python has too many ways.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from importlib.util import find_spec

from ..messages.library import Library

__all__ = ["reaches_for"]

# What answers may import, beside messages: ROS, and what nodes commonly use of the standard library.
_MODULES = {
    *("rospy", "rclpy", "std_srvs", "__future__", "argparse", "array", "asyncio", "atexit", "bisect", "collections"),
    *("concurrent", "contextlib", "copy", "dataclasses", "datetime", "decimal", "enum", "fractions", "functools"),
    *("heapq", "itertools", "json", "logging", "math", "operator", "os", "queue", "random", "re", "signal"),
    *("statistics", "string", "sys", "textwrap", "threading", "time", "traceback", "typing"),
}

# What a page's Python has beside them.
_OF_A_PAGE = {"js", "pyodide", "pyodide_js"}

# Names by which code gets at what is not its own: calls that take names or code as texts, files, and frames.
_NAMES = {
    *("breakpoint", "compile", "delattr", "eval", "exec", "getattr", "globals", "locals", "open", "setattr", "vars"),
    *("meta_path", "modules", "path_hooks", "setprofile", "settrace", "get_type_hints", "FileType", "FileHandler"),
    *("tb_frame", "f_back", "f_locals", "f_globals", "f_builtins", "gi_frame", "cr_frame"),
    *("walk_stack", "walk_tb", "exc_info"),
}

# Of the names that begin with two underscores, those that any node may have.
_COMMON = {
    *("__name__", "__qualname__", "__file__", "__doc__", "__version__", "__author__", "__all__", "__slots__"),
    *("__init__", "__enter__", "__exit__", "__call__", "__str__", "__repr__", "__len__", "__iter__", "__next__"),
}

# Names of modules, or others that look suspicious, which a module has for everybody.
_MEANT = {
    *(("collections", "abc"), ("datetime", "time"), ("re", "compile"), ("rclpy", "logging"), ("rclpy", "time")),
}


def reaches_for(answer: str) -> str:
    """The first name in an answer, a text, that no exercise needs; empty if there is none, or if it is not Python."""
    try:
        tree = ast.parse(answer)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    names = _Names(tree)
    return next((name for node in ast.walk(tree) for name in names.foreign(node)), "")


class _Names:
    """The names in an answer: which it imports, with the modules that they are or come from, and which it defines."""

    def __init__(self, tree: ast.AST) -> None:
        self._imported: dict[str, str] = {}
        self._own: set[str] = set()
        self._only_named: set[ast.AST] = set()  # x.__class__ in x.__class__.__name__
        for node in ast.walk(tree):
            match node:
                case ast.Import(names):
                    for name, alias in ((each.name, each.asname) for each in names):
                        self._imported[alias or name.partition(".")[0]] = name if alias else name.partition(".")[0]
                case ast.ImportFrom(module, names):
                    self._imported |= {each.asname or each.name: module or "." for each in names}
                case ast.FunctionDef(name) | ast.AsyncFunctionDef(name) | ast.ClassDef(name) | ast.arg(name):
                    self._own.add(name)
                case ast.Name(name, ast.Store()) | ast.Attribute(_, name, ast.Store()):
                    self._own.add(name)
                case ast.Attribute(value, "__name__" | "__qualname__"):
                    self._only_named.add(value)

    def foreign(self, node: ast.AST) -> Iterator[str]:
        """What of a node no exercise needs."""
        match node:
            case ast.Import(names):
                yield from (each.name for each in names if not _may_import(each.name))
            case ast.ImportFrom(module, names):
                if not _may_import(module or "."):
                    yield module or "."
                yield from (each.name for each in names if _is_foreign_to(module or ".", each.name))
            case ast.Attribute():
                if not self._may_use(node):
                    yield node.attr
            case ast.Name(name):
                if name in self._own and (name == "open" or not name.endswith("__")) and name not in _NAMES - {"open"}:
                    return
                if name in _NAMES or (name.startswith("__") and _is_hidden(name)):
                    yield name
            case ast.MatchClass(kwd_attrs=names):
                yield from (name for name in names if _is_hidden(name) or name in _NAMES)

    def _may_use(self, node: ast.Attribute) -> bool:
        root: ast.expr = node.value
        while isinstance(root, (ast.Attribute, ast.Subscript)):
            root = root.value
        if isinstance(root, ast.Name) and root.id in self._imported:
            is_read = isinstance(node.ctx, ast.Load)
            return is_read and not _is_foreign_to(self._imported[root.id], node.attr)
        if node in self._only_named and node.attr == "__class__":
            return True
        if node.attr in _NAMES:
            return node.attr == "open"  # such as a gripper's
        return not _is_hidden(node.attr) or (not node.attr.endswith("__") and (self._is_own(node)))

    def _is_own(self, node: ast.Attribute) -> bool:
        match node.value:
            case ast.Name("self" | "cls") | ast.Call(ast.Name("super")):
                return True
        return node.attr in self._own


def _may_import(module: str) -> bool:
    package, *inner = module.split(".")
    if any(map(_is_hidden, inner)):
        return False
    return package in _MODULES or any(Library(ros).names(package) for ros in (1, 2)) or not _is_there(package)


def _is_there(package: str) -> bool:
    """Whether there is such a package; one that is missing, such as numpy in a page, is the check's to say."""
    if package in _OF_A_PAGE or package.startswith("_") or not package or package in sys.modules:
        return True
    return find_spec(package) is not None


def _is_foreign_to(module: str, name: str) -> bool:
    """Whether a name of a module, or beneath it, is not for everybody: hidden, or a module that it imports itself."""
    package, *_, last = [*module.split("."), module.rpartition(".")[2]]
    if (package, name) in _MEANT or name == last or name == package:
        return False
    return name in _NAMES or _is_hidden(name) or name in sys.stdlib_module_names


def _is_hidden(name: str) -> bool:
    return name.startswith("_") and name != "_" and name not in _COMMON
