"""Let a node import the stand-ins of both ROSes, and messages. Its first import of a stand-in decides its ROS."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import BuiltinImporter, FrozenImporter, ModuleSpec, PathFinder, SourceFileLoader
from types import FrameType, ModuleType
from typing import Any
from weakref import WeakKeyDictionary

from ..messages import MessageFinder
from ..world.world import World
from .kinds import ROS, ros_of
from .source import Code, folder_of, is_own, names_a_ros, own_folders

__all__ = ["Imports"]


class Imports(MetaPathFinder):
    """An entry of ``sys.meta_path`` for one process: ``world`` is its own, and ``node`` what runs in it.

    Importing ``rospy`` or ``rclpy`` binds the process to ROS 1 or 2. Importing the other one then raises ImportError,
    as where only one ROS is installed. Messages that are imported earlier belong to the ROS that the code names.
    """

    def __init__(
        self,
        node: Code,
        world: World,
        stand_in: Callable[[int, str], Mapping[str, ModuleType]],
        hidden: Callable[[Mapping[str, ModuleType]], None],
    ) -> None:
        self._node = node
        self._own = own_folders(node)
        self._world = world
        self._stand_in = stand_in  # the modules of a ROS, or of a package next to it, by their names
        self._hidden = hidden  # is told of the modules that made way for messages
        self._finder = self._new_finder(node.hint or 1)
        if not node.hint:
            # It may become one of ROS 2 while it imports something, when it is too late to take anything away.
            hidden(MessageFinder(2, folder_of(node)).hide())

    @property
    def packages(self) -> set[str]:
        """The packages of messages that were imported."""
        return self._finder.packages

    @property
    def messages(self) -> Any:
        """The classes of messages by name, as in ``messages["std_msgs/UInt32"]``."""
        return self._finder_of(self._world.ros or self._finder.library.ros).messages

    def hide(self) -> dict[str, ModuleType]:
        """Take out of ``sys.modules`` messages that are not the process's, and return them."""
        return self._finder.hide()

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        """Part of the import system; None for a module that is neither ROS's nor a message's."""
        if ros := ros_of(fullname):
            return self._find_ros(fullname, ros.number)
        if fullname.startswith("rosspin."):
            return None
        number = self._world.ros or self._node.hint or _named_by_who_asks(sys._getframe(1)) or 1
        if fullname.partition(".")[0] in ROS[number].beside:
            # Some have messages, too: actionlib.msg
            return self._find_ros(fullname, number) or self._finder_of(number).find_spec(fullname, path, target)
        return self._finder_of(number).find_spec(fullname, path, target) or self._find_own(fullname, path)

    def _find_own(self, fullname: str, path: Sequence[str] | None) -> ModuleSpec | None:
        """Find a module of the node's own that is not to be loaded as usual; None for all others."""
        if not self._node.loader or any(each.find_spec(fullname) for each in (BuiltinImporter, FrozenImporter)):
            return None
        spec = PathFinder.find_spec(fullname, path)
        if spec and isinstance(spec.loader, SourceFileLoader) and is_own(fullname, spec.loader.path, self._own):
            spec.loader = self._node.loader(fullname, spec.loader.path)
            return spec
        return None

    def _find_ros(self, fullname: str, ros: int) -> ModuleSpec | None:
        if self._finder.library.ros != ros and self._finder.packages:
            raise ImportError(
                f"messages of ROS {self._finder.library.ros} were imported before {fullname}", name=fullname
            )
        self._world.bind(ros)
        modules = self._stand_in(ros, fullname.partition(".")[0])
        if fullname in modules:
            sys.modules.pop(fullname, None)  # else it would be loaded again, by its own spec
            given = _Given(self._module(ros, fullname, modules), partial(self._bring, ros, fullname))
            return ModuleSpec(fullname, given, is_package=True)
        if any(name.startswith(f"{fullname}.") for name in modules):
            return ModuleSpec(fullname, None, is_package=True)
        return None

    def _module(self, ros: int, name: str, modules: Mapping[str, ModuleType]) -> ModuleType:
        if name == ROS[ros].roots[0]:
            return ROS[ros].stand_in.for_process()  # type: ignore[no-any-return]
        module = modules[name]
        own = module.__spec__.name.removeprefix("rosspin.") if module.__spec__ else name
        _NAMES.setdefault(module, own if own in modules else name)  # rclpy.executors is rclpy.guard_condition, too
        module.__class__ = _StandIn
        return module

    def _bring(self, ros: int, fullname: str) -> None:
        """Import what a module of a ROS imports itself."""
        modules = self._stand_in(ros, "")
        for name in ROS[ros].stand_in.brought_by(fullname):
            module = sys.modules.get(name) or sys.modules.setdefault(name, self._module(ros, name, modules))
            parent, _, child = name.rpartition(".")
            if parent in sys.modules:
                setattr(sys.modules[parent], child, module)

    def _finder_of(self, ros: int) -> MessageFinder:
        if self._finder.library.ros != ros and not self._finder.packages:
            self._finder = self._new_finder(ros)
        return self._finder

    def _new_finder(self, ros: int) -> MessageFinder:
        finder = MessageFinder(ros, folder_of(self._node))
        self._hidden(finder.hide())
        return finder


_NAMES: WeakKeyDictionary[ModuleType, str] = WeakKeyDictionary()


class _StandIn(ModuleType):
    """A module of a stand-in, which errors name as on a real ROS, such as rclpy.node."""

    @property
    def __name__(self) -> str:  # type: ignore[override]
        return _NAMES[self]

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"module {_NAMES[self]!r} has no attribute {name!r}", name=name, obj=self)


class _Given(Loader):
    """Gives a module that exists already, and those that it brings; the module keeps its own spec."""

    def __init__(self, module: ModuleType, bring: Callable[[], None]) -> None:
        self._module = module
        self._spec = module.__spec__
        self._bring = bring

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        return self._module

    def exec_module(self, module: ModuleType) -> None:
        module.__spec__ = self._spec
        self._bring()


def _named_by_who_asks(frame: FrameType | None) -> int:
    """Return the number of the ROS that the importing code names, or 0."""
    while frame and frame.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame.f_back
    return names_a_ros(frame.f_code) if frame else 0
