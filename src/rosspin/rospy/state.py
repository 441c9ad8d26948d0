"""The state of a node. rospy keeps it in module variables; here every node of a run has its own."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from typing import Any

from ..world.world import World, current_world
from . import rosgraph
from .exceptions import ROSInitException

__all__ = ["Master", "State", "handle_signals", "param_path", "state"]

_PORT = 40_000  # of the first node

Handler = Callable[[int, Any], None]


class Master:
    """The parameters and the names of nodes and services, which the nodes of a run share as on a ROS master."""

    def __init__(self) -> None:
        self.parameters: dict[str, Any] = {}  # a tree of dictionaries
        self.nodes: dict[str, State] = {}
        self.services: dict[str, Any] = {}  # the services' names, and what each node that has one keeps of its own

    def set_param(self, name: str, param_value: Any) -> None:
        """Set the parameter with a full name, as XML-RPC would deliver it. Raises what ``rospy.set_param`` does."""
        from xmlrpc.client import dumps, loads  # slow to import, and most nodes set nothing

        value: Any = loads(dumps((param_value,)))[0][0]
        path, tree = param_path(name), self.parameters
        if not path:
            tree.clear()
            tree.update(value)
            return
        for part in path[:-1]:
            if not isinstance(tree.get(part), dict):
                tree[part] = {}
            tree = tree[part]
        tree[path[-1]] = value


def param_path(name: str) -> list[str]:
    """Return the keys that lead through the tree to the parameter with a full name."""
    return [part for part in name.split(rosgraph.SEP) if part]


class State:
    """A node's name, parameters, log and time, and whether it should shut down."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.world = world
        self.clock = world.clock
        argv = world.argv

        self.time_initialized = False
        self.ros_time: int | None = None  # as set by /clock; None: the node's own clock
        self.ros_time_changed = threading.Condition()

        self.mappings = rosgraph.load_mappings(argv)
        self.resolved_mappings: dict[str, str] = {}
        self.namespace = rosgraph.get_ros_namespace(argv=argv)
        self.name = self.namespace + "unnamed"
        self.master = world.graph.part(Master)
        self.sought: set[str] = set()  # the parameters that were asked for, by their full names
        self.private_parameters: dict[str, Any] = {}  # set by ``init_node``, unless the command line sets them

        self.init_args: tuple[Any, ...] | None = None
        self.initialized = False
        self.rosout = False  # whether /rosout counts as one of its topics

        self.shutdown_lock = threading.Lock()
        self.shutdown_requested = False
        self.shutdown = False
        self.shutdown_hooks: list[Callable[[], None]] = []
        self.at_init: list[Callable[[], None]] = []  # rospy's own, called by ``init_node``
        self.before_shutdown: list[Callable[[], None]] = []  # rospy's own, called after the shutdown hooks
        self.at_shutdown: list[Callable[[], None]] = []  # rospy's own, called once ``shutdown`` is true

        self.timers: list[Any] = []  # all that were started, if ticks are recorded

        self.log_level: int | None = None  # None: logging is not set up yet
        self.log_times: dict[object, Any] = {}
        self.log_messages: dict[object, str] = {}
        self.logged_once: set[object] = set()
        world.at_end.append(self._be_gone)

    @property
    def uri(self) -> str | None:
        """Where the node would be found on a network; None before ``init_node``."""
        return f"http://localhost:{_PORT + self.world.number}/" if self.initialized else None

    def _be_gone(self) -> None:
        self.shutdown_requested = self.shutdown = True

    def now(self) -> int:
        """Return the time (ns) of /clock if used, else of the clock. Raises ROSInitException before ``init_node``."""
        if not self.time_initialized:
            raise ROSInitException("time is not initialized. Have you called init_node()?")
        return self.clock.system() if self.ros_time is None else self.ros_time

    def in_run(self) -> int:
        """Return the time (ns) to record ticks with: /clock's, else the run's, which never jumps."""
        return self.clock.now() if self.ros_time is None else self.ros_time

    def wait_for_ros_time(self, seconds: float) -> None:
        """Wait until ROS time is set again, for at most this many seconds."""
        with self.ros_time_changed:
            self.ros_time_changed.wait(seconds)

    def set_ros_time(self, ns: int | None) -> None:
        """Set the ROS time (ns; None: the node's own clock) and wake up all who wait for it."""
        with self.ros_time_changed:
            self.ros_time = ns
            self.ros_time_changed.notify_all()


def state() -> State:
    """Return the state of the calling node. Raises RuntimeError outside a run."""
    return current_world().part(State)


def handle_signals(handler: Handler) -> None:
    """Register ``handler`` for SIGINT and SIGTERM. Earlier handlers are called after it."""
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
