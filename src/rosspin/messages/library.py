"""Where definitions are: those that rosspin carries, and the packages around a node's file."""

from __future__ import annotations

import os
import pkgutil
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

from .definitions import Definition, parse, split

__all__ = ["FOLDERS", "Library"]

CARRIED = {1: ("noetic.txt", "noetic-services.txt"), 2: ("jazzy.txt", "jazzy-services.txt")}
HEADING = re.compile(r"^=+\n(MSG|SRV|ACTION): (\w+/\w+)\n", re.MULTILINE)
FOLDERS = ("msg", "srv", "action")  # of a package; each with one kind of definition

# What a class of a part adds to the name of its service or action. In ROS 1 an action has messages that genaction.py
# writes, and no parts.
PARTS: dict[int, dict[str, tuple[str, ...]]] = {
    1: {"srv": ("Request", "Response")},
    2: {"srv": ("_Request", "_Response"), "action": ("_Goal", "_Result", "_Feedback")},
}
# The messages that rosidl makes around these parts ({} is the name of the service or action).
AROUND: dict[int, dict[str, dict[str, str]]] = {
    1: {},
    2: {
        "srv": {
            "_Event": "service_msgs/ServiceEventInfo info\n{}_Request[<=1] request\n{}_Response[<=1] response\n",
        },
        "action": {
            "_SendGoal_Request": "unique_identifier_msgs/UUID goal_id\n{}_Goal goal\n",
            "_SendGoal_Response": "bool accepted\nbuiltin_interfaces/Time stamp\n",
            "_GetResult_Request": "unique_identifier_msgs/UUID goal_id\n",
            "_GetResult_Response": "int8 status\n{}_Result result\n",
            "_FeedbackMessage": "unique_identifier_msgs/UUID goal_id\n{}_Feedback feedback\n",
        },
    },
}
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
        self._names: dict[tuple[str, str], list[str]] = {}
        self._definitions: dict[str, Definition] = {}

    def names(self, package: str, folder: str = "msg") -> list[str]:
        """The names of a package's messages, sorted, without the package; none if it is not there.

        Those of its services are in the ``folder`` srv, those of its actions in action.
        """
        key = (package, folder)
        if key not in self._names:
            carried = _carried(self.ros)
            if package in carried.packages:
                found = [name for kind, name in carried.texts if kind == folder and name.startswith(f"{package}/")]
                self._names[key] = [name.partition("/")[2] for name in found]
            elif place := self.package(package):
                self._names[key] = sorted(file.stem for file in (place / folder).glob(f"*.{folder}"))
            else:
                self._names[key] = []
        return self._names[key]

    def has(self, package: str) -> bool:
        """Whether a package has a message, a service or an action."""
        return any(self.names(package, folder) for folder in FOLDERS)

    def suffixes(self, folder: str) -> list[str]:
        """What the classes of a service, or of an action, add to its name: in ROS 2 _Request, _Response and _Event."""
        return [*PARTS[self.ros].get(folder, ()), *AROUND[self.ros].get(folder, ())]

    def definition(self, name: str) -> Definition:
        """The definition of a message, as in std_msgs/Header, or of a part, as in std_srvs/SetBool_Request.

        Raises KeyError if unknown, DefinitionError if faulty.
        """
        if name not in self._definitions:
            package, _, short = name.partition("/")
            if short in self.names(package):
                self._definitions[name] = parse(*self._text("msg", name), self.ros)
            else:
                self._add_parts(package, short)
        return self._definitions[name]

    def _text(self, folder: str, name: str) -> tuple[str, str, str]:
        """Return the text of a definition, its name, and its file."""
        carried = _carried(self.ros).texts.get((folder, name))
        if carried:
            return carried[0], name, carried[1]
        package, _, short = name.partition("/")
        place = self.package(package)
        assert place
        path = place / folder / f"{short}.{folder}"
        return path.read_text(encoding="utf-8"), name, str(path)

    def _add_parts(self, package: str, short: str) -> None:
        """Read the service or action of which ``short`` names a part."""
        for folder, suffixes in PARTS[self.ros].items():
            around = AROUND[self.ros].get(folder, {})
            for suffix in (*suffixes, *around):
                whole = short.removesuffix(suffix)
                if whole == short or whole not in self.names(package, folder):
                    continue
                name = f"{package}/{whole}"
                text, _, file = self._text(folder, name)
                texts = split(text, file, suffixes) | {each: (around[each].replace("{}", name), 0) for each in around}
                for each, (part, above) in texts.items():
                    full_name, part_of = name + each, f"{folder}/{whole}"
                    self._definitions[full_name] = parse(part, full_name, file, self.ros, part_of, above)
                return

    def package(self, name: str) -> Path | None:
        """The folder of one of the packages around the node."""
        if self._packages is None:
            self._packages = dict(_packages_around(self._folder)) if self._folder else {}
        return self._packages.get(name)


class _Carried(NamedTuple):
    """What rosspin carries: texts and their files by folder and name, and the packages that they are of."""

    texts: dict[tuple[str, str], tuple[str, str]]
    packages: set[str]


@cache
def _carried(ros: int) -> _Carried:
    texts: dict[tuple[str, str], tuple[str, str]] = {}
    for file in CARRIED[ros]:
        data = pkgutil.get_data(__package__, file)  # also where rosspin is imported from a zip file
        assert data is not None  # all loaders of files can give it
        _, *parts = HEADING.split(data.decode())
        for kind, name, text in zip(parts[::3], parts[1::3], parts[2::3], strict=True):
            texts[kind.lower(), name] = text, file
    return _Carried(texts, {name.partition("/")[0] for _, name in texts})


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
