"""What ``import std_msgs.msg`` finds: packages of classes, each made when it is asked for."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

from .library import FOLDERS, Library

__all__ = ["MessageFinder"]


class MessageFinder(MetaPathFinder, Loader):
    """An entry of ``sys.meta_path``, as a context: inside of it a node can import messages.

    ``ros`` is 1 or 2; ``folder`` is the node file's, whose package and workspace are searched, too. It finds
    ``std_msgs``, ``std_msgs.msg`` and a module for each class, named as a generated one: ``std_msgs.msg._UInt32``
    (ROS 2: ``std_msgs.msg._u_int32``); likewise ``std_srvs.srv`` and, for ROS 2, ``action``. A package's own Python
    modules are found next to its messages. At the end, what was imported through this finder is taken out of
    ``sys.modules``, and what was there before is put back. When the context is entered again, these modules change
    places once more.

    ``messages`` makes and holds the classes: ``finder.messages["std_msgs/UInt32"]``; ``packages`` are those that
    were imported through this finder.
    """

    def __init__(self, ros: int, folder: Path | None = None) -> None:
        self.library = Library(ros, folder)
        if ros == 1:
            from . import ros1

            self.messages: Any = ros1.Messages(self.library)
        else:
            from . import ros2

            self.messages = ros2.Messages(self.library)
        self._hidden: dict[str, ModuleType] = {}
        self.packages: set[str] = set()
        self._modules: dict[str, ModuleType] = {}  # what those packages consist of

    def __enter__(self) -> MessageFinder:
        self._hidden = self.hide()
        sys.modules.update(self._modules)
        sys.meta_path.insert(0, self)
        return self

    def hide(self) -> dict[str, ModuleType]:
        """Take out of ``sys.modules`` what stands in the way of this finder, and return it."""
        # A package that is imported already may be the real one, or another node's. Those without such a module are not
        # looked up: a run that imports no message does not need the library.
        names = [name.split(".") for name in list(sys.modules) if ".msg" in name or ".srv" in name or ".action" in name]
        packages = {package for package, module, *_ in names if module in FOLDERS}
        return _take({package for package in packages if self._is_ours(package)} | self.packages)

    def __exit__(self, *_: object) -> None:
        sys.meta_path.remove(self)
        self._modules = _take(self.packages)
        sys.modules.update(self._hidden)

    def _is_ours(self, module: str) -> bool:
        package = module.partition(".")[0]
        return package not in sys.stdlib_module_names and self.library.has(package)

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        """Part of the import system; None for a module that is not a message's."""
        package, *rest = fullname.split(".")
        if not self._is_ours(fullname):
            return None if rest else self._modules_of(package)
        self.packages.add(package)
        if not rest:
            return self._package(package)
        folder, *modules = rest
        folders = FOLDERS[:2] if self.library.ros == 1 else FOLDERS  # in ROS 1, an action becomes messages
        if folder not in folders or not self.library.names(package, folder):
            return None
        if not modules:
            return ModuleSpec(fullname, self, origin="rosspin", is_package=True)
        if len(modules) == 1 and modules[0] in self._class_modules(package, folder):
            return ModuleSpec(fullname, self, origin="rosspin")
        return None

    def _package(self, name: str) -> ModuleSpec:
        """A package, whose Python modules are where catkin (ament) has them: in src/NAME (NAME)."""
        return self._source(name) or ModuleSpec(name, self, origin="rosspin", is_package=True)

    def _source(self, name: str) -> ModuleSpec | None:
        folder = self.library.package(name)
        source = folder / ("src" if self.library.ros == 1 else "") / name if folder else None
        if source and (source / "__init__.py").is_file():
            return spec_from_file_location(name, source / "__init__.py", submodule_search_locations=[str(source)])
        return None

    def _modules_of(self, name: str) -> ModuleSpec | None:
        """Find a package of the workspace that has no messages, unless it can be imported anyway."""
        if name in sys.stdlib_module_names or not (spec := self._source(name)):
            return None
        if (other := PathFinder.find_spec(name)) and other.origin:  # without one, it is any folder of that name
            return None
        self.packages.add(name)
        return spec

    def _class_modules(self, package: str, folder: str) -> dict[str, str]:
        return {self.messages.module(name): name for name in self.library.names(package, folder)}

    def create_module(self, spec: ModuleSpec) -> None:
        """Part of the import system: an ordinary module will do."""

    def exec_module(self, module: ModuleType) -> None:
        """Part of the import system: fill such a module."""
        package, *rest = module.__name__.split(".")
        if not rest:
            return
        folder, *modules = rest
        whole = self.library.names(package, folder)
        if modules:
            whole = [self._class_modules(package, folder)[modules[0]]]
        names = [name + suffix for name in whole for suffix in ("", *self.library.suffixes(folder))]

        def find(name: str) -> Any:
            if name not in names:
                raise AttributeError(f"module {module.__name__!r} has no attribute {name!r}")
            full_name = f"{package}/{name}"
            is_whole = folder != "msg" and name in whole
            made = self.messages.whole(folder, full_name) if is_whole else self.messages[full_name]
            setattr(module, name, made)
            return made

        vars(module).update(__getattr__=find, __all__=names, __dir__=lambda: sorted({*vars(module), *names}))


def _take(packages: set[str]) -> dict[str, ModuleType]:
    """Take the modules of packages out of ``sys.modules``, and return them."""
    names = [name for name in sys.modules if name.partition(".")[0] in packages] if packages else []
    return {name: sys.modules.pop(name) for name in names}
