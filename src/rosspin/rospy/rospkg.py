"""rospkg and roslib for nodes of ROS 1: where packages are (sources: rospkg/rospack.py, roslib/launcher.py).

A package is looked for around the file that asks. Loaded when a node imports them.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any

from ..messages import filling
from ..messages.library import Library
from ..world.world import NotSimulated, refusing
from . import rosgraph

__all__ = ["ResourceNotFound", "RosPack"]


class ResourceNotFound(Exception):
    """There is no such package in the ``ros_paths``."""

    def __init__(self, msg: str, ros_paths: list[str] | None = None) -> None:
        super().__init__(msg)
        self.ros_paths = ros_paths

    def __str__(self) -> str:
        paths = [f"ROS path [{number}]={path}" for number, path in enumerate(self.ros_paths or ())]
        return "\n".join([*map(str, self.args), *paths])


class RosPack:
    """Finds packages. ``ros_paths`` has no effect."""

    def __init__(self, ros_paths: list[str] | None = None) -> None:
        pass

    @staticmethod
    def get_instance(ros_paths: list[str] | None = None) -> RosPack:
        """Return the same one each time."""
        return _ROSPACK

    def get_path(self, name: str) -> str:
        """Return the folder of a package. Raises ResourceNotFound."""
        return _folder(name, sys._getframe(1))

    def __getattr__(self, name: str) -> Any:
        return refusing("rospkg.RosPack", _OF_ROSPACK)(name)


_ROSPACK = RosPack()

_OF_ROSPACK = {
    *("get_custom_cache", "get_depends", "get_depends_on", "get_manifest", "get_ros_paths", "get_rosdeps", "list"),
    *("ros_paths", "set_custom_cache", "stack_of"),
}


def load_manifest(package_name: str) -> None:
    """Do nothing: a node finds the modules of the packages around it anyway."""


def get_pkg_dir(package: str, required: bool = True, ros_root: Any = None, ros_package_path: Any = None) -> str | None:
    """Return the folder of a package; None for one that is not there, if it is not ``required``.

    Raises InvalidROSPkgException.
    """
    try:
        return _folder(package, sys._getframe(1))
    except ResourceNotFound:
        if required:
            raise InvalidROSPkgException(f"Cannot locate installation of package {package}") from None
        return None


class ROSPkgException(Exception):
    """Something is wrong with a package."""


class InvalidROSPkgException(ROSPkgException):
    """There is no such package around the file that asks."""


def _folder(package: str, asks: FrameType) -> str:
    # The file of the code may be a relative name, and the node in another folder by now.
    around = Path(asks.f_globals.get("__file__") or asks.f_code.co_filename).absolute().parent
    library = Library(1, around)
    if found := library.package(package):
        return str(found)
    if library.has(package):  # rosspin carries its messages, and no folder
        raise NotSimulated(f"the folder of the package {package}")
    raise ResourceNotFound(package, [str(around)])


def _module(name: str, *names: str, lacking: tuple[str, ...] = ()) -> ModuleType:
    module = ModuleType(name)
    vars(module).update({each: globals()[each] for each in names}, __getattr__=refusing(name, set(lacking)))
    return module


_names = _module(
    "roslib.names",
    lacking=(
        *("is_legal_resource_base_name", "is_legal_resource_name", "package_resource_name", "resource_name"),
        *("resource_name_base", "resource_name_package"),
    ),
)
vars(_names).update({name: value for name, value in vars(rosgraph).items() if name[0] != "_"})

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {
    "rospkg": _module(
        "rospkg",
        *("ResourceNotFound", "RosPack"),
        lacking=("Manifest", "RosStack", "get_log_dir", "get_package_name", "get_ros_home", "get_ros_paths"),
    ),
    "rospkg.common": _module("rospkg.common", "ResourceNotFound"),
    "roslib": _module("roslib", "load_manifest"),
    "roslib.message": filling,
    "roslib.names": _names,
    "roslib.packages": _module(
        "roslib.packages",
        *("InvalidROSPkgException", "ROSPkgException", "get_pkg_dir"),
        lacking=("find_node",),
    ),
}
ResourceNotFound.__module__ = "rospkg.common"
ROSPkgException.__module__ = InvalidROSPkgException.__module__ = "roslib.packages"
