"""Context: from ``init`` to ``shutdown`` (source: rclpy/context.py, rclpy/utilities.py)."""

from __future__ import annotations

from collections.abc import Callable
from inspect import ismethod
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary, WeakMethod, WeakSet

from ..world.world import World, current_world
from . import logging
from .arguments import Arguments
from .event import Event
from .exceptions import InvalidHandle, RCLError
from .handle import Handle

if TYPE_CHECKING:
    from .executors import Executor
    from .handle import RclNode

__all__ = ["Context"]


class State:
    """Of a process: its contexts, who sleeps, and what signals do. rclpy keeps that in module variables."""

    ROS = 2

    def __init__(self, world: World) -> None:
        self.world = world
        self.clock = world.clock
        self.default: Context | None = None
        self.contexts: list[RclContext] = []  # those that were initialised and have not ended
        world.at_end.append(self._be_missed)
        self.executors: WeakSet[Executor] = WeakSet()
        self.sleepers: list[Event] = []  # who sleeps until a time of the system's clock
        world.at_jump.append(self._wake_sleepers)
        self.waiting: WeakKeyDictionary[Event, None] = WeakKeyDictionary()  # what a signal sets
        self.handled: set[int] = set()  # signals that shut the contexts down
        self.before: dict[int, Any] = {}  # signal handlers that were there before rclpy's
        self.asleep = False  # whether the main thread sleeps on a Clock, in C code, where no handler runs
        self.pending: Callable[[], Any] | None = None  # the handler that should run after that sleep

    def _wake_sleepers(self) -> None:
        for event in self.sleepers:
            event.set()

    def _be_missed(self) -> None:
        for context in self.contexts:
            context.leave(not self.world.finished)


def state() -> State:
    """The state of the calling process. Raises RuntimeError outside a run."""
    return current_world().part(State)


class RclContext:
    """What rcl keeps of a context: see :class:`Context`."""

    def __init__(self) -> None:
        self.state = state()
        self.logs = logging.logs()
        self.arguments: Arguments | None = None  # None: not initialised
        self.valid = False
        self.is_destroyed = False
        self.domain_id = 0
        self.nodes: list[RclNode] = []
        self.born: WeakKeyDictionary[RclNode, int] = WeakKeyDictionary()  # when (ns) each was made
        self.joined: int | None = None  # when (ns) its first node was made
        self.left: int | None = None  # from when (ns) other processes miss it
        self.leave: Callable[[bool], None] = lambda killed: None  # lets them miss it

    def check(self) -> None:
        """Raise InvalidHandle if it was destroyed."""
        if self.is_destroyed:
            raise InvalidHandle()

    def ok(self) -> bool:
        """Whether it was initialised and not shut down."""
        return self.valid

    def add_node(self, node: RclNode) -> None:
        """Add a node that was made in this context."""
        self.nodes.append(node)
        self.born[node] = self.state.clock.now()
        self.state.world.name = self.state.world.name or node.full_name
        self.state.world.nodes.append(node.full_name)

    def end(self) -> None:
        """End as at a signal: no hook is called."""
        self.valid = False
        self.leave(False)
        if self in self.state.contexts:
            self.state.contexts.remove(self)
        self.logs.is_over = not self.state.contexts


class Context:
    """What nodes share: the command line, and whether to continue. A ``with`` block begins and ends it."""

    def __init__(self) -> None:
        self._rosspin = RclContext()
        self._callbacks: list[Callable[[], Any]] = []

    @property
    def handle(self) -> Handle | None:
        """Its handle, which can be held and nothing else; None before ``init``."""
        return None if self._rosspin.arguments is None else Handle(self._rosspin)

    def init(
        self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        """Begin, with a command line (default: the process's). ``domain_id`` has no effect, as there is no network.

        Raises RuntimeError if it was called before, RCLError and UnknownROSArgsError for what follows ``--ros-args``,
        UnicodeEncodeError for a word that is no text.
        """
        own = self._rosspin
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
        if own.arguments is not None:
            raise RuntimeError("Context.init() must only be called once")
        words = own.state.world.argv if args is None else args
        for word in words:
            word.encode()  # the real one passes it on to C++
        try:
            arguments = Arguments(words)
        except RCLError:
            logging.get_logger("rcl").error("Failed to parse global arguments")
            raise
        if initialize_logging:
            logging.configure(arguments)
        own.arguments = arguments
        own.valid = True
        own.domain_id = domain_id or 0
        own.state.contexts.append(own)
        own.logs.is_over = False

    def ok(self) -> bool:
        """Whether it was initialised and not shut down. Raises InvalidHandle if it was destroyed."""
        self._rosspin.check()
        return self._rosspin.valid

    def shutdown(self) -> None:
        """End, and call the hooks. Raises RuntimeError before ``init``, RCLError if it has ended, as by a signal."""
        if self._rosspin.arguments is None:
            raise RuntimeError("Context must be initialized before it can be shutdown")
        self._rosspin.check()
        if not self._rosspin.valid:
            raise RCLError("failed to shutdown: rcl_shutdown already called on the given context")
        self.try_shutdown()

    def try_shutdown(self) -> None:
        """End, and call the hooks, unless it has ended. Raises InvalidHandle if it was destroyed."""
        own = self._rosspin
        own.check()
        if watcher := own.state.world.recording.watcher:
            has = "" if own.valid else ", which the signal has done already"
            watcher.says(f"shuts rclpy down{has}.")
        if not own.valid:
            return
        own.end()
        if own.logs.is_over and own.logs.rosout:
            own.logs.rosout.clear()
        for hook in self._callbacks:
            # Methods are kept as weak references. rclpy calls every hook as if it were one, and then what that returns.
            # The list shrinks when a hook takes the object of an earlier one with it: so rclpy misses the next.
            found = hook()
            if found is not None:
                found()
        self._callbacks = []

    def destroy(self) -> None:
        """End, and raise InvalidHandle at each further question."""
        if self._rosspin.arguments is not None:
            self._rosspin.end()
            self._rosspin.is_destroyed = True

    def on_shutdown(self, callback: Callable[[], Any]) -> None:
        """Call ``callback`` at ``shutdown``, or immediately after it. Raises TypeError if it cannot be called.

        It is not called when a signal ends the context (rclpy issue 1148). Raises InvalidHandle if it was destroyed.
        """
        if not callable(callback):
            raise TypeError("callback should be a callable, got {}", type(callback))
        self._rosspin.check()
        if self._rosspin.arguments is not None and not self._rosspin.valid:
            callback()
        elif ismethod(callback):
            self._callbacks.append(WeakMethod(callback, self._callbacks.remove))
        else:
            self._callbacks.append(callback)

    def get_domain_id(self) -> int:
        """The number of its ROS domain. Raises RCLError after it has ended."""
        if self._rosspin.arguments is None:
            raise RuntimeError("Context must be initialized before it can have a domain id")
        self._rosspin.check()
        if not self._rosspin.valid:
            raise RCLError("Failed to get domain id: error not set")
        return self._rosspin.domain_id

    def __enter__(self) -> Context:
        self.init()
        return self

    def __exit__(self, *error: object) -> None:
        self.try_shutdown()


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return the context that is used where none is given. With ``shutting_down``, the next call makes a new one."""
    own = state()
    if own.default is None:
        own.default = Context()
    context = own.default
    if shutting_down:
        own.default = None
    return context
