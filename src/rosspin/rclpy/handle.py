"""The handles of nodes and of what they make (source: rclpy/src/rclpy/destroyable.cpp), and how long those are there.

Behind each object of rclpy there is one of rcl's. It is there until it is destroyed, or until nothing refers to the
object in Python any more. Here, :class:`Life` is what notices that.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol
from weakref import ref

from ..world.world import NotSimulated
from .exceptions import InvalidHandle

if TYPE_CHECKING:
    from .arguments import Arguments
    from .context import RclContext
    from .endpoints import Endpoint
    from .executors import Executor
    from .node import Node

__all__ = ["Handle", "Held", "Life", "RclNode"]


class _Checked(Protocol):
    def check(self) -> None:
        """Raise InvalidHandle if it was destroyed."""


class Handle:
    """Stands for the C++ object behind a node, a timer and so on. A node can hold it: ``with timer.handle:``.

    ``held.check()`` raises InvalidHandle if the object was destroyed. All else that a handle has raises NotSimulated.
    """

    def __init__(self, held: _Checked, life: Life | None = None) -> None:
        self._rosspin = held
        self._rosspin_life = life  # which the handle keeps, too

    def __enter__(self) -> None:
        self._rosspin.check()

    def __exit__(self, *error: object) -> None:
        """Let it go."""

    def __getattr__(self, name: str) -> Any:
        raise NotSimulated(f"handle.{name}")


class Life:
    """Calls ``end()`` when nothing refers to it any more. ``end`` must not refer to whoever holds it."""

    __slots__ = ("_end",)

    def __init__(self, end: Callable[[], None]) -> None:
        self._end = end

    def __del__(self) -> None:
        self._end()


class Held:
    """Base of timers and guard conditions, of which others know nothing."""

    _rosspin_destroyed = False

    @property
    def handle(self) -> Handle:
        """Its handle, which can be held and nothing else."""
        return Handle(_Checking(self._rosspin_check))

    def _rosspin_check(self) -> None:
        if self._rosspin_destroyed:
            raise InvalidHandle()


class _Checking(NamedTuple):
    check: Callable[[], None]


def _nobody() -> None:
    return None


class RclNode:
    """What rcl keeps of a node (source: rcl/node.c). Others know it until ``release`` was called for each user.

    Its users are the Node, until that is destroyed or gone, and each endpoint of a topic or service that it has made.
    """

    def __init__(self, node: Node, context: RclContext, name: str, namespace: str, arguments: list[Arguments]) -> None:
        self.context = context
        self.name = name
        self.namespace = namespace
        self.full_name = f"{namespace.rstrip('/')}/{name}"
        self.logger_name = self.full_name[1:].replace("/", ".")
        self.arguments = arguments
        self.endpoints: list[Endpoint] = []
        self.node: Callable[[], Node | None] = ref(node)
        self.executor: Callable[[], Executor | None] = _nobody  # to which the node was last added
        self.is_destroyed = False
        self.describes = False  # whether it has the service that describes types
        self.topics: Any = None  # those on which every node publishes
        self.at_end: list[Callable[[], None]] = []
        self._users = 1
        self._is_gone = False

    def check(self) -> None:
        """Raise InvalidHandle if the node was destroyed."""
        if self.is_destroyed:
            raise InvalidHandle()

    def use(self) -> None:
        """Have another user."""
        self._users += 1

    def release(self) -> None:
        """Have one user less; without any, it is gone."""
        self._users -= 1
        if self._users == 0 and not self._is_gone:
            self._is_gone = True
            if self in self.context.nodes:
                self.context.nodes.remove(self)
            for function in self.at_end:
                function()

    def destroy(self) -> None:
        """Release it for the Node, once."""
        if not self.is_destroyed:
            self.is_destroyed = True
            self.release()

    def nudge(self) -> None:
        """Let the executor look again: something may have become due."""
        if executor := self.executor():
            executor._rosspin_nudge()
