"""What the packages around a launch file can run: scripts, and what they build."""

from __future__ import annotations

import ast
import os
import re
from contextlib import suppress
from pathlib import Path
from typing import Any

from .source import Code, load, load_entry_point

__all__ = ["find_cpp", "find_node", "find_python", "is_cpp"]


def find_python(package: Path, name: str) -> Path | None:
    """Find a Python file of that name, anywhere in a package."""
    for place, folders, files in os.walk(package):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        if name in files and _is_python(Path(place, name)):
            return Path(place, name)
    return None


def _is_python(file: Path) -> bool:
    if file.suffix == ".py":
        return True
    with file.open("rb") as opened:
        return bool(re.match(rb"#!.*python", opened.readline()))


def is_cpp(package: Path, name: str) -> bool:
    """Whether a package builds, or seems to build, a program of that name."""
    cmake = package / "CMakeLists.txt"
    text = cmake.read_text(encoding="utf-8", errors="replace") if cmake.is_file() else ""
    is_built = re.search(rf"add_executable\s*\(\s*{re.escape(name)}\s", text)
    return bool(is_built) or any(path.suffix in (".cpp", ".cc", ".cxx", ".c") for path in package.rglob(f"{name}.*"))


def find_cpp(package: Path, name: str) -> Path | None:
    """Find the source in C++ of a program that a package builds, or seems to build."""
    from ..programs.cmake import program  # most packages go without

    return program(package, name)


def find_node(package: Path, name: str) -> Code | None:
    """Find what a package of ROS 2 installs under a name: an entry point or a script; None if nothing in Python.

    Raises OSError and SyntaxError.
    """
    if entry := _entry_points(package).get(name):
        for root in (package, package / "src"):
            with suppress(FileNotFoundError):
                return load_entry_point(entry, str(root))
    script = find_python(package, name)
    if script is None and not (package / "setup.py").is_file():  # CMake may install a script without its ending
        script = find_python(package, f"{name}.py")
    return load(script) if script else None


def _entry_points(package: Path) -> dict[str, str]:
    """Return the ``console_scripts`` of a package, as ``module:function`` by their names."""
    found: list[str] = []
    if (file := package / "setup.cfg").is_file():
        from configparser import ConfigParser  # only needed where there is such a file

        config = ConfigParser(interpolation=None)
        config.read(file, encoding="utf-8")
        found += config.get("options.entry_points", "console_scripts", fallback="").splitlines()
    if (file := package / "setup.py").is_file():
        known: dict[str, Any] = {"__builtins__": {}}
        for node in ast.walk(ast.parse(file.read_bytes())):
            with suppress(Exception):  # what is not written out there cannot be known
                if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                    known[node.targets[0].id] = eval(compile(ast.Expression(node.value), str(file), "eval"), known)
                elif isinstance(node, ast.keyword) and node.arg == "entry_points":
                    value = eval(compile(ast.Expression(node.value), str(file), "eval"), known)
                    scripts = value["console_scripts"]
                    found += scripts.splitlines() if isinstance(scripts, str) else scripts
    return {name.strip(): value.strip() for name, equals, value in (each.partition("=") for each in found) if equals}
