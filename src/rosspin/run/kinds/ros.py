"""What a run asks of a ROS: what stands in for it, how its nodes are told things, how they end, which words it uses."""

from __future__ import annotations

from abc import ABC
from collections.abc import Iterable, Mapping
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

if TYPE_CHECKING:
    from ...clocks.frames import Place
    from ...world.graph import Graph
    from ...world.watcher import Watcher

__all__ = ["Ros", "Words"]


class Words(NamedTuple):
    """What a node's loops should ask, how they should sleep, and what a node ends with, as its language writes it."""

    asks: str
    sleeps: str
    spins: str


class Ros(ABC):
    """One of the ROSes. What is a class variable here is what most of them differ in."""

    number: ClassVar[int]
    # Importing one of these packages makes a process one of this ROS; the first of them is the stand-in's own.
    roots: ClassVar[tuple[str, ...]]
    # Packages that its nodes may import, too, and the modules here that stand in for them.
    beside: ClassVar[Mapping[str, str]]
    # The modules that its nodes need besides Python's own.
    needed: ClassVar[frozenset[str]]
    name_key: ClassVar[str]  # under which its command line names a node
    flag: ClassVar[str] = ""  # before what its command line sets, if it needs one
    # Whether Ctrl-C raises KeyboardInterrupt in a node, which ends it if nothing catches that.
    raises: ClassVar[bool]
    # Whether several nodes run as in terminals of their own, rather than under roslaunch.
    in_terminals: ClassVar[bool]
    # Whether each timer calls back in a thread of its own.
    timers_are_threads: ClassVar[bool]
    words: ClassVar[Words]  # in Python
    killed_as: ClassVar[str] = ""  # what else kills a node that does not end, as the rest of a sentence
    also_threads: ClassVar[str] = ""  # what else is a thread, likewise
    _steps: ClassVar[str]

    @property
    def stand_in(self) -> ModuleType:
        """The package that stands in for this ROS, loaded only for nodes that may need it, as rclpy is large."""
        return import_module(self.home(self.roots[0]))

    def home(self, package: str) -> str:
        """Return the name of the module here that stands in for one of its packages, or has what does."""
        return f"rosspin.{self.beside.get(package, self.roots[0])}"

    def settings(self, flag: str, settings: Iterable[str]) -> list[str]:
        """Return the words of a command line that set parameters (``flag`` is -p) or names (-r), as in ``a:=b``."""
        return [self.flag, *(word for each in settings for word in (flag, each))] if self.flag else list(settings)

    @property
    def tester(self) -> Any:
        """The module of the node that a test plays."""
        return import_module(f"rosspin.{self.roots[0]}.tester")

    @property
    def rate(self) -> Any:
        """The class of its rates."""
        return self.stand_in.Rate

    @property
    def noted_steps(self) -> Any:
        """The class of the steps of its nodes, as a page shows them. ROS 2's loads rclpy."""
        module, _, name = self._steps.partition(".")
        return getattr(import_module(f"rosspin.run.{module}"), name)

    def explain_waits(self, graph: Graph, watcher: Watcher | None) -> str:
        """Say which callbacks of a graph wait forever, a line for each."""
        return ""

    def is_asleep_on_a_rate(self, places: Iterable[Place]) -> bool:
        """Whether a thread whose stack is at these places sleeps on a rate that nothing wakes after Ctrl-C."""
        return False
