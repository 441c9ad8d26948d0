"""The state of a process. rclpy keeps it in module variables; here every process of a run has its own."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from ..world.world import World, current, current_world
from .discovery import Participants

if TYPE_CHECKING:
    from .context import Context
    from .executors import Executor
    from .logging import LogForm, RcutilsLogger
    from .node import Node

__all__ = ["Gate", "State", "state", "world_here"]


class Gate:
    """Lets one thread wait until another, or a signal handler, opens it. Opening it twice is opening it once."""

    def __init__(self) -> None:
        self._lock: Any = threading.Lock()
        self._lock.acquire()

    def open(self) -> None:
        """Let the thread that waits, or the next one that will, go on."""
        try:
            self._lock.release()
        except RuntimeError:
            pass  # it is open

    def wait(self, ns: int | None = None) -> bool:
        """Wait until it is opened, for at most ``ns`` nanoseconds, and shut it. Return whether it was opened."""
        if ns is not None and ns <= 0:
            return bool(self._lock.acquire(False))
        if hasattr(self._lock, "wait") and self._lock.locked():
            self._lock.holder = None  # whoever made it, or waited last, does not keep others from going on
            return bool(self._lock.wait(current(), ns))  # exactly, and at a lower cost than by way of seconds
        return bool(self._lock.acquire(True, -1 if ns is None else min(ns / 1e9, threading.TIMEOUT_MAX)))


class State:
    """The contexts of a process, its log levels, and what its signals do."""

    ROS = 2

    def __init__(self, world: World) -> None:
        self.world = world
        self.clock = world.clock
        self.context: Context | None = None  # the default one
        self.executor: Executor | None = None  # the one that ``rclpy.spin`` uses

        self.contexts: list[Context] = []  # those that were initialised
        self.participants = world.graph.part(Participants)
        world.at_end.append(self._be_missed)
        self.sleepers: list[Gate] = []  # who sleeps until a time of the system's clock
        world.at_jump.append(self._wake_sleepers)
        self.waiting: WeakKeyDictionary[Gate, None] = WeakKeyDictionary()  # the gates that a signal opens
        self.handled: set[int] = set()  # signals that shut the contexts down
        self.before: dict[int, Any] = {}  # signal handlers that were there before rclpy's
        self.asleep = False  # whether the main thread sleeps on a Clock, in C code, where no handler runs
        self.pending: Callable[[], Any] | None = None  # the handler that is to run after that sleep

        self.level = 20  # INFO
        self.levels: dict[str, int] = {}
        self.console = True
        self.root_logger: RcutilsLogger | None = None
        self.rosout: dict[str, Node] | None = {}  # by which node a logger publishes; None: none may
        self.log_form: LogForm | None = None  # None: not looked up yet

    def _wake_sleepers(self) -> None:
        for gate in self.sleepers:
            gate.open()

    def _be_missed(self) -> None:
        for context in self.contexts:
            self.participants.leave(context, killed=not self.world.finished)


def world_here() -> World | None:
    """The world of the calling node; None outside a run."""
    try:
        return current_world()
    except RuntimeError:
        return None


def state() -> State:
    """The state of the calling process. Raises RuntimeError outside a run."""
    return current_world().part(State)
