"""The stand-in for ament_index_python: where the packages around a node are (source: ament_index_python/packages.py).

A package has one folder here, its source, which is also what it would install into ``share``.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from types import FrameType, ModuleType

from ..messages.library import Library
from ..world.world import refusing

__all__ = ["PackageNotFoundError", "get_package_prefix", "get_package_share_directory", "get_package_share_path"]


class PackageNotFoundError(KeyError):
    """There is no such package around the file that asks."""


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return the folder of a package. Raises PackageNotFoundError, or ValueError for what is no name of a package."""
    return _folder(package_name, sys._getframe(1))


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the folder of a package as a path. Raises as ``get_package_share_directory``."""
    return Path(_folder(package_name, sys._getframe(1)))


def get_package_prefix(package_name: str) -> str:
    """Return the folder of a package. Raises as ``get_package_share_directory``."""
    return _folder(package_name, sys._getframe(1))


def _folder(package: str, asks: FrameType) -> str:
    if not re.fullmatch("[a-zA-Z0-9][a-zA-Z0-9_-]+", package, re.ASCII):
        raise ValueError(f"'{package}' is not a valid package name")
    # The file of the code may be a relative name, and the node in another folder by now.
    around = Path(asks.f_globals.get("__file__") or asks.f_code.co_filename).absolute().parent
    found = Library(2, around).package(package)
    if found is None:
        raise PackageNotFoundError(f"package '{package}' not found, searching: {[str(around)]}")
    return str(found)


__getattr__ = refusing(
    "ament_index_python",
    {
        *("get_packages_with_prefixes", "get_resource", "get_resources", "get_search_paths", "get_resource_types"),
        "has_resource",
    },
)

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {
    "ament_index_python": sys.modules[__name__],
    "ament_index_python.packages": sys.modules[__name__],
}
packages = sys.modules[__name__]
