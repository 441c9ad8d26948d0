"""The world of a node in one run: what is kept in either ROS, and what each ROS adds."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Set
from contextlib import AbstractContextManager
from typing import Any, TypeVar

from ..clocks.clock import NS, Clock
from ..clocks.frames import Whereabouts
from ..clocks.simulation import Simulation
from ..clocks.stacks import Program, acting_for, current, keeper, thread_name, waiting_for, whose
from .graph import Graph, Recording
from .packages import PACKAGES

__all__ = [
    "NotSimulated",
    "World",
    "current",
    "current_world",
    "keeper",
    "not_simulated",
    "refusing",
    "thread_name",
    "waiting_for",
]

Part = TypeVar("Part")


class NotSimulated(NotImplementedError):
    """The node needs something that only a real ROS has, or only the place that ``where`` names.

    ``place`` is FILE or FILE:LINE of a node in C++; for a node in Python, the traceback says it.
    """

    def __init__(self, name: str, where: str = "a real ROS", place: str = "") -> None:
        super().__init__(f"{name} is not simulated; run this node on {where}")
        self.name = name
        self.where = where
        self.place = place

    def __reduce__(self) -> tuple[Any, ...]:
        return NotSimulated, (self.name, self.where), self.__dict__


def not_simulated(error: BaseException) -> NotSimulated | None:
    """Turn an error into NotSimulated if it says that a package of the node's ROS cannot be imported; else None."""
    name = error.name or "" if isinstance(error, ModuleNotFoundError) else ""
    root, _, rest = name.partition(".")
    world = whose()
    ros = world.ros if isinstance(world, World) else 0
    lacking = (
        any(root in PACKAGES.get(each, ()) for each in ([ros] if ros else PACKAGES))
        or root.endswith(("_msgs", "_srvs", "_interfaces"))
        or rest.startswith("srv")
        or rest.partition(".")[0] in getattr(sys.modules.get(root), "NOT_SIMULATED", ())
    )
    return NotSimulated(name).with_traceback(error.__traceback__) if lacking else None


def refusing(module: str, names: Set[str]) -> Callable[[str], Any]:
    """Make the ``__getattr__`` for a module of a stand-in, which lacks these names of the real one."""

    def find(name: str) -> Any:
        if name in names:
            raise NotSimulated(f"{module}.{name}")
        raise AttributeError(f"module {module!r} has no attribute {name!r}", name=name)

    return find


class World(Program):
    """A node's world: the clock that it runs on, its command line ``argv``, and what is recorded of it.

    ``graph_of(ros)`` gives the graph of a ROS; it is called once the node uses one. ``number`` tells the process from
    the others of its run.
    """

    graph: Graph

    def __init__(
        self,
        clock: Clock,
        argv: list[str],
        recording: Recording,
        graph_of: Callable[[int], Graph],
        number: int = 0,
    ) -> None:
        super().__init__()
        self.clock = clock
        self.pid = os.getpid()
        self.stderr = sys.stderr  # taken now, whatever the node puts in its place
        self.number = number
        self.name = ""  # its full name in the graph, as soon as it has one
        self.file = os.path.basename(argv[0]) if argv else ""
        self.nodes: list[str] = []  # the full names of all nodes that it has had
        self.crashed = False  # whether a fault of the run has killed it
        self.at_jump: list[Callable[[], None]] = []  # called when the system's clock is set
        self.recording = recording
        self.ros = 0  # 1 or 2, once it has imported one of them
        self.at_bind: list[Callable[[], None]] = []
        self._graph_of = graph_of
        self.argv = argv
        self.errors: list[BaseException] = []  # those whose tracebacks were printed
        self.failure: Exception | None = None  # what a thread has raised to end the run
        self.main_status: int | None = None  # with which its main program has ended
        self.exit_status: int | None = None  # with which the whole process has ended
        self.finished = False  # whether it has come to its own end: it was not killed, nor left by os._exit
        self.on_failure: Callable[[], None] | None = None  # called for each error, and a main status other than 0
        self.waited: list[Whereabouts] = []  # where its threads were when it was killed
        self.at_exit: list[tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]] = []
        self.forked: list[Any] = []  # processes of multiprocessing that it has started, but no daemons
        self.waiting = 0  # how many callbacks wait for someone to spin, or for their first call; -1 once that has come
        self.lost: list[str] = []  # in words, what a C++ node has destroyed before it spun: see Running
        self._sources: dict[str, int] = {}
        self._parts: dict[type, Any] = {}

    def bind(self, ros: int) -> None:
        """Make it a process of ROS 1 or 2. Raises ImportError if it is one of the other already."""
        if self.ros not in (0, ros):
            raise ImportError(
                f"this process has imported ROS {self.ros}: a process is one of ROS 1 (rospy) or of ROS 2 (rclpy)"
            )
        if not self.ros:
            self.ros = ros
            self.graph = self._graph_of(ros)
            for function in self.at_bind:
                function()

    def source(self, name: str) -> str:
        """Make a new name for something that ticks: Rate, Rate 2, ...

        With several nodes it begins with the node's name: /talker Rate.
        """
        count = self._sources[name] = self._sources.get(name, 0) + 1
        numbered = name if count == 1 else f"{name} {count}"
        return f"{self.name} {numbered}" if self.recording.several else numbered

    def await_spin(self, more: int = 1) -> None:
        """Note that so many more callbacks wait for someone to spin or, where no one has to, for their first call."""
        if self.waiting >= 0:
            self.waiting = max(self.waiting + more, 0)

    def acting(self) -> AbstractContextManager[None]:
        """Within this context the calling code belongs to this node, whichever node's thread it is on."""
        return acting_for(self)

    def note_error(self, error: BaseException) -> None:
        """Keep an exception whose traceback was printed."""
        self.errors.append(error)
        if self.on_failure:
            self.on_failure()

    def note_main_status(self, status: int) -> None:
        """Keep the status with which the main program has ended."""
        self.main_status = status
        if status and self.on_failure:
            self.on_failure()

    def at(self, when: int, function: Callable[[], object]) -> None:
        """Call a function for this node at a time (ns) on its clock; now, if that is past."""
        if when <= self.clock.now():
            function()
            return

        def call() -> None:
            if not self.over:
                with self.acting():
                    function()

        if isinstance(self.clock, Simulation):
            self.clock.at(when, call)
        else:
            timer = threading.Timer((when - self.clock.now()) / NS, call)
            timer.daemon = True
            timer.start()

    def start(self, thread: threading.Thread) -> None:
        """Start a thread of this node, whichever node asks for it."""
        with acting_for(self):
            thread.start()

    def part(self, kind: type[Part]) -> Part:
        """Return what a ROS, ``kind.ROS``, keeps of this node: ``kind(world)``, made when it is first asked for.

        That makes it a node of this ROS.
        """
        try:
            return self._parts[kind]  # type: ignore[no-any-return]
        except KeyError:
            self.bind(kind.ROS)  # type: ignore[attr-defined]  # what binding calls may ask for the part, too
            if kind in self._parts:
                return self._parts[kind]  # type: ignore[no-any-return]
            part = self._parts[kind] = kind(self)  # type: ignore[call-arg]
            return part


def current_world() -> World:
    """Return the world of the node that asks. Raises RuntimeError outside a run."""
    world = whose()
    if isinstance(world, World):
        return world
    raise RuntimeError("no node runs here: a stand-in needs a run (rosspin.simulate, rosspin.measure, rosspin run)")
