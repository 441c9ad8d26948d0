"""The state of one node in one run: what in rospy is spread over module variables.

Every run has its own, found through a context variable, so that runs in one process do not see each other.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from contextvars import ContextVar
from typing import Any

from ..clock import Clock, WallClock
from . import rosgraph
from .exceptions import ROSInitException

__all__ = ["NotSimulated", "World", "current", "world"]

Handler = Callable[[int, Any], None]

# A tick as it is recorded: source, number, expected, real and duration in ns; the duration is None while it runs.
Record = list[Any]


class NotSimulated(NotImplementedError):
    """The node asks for something that only a real ROS has."""

    def __init__(self, name: str) -> None:
        super().__init__(f"{name} is not simulated; run this node on a real ROS")


class World:
    """A node's world: the clock it runs on, its name and parameters, and whether it is to shut down.

    ``argv`` is the node's command line. ``handle_signals`` registers what is called at SIGINT and SIGTERM.
    """

    def __init__(self, clock: Clock, argv: list[str], handle_signals: Callable[[Handler], None]) -> None:
        self.clock = clock
        self.argv = argv
        self.handle_signals = handle_signals

        self.time_initialized = False
        self.ros_time: int | None = None  # as set by /clock; None: the node's own clock
        self.ros_time_changed = clock.condition()

        self.mappings = rosgraph.load_mappings(argv)
        self.resolved_mappings: dict[str, str] = {}
        self.namespace = rosgraph.get_ros_namespace(argv)
        self.name = self.namespace + "unnamed"
        self.parameters: dict[str, Any] = {}

        self.init_args: tuple[Any, ...] | None = None
        self.initialized = False

        self.shutdown_lock = threading.Lock()
        self.shutdown_requested = False
        self.shutdown = False
        self.over = False  # the run has ended: no timer calls back any more
        self.shutdown_hooks: list[Callable[[], None]] = []

        self.errors: list[BaseException] = []  # those whose tracebacks were printed
        self.failure: NotSimulated | None = None  # met in a thread; the run ends with it

        self.log_level: int | None = None  # None: logging is not set up yet
        self.log_times: dict[object, Any] = {}
        self.log_messages: dict[object, str] = {}
        self.logged_once: set[object] = set()

        self.ticks: list[Record] | None = None  # None: nobody asks for them
        self._sources: dict[str, int] = {}
        self.threads = 0

    def now(self) -> int:
        """ROS time as told by /clock, else the clock's, in ns. Before ``init_node``: ROSInitException."""
        if not self.time_initialized:
            raise ROSInitException("time is not initialized. Have you called init_node()?")
        return self.clock.now() if self.ros_time is None else self.ros_time

    def source(self, name: str) -> str:
        """A name for something that ticks, made different from those given before: Rate, Rate 2, ..."""
        count = self._sources[name] = self._sources.get(name, 0) + 1
        return name if count == 1 else f"{name} {count}"


current: ContextVar[World] = ContextVar("current")

_process: list[World] = []


def world() -> World:
    """The world of the run that asks; outside of a run the process's own, on the wall clock."""
    try:
        return current.get()
    except LookupError:
        if not _process:
            _process.append(World(WallClock(), sys.argv, handle_process_signals))
        return _process[0]


def handle_process_signals(handler: Handler) -> None:
    """Register ``handler`` for SIGINT and SIGTERM of this process; handlers that were there are called after it."""
    import signal

    for number in (signal.SIGTERM, signal.SIGINT):
        previous = signal.getsignal(number)

        def chained(sig: int, frame: Any, previous: Any = previous) -> None:
            handler(sig, frame)
            if callable(previous):
                try:
                    previous(sig, frame)
                except KeyboardInterrupt:
                    pass

        signal.signal(number, chained)
