"""Which code is installed: Python's own, packages', a real ROS's.

A node may lie among it: pip puts a student's package into ``site-packages``. That package is the node's then. colcon
puts nodes into folders of the same name, which are no interpreter's.
"""

from __future__ import annotations

import os
import re
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.metadata import distributions

__all__ = ["is_installed_file", "note_own"]


def _libraries() -> Iterator[str]:
    """The folders of this interpreter's modules, and of the one from which a virtual environment was made."""
    yield os.path.dirname(os.__file__)
    for prefix in (sys.prefix, sys.base_prefix):
        for scheme in sysconfig.get_scheme_names():  # a user's own, and Debian's, are among them
            paths = sysconfig.get_paths(scheme, {"base": prefix, "platbase": prefix})
            yield from (paths[name] for name in ("stdlib", "platstdlib", "purelib", "platlib"))
    yield "/usr/lib/python3/dist-packages"  # of Debian, whichever Python this is


def _spellings(path: str) -> set[str]:
    return {os.path.abspath(path), os.path.realpath(path)}


_LIBRARIES = {os.path.join(each, "") for path in _libraries() for each in _spellings(path)}
_ROS = re.compile(r"/opt/ros/\w+/lib/")

# Files and folders of nodes. They stay for as long as this Python runs: an error may be told after its run.
_own: set[str] = set()


@cache
def is_installed_file(path: str) -> bool:
    """Whether a file of code belongs to the standard library or to an installed package."""
    if not os.path.isabs(path):
        return path.startswith("<frozen ")
    found = [(_around(each), each) for each in _spellings(path)]
    if any(each.startswith(own) and len(own) > len(library) for library, each in found for own in _own):
        return False
    return any(library for library, _ in found)


def _around(path: str) -> str:
    """The innermost folder around a file in which packages are installed, or else nothing."""
    ros = _ROS.match(path)
    return max((*filter(path.startswith, _LIBRARIES), ros[0] if ros else ""), key=len)


def note_own(file: str, folders: Iterable[str]) -> None:
    """Note that a file is a node's, and with it the ``folders`` from which it imports modules of its own.

    Of a folder in which packages are installed, that is its package, and what was installed with it.
    """
    own = {os.path.join(folder, "") for folder in folders if not _around(os.path.join(folder, ""))}
    for path in _spellings(file):
        if library := _around(path):
            own.update(library + name for name in _installed_with(library, path))
    if not own <= _own:
        _own.update(own)
        is_installed_file.cache_clear()


def _installed_with(library: str, path: str) -> set[str]:
    """The modules and packages of the distribution that has put a file into a library; at least its own."""
    file = path.removeprefix(library)
    listed = ([name.as_posix() for name in each.files or ()] for each in distributions(path=[library]))
    names = next((names for names in listed if file in names), [file])
    return {"".join(name.partition("/")[:2]) for name in names}
