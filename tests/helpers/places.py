"""Where a node may lie: in a workspace's sources, in what colcon installs, behind links, among installed packages."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from unittest import mock

from rosspin.clocks import installed

__all__ = ["PLACES", "SITE", "lay", "looking_for_packages_in"]

SITE = f"lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages"

# The folder of the file, and how it comes there. In the folders below "user", this Python looks for packages.
PLACES = {
    "install": (f"ws/install/robots/{SITE}/robots", "copied"),
    "merged install": (f"ws/install/{SITE}/robots", "copied"),
    "symlink install": (f"ws/install/robots/{SITE}/robots", "linked"),
    "egg-link": ("ws/build/robots/robots", "folder linked"),
    "user": (f"user/{SITE}/robots", "copied"),
    "egg": (f"user/{SITE}/robots-0.1.0-py3.egg/robots", "copied"),
    "linked package": (f"user/{SITE}/robots", "folder linked"),
    "module": (f"user/{SITE}", "copied"),
}


@contextmanager
def looking_for_packages_in(folder: Path) -> Iterator[None]:
    """Within this context, this Python's installed packages lie in this folder, too."""
    with mock.patch.multiple(installed, _LIBRARIES={*installed._LIBRARIES, os.path.join(folder, "")}, _own=set()):
        installed.is_installed_file.cache_clear()
        yield
    installed.is_installed_file.cache_clear()


def lay(sources: Path, place: str, parent: Path) -> Path:
    """Lay a folder of Python files at a place below ``parent``, once, and return the folder there."""
    where, how = PLACES[place]
    folder = parent / place / where
    if folder.exists():
        return folder
    if how == "folder linked":
        folder.parent.mkdir(parents=True)
        folder.symlink_to(sources)
    else:
        copy = os.symlink if how == "linked" else shutil.copy
        shutil.copytree(sources, folder, copy_function=copy, ignore=shutil.ignore_patterns("recorded", "__pycache__"))
    if place == "module":
        record = folder / "robots-0.1.0.dist-info" / "RECORD"
        record.parent.mkdir()
        record.write_text("".join(f"{path.relative_to(folder)},,\n" for path in folder.rglob("*.py")))
    return folder
