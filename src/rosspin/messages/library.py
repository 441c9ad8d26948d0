"""Where definitions are: those that rosspin carries, and the packages around a node's file."""

from __future__ import annotations

import os
import pkgutil
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from .definitions import Definition, parse

__all__ = ["Library"]

CARRIED = {1: "noetic.txt", 2: "jazzy.txt"}
HEADING = re.compile(r"^=+\nMSG: (\w+/\w+)\n", re.MULTILINE)
IGNORED = {"CATKIN_IGNORE", "COLCON_IGNORE", "AMENT_IGNORE"}  # a folder with one of these files is skipped
DEEPEST = 4  # how many folders below src packages are looked for: a node may lie in a big tree by chance


class Library:
    """The definitions that a node can import: those of ROS 1 or 2, and its own packages'.

    ``folder`` is the node file's. As ROS does, a file's package is the nearest folder upwards that has a package.xml;
    its workspace is the folder ``src`` around it, where the other packages are, up to four folders deep and not inside
    of each other. Without a workspace, the packages right beside it count.
    """

    def __init__(self, ros: int, folder: Path | None = None) -> None:
        self.ros = ros
        self._folder = folder
        self._packages: dict[str, Path] | None = None
        self._names: dict[str, list[str]] = {}
        self._definitions: dict[str, Definition] = {}

    def names(self, package: str) -> list[str]:
        """The names of a package's messages, sorted, without the package; none if it is not there."""
        if package not in self._names:
            found = [name.partition("/")[2] for name in _carried(self.ros) if name.startswith(f"{package}/")]
            if not found and (folder := self.package(package)):
                found = sorted(file.stem for file in (folder / "msg").glob("*.msg"))
            self._names[package] = found
        return self._names[package]

    def definition(self, name: str) -> Definition:
        """The definition of a message as in std_msgs/Header. Raises KeyError if unknown, DefinitionError if faulty."""
        if name not in self._definitions:
            package, _, short = name.partition("/")
            if name in _carried(self.ros):
                text, file = _carried(self.ros)[name], CARRIED[self.ros]
            elif short in self.names(package) and (folder := self.package(package)):
                path = folder / "msg" / f"{short}.msg"
                text, file = path.read_text(encoding="utf-8"), str(path)
            else:
                raise KeyError(name)
            self._definitions[name] = parse(text, name, file, self.ros)
        return self._definitions[name]

    def package(self, name: str) -> Path | None:
        """The folder of one of the packages around the node."""
        if self._packages is None:
            self._packages = dict(_packages_around(self._folder)) if self._folder else {}
        return self._packages.get(name)


@cache
def _carried(ros: int) -> dict[str, str]:
    text = pkgutil.get_data(__package__, CARRIED[ros])  # also where rosspin is imported from a zip file
    assert text is not None  # all loaders of files can give it
    _, *parts = HEADING.split(text.decode())
    return dict(zip(parts[::2], parts[1::2], strict=True))


def _packages_around(folder: Path) -> Iterator[tuple[str, Path]]:
    """Names and folders of the packages in a folder's workspace, its own one last."""
    folder = folder.resolve()
    own = next((place for place in (folder, *folder.parents) if (place / "package.xml").is_file()), None)
    if not own:
        return
    workspace = next((place for place in own.parents if place.name == "src"), None)
    top, deepest = (workspace, DEEPEST) if workspace else (own.parent, 1)
    for name, folders, files in os.walk(top):
        place = Path(name)
        if "package.xml" in files and not IGNORED & set(files):
            yield _name(place), place
        if {"package.xml", *IGNORED} & set(files) or len(place.relative_to(top).parts) == deepest:
            folders.clear()
        folders[:] = sorted(name for name in folders if not name.startswith("."))
    yield _name(own), own


def _name(package: Path) -> str:
    """A package's name: what its package.xml says, or else its folder's."""
    text = (package / "package.xml").read_text(encoding="utf-8", errors="replace")
    found = re.search(r"<name>\s*(\w+)\s*</name>", text)
    return found[1] if found else package.name
