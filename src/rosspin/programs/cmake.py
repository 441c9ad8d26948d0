"""Which sources a package's ``CMakeLists.txt`` builds together, as far as that is written out there."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

__all__ = ["companions", "program"]

_COMMAND = re.compile(r"(\w+)\s*\(([^()]*)\)")
_SOURCES = (".cpp", ".cc", ".cxx", ".c++")
_MAIN = re.compile(r"\bmain\s*\(")
_COMPONENT = re.compile(r"^\s*RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*([\w:]+)", re.MULTILINE)


@dataclass
class _Target:
    """Something that CMake builds: its sources, and the targets that it is linked with."""

    is_program: bool
    sources: list[Path] = field(default_factory=list)
    links: list[str] = field(default_factory=list)


def program(package: Path, name: str) -> Path | None:
    """Return the file with the ``main``, or the component, of a program of a package; None if there is none."""
    targets, components = _read(package)
    if target := targets.get(name):
        if target.is_program:
            sources = [file for file in target.sources if file.is_file()]
            return next((file for file in sources if _MAIN.search(_text(file))), sources[0] if sources else None)
    if name in components:
        library, plugin = components[name]
        for file in targets[library].sources if library in targets else ():
            if file.is_file() and plugin in _COMPONENT.findall(_text(file)):
                return file
    found = (file for suffix in _SOURCES for file in sorted(package.rglob(f"{name}{suffix}")))
    return next(found, None)


def companions(package: Path, source: Path) -> list[Path]:
    """Return the other sources that are built into the program that a source is part of."""
    targets, _ = _read(package)
    source = source.resolve()
    own = [target for target in targets.values() if source in target.sources]
    own.sort(key=lambda target: not target.is_program)
    if not own:
        return []
    sources = dict.fromkeys(_all(own[0], targets, set()))
    # Components of a library are programs of their own.
    return [file for file in sources if file != source and file.is_file() and not _COMPONENT.search(_text(file))]


def _all(target: _Target, targets: Mapping[str, _Target], visited: set[str]) -> Iterator[Path]:
    yield from target.sources
    for name in target.links:
        if name in targets and name not in visited:
            visited.add(name)
            yield from _all(targets[name], targets, visited)


def _read(package: Path) -> tuple[dict[str, _Target], dict[str, tuple[str, str]]]:
    """Return the targets of a package by their names, and its components by their programs' names."""
    file = package / "CMakeLists.txt"
    text = re.sub(r"#.*", "", _text(file)) if file.is_file() else ""
    variables: dict[str, list[str]] = {}
    targets: dict[str, _Target] = {}
    components: dict[str, tuple[str, str]] = {}
    for command, given in _COMMAND.findall(text):
        words = list(_expanded(given, variables))
        if not words:
            continue
        first, *rest = words
        match command.lower():
            case "project":
                variables["PROJECT_NAME"] = variables["CMAKE_PROJECT_NAME"] = [first]
            case "set":
                variables[first] = rest
            case "file" if first.upper().startswith("GLOB") and rest:
                patterns = [word for word in rest[1:] if not word.isupper()]
                variables[rest[0]] = [str(path) for word in patterns for path in sorted(package.glob(_inside(word)))]
            case "add_executable" | "add_library" | "cs_add_executable" | "cs_add_library":
                sources = [(package / _inside(word)).resolve() for word in rest if word.endswith(_SOURCES)]
                targets[first] = _Target("executable" in command.lower(), sources)
            case "target_sources" | "target_link_libraries" if first in targets:
                targets[first].sources += [
                    (package / _inside(word)).resolve() for word in rest if word.endswith(_SOURCES)
                ]
                targets[first].links += rest
            case "set_target_properties" if "OUTPUT_NAME" in rest and first in targets:
                targets[rest[rest.index("OUTPUT_NAME") + 1]] = targets[first]
            case "rclcpp_components_register_node" if {"PLUGIN", "EXECUTABLE"} <= set(rest):
                plugin, name = (rest[rest.index(word) + 1] for word in ("PLUGIN", "EXECUTABLE"))
                components[name] = first, plugin
    return targets, components


def _expanded(given: str, variables: Mapping[str, Sequence[str]]) -> Iterator[str]:
    with suppress(ValueError):
        for word in shlex.split(given.replace("\n", " ")):
            if whole := re.fullmatch(r"\$\{(\w+)\}", word):
                yield from variables.get(whole[1], [])
            else:
                yield re.sub(r"\$\{(\w+)\}", lambda match: ";".join(variables.get(match[1], [])), word)


def _inside(word: str) -> str:
    """A path in the package, which may begin with a variable for its folder, empty here."""
    return word.lstrip("/") or "."


def _text(file: Path) -> str:
    return file.read_text(encoding="utf-8", errors="surrogateescape")
