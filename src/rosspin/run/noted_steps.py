"""What a run does, step by step, for a page; and of ROS 1 what its threads do: each calls its own callbacks."""

from __future__ import annotations

import inspect
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, MutableMapping
from types import CodeType
from typing import Any

from ..clocks.clock import NS
from ..clocks.explored import name_of
from ..clocks.frames import trail
from ..clocks.simulation import PacedSimulation
from ..clocks.stacks import Stack, Switched, current
from ..world.graph import TickLog
from ..world.watcher import Watcher

__all__ = ["NotedSteps", "NotedThreads", "code_of"]

# How many steps are kept, the first ones, and of a node with how many callbacks at most.
_MOST = 300
_MOST_CALLBACKS = 30


class NotedSteps(Watcher):
    """The steps of a run, in which a step is noted whenever something is told or the time passes.

    The run has to be on :attr:`clock`, and to record its ticks in ``log``. Lines are of the file ``filename``.
    ``pace(when)`` is called before the time becomes ``when`` (ns). Of ``several`` nodes, each is named.
    """

    def __init__(
        self, log: TickLog, filename: str, pace: Callable[[int], object] = lambda when: None, several: bool = False
    ) -> None:
        log.watcher = self
        self.clock = PacedSimulation(self._before)
        self._filename = filename
        self._pace = pace
        self._several = several
        self._callbacks: MutableMapping[Any, int] = {}  # timers and the like: their numbers
        self._names: list[tuple[str, int]] = []  # of the callbacks, with the numbers of their groups
        self._groups: dict[Any, tuple[int, str]] = {}
        self._threads: dict[Stack, tuple[int, str]] = {}
        self._steps: list[list[Any]] = []
        self._rings: list[dict[str, Any]] = []

    def data(self, status: int) -> dict[str, Any] | None:
        """Return what a page draws of a run that has ended with ``status``, ready for JSON: see web/src/protocol.js.

        It is None where nothing was told. A step is a time (s), a sentence, the ready ones in their order, of each
        thread its number, the callback in it (-1: none) and its line (0: none of the file), and how each callback is.
        """
        if not (self._steps or self._rings):
            return None
        end = "The rest is not shown." if self._is_full else f"The node has ended, with status {status}."
        steps = [*self._steps, [self.clock.seconds(), end, [], [], []]]
        return {
            "threads": [name for _, name in self._threads.values()],
            "groups": [name for _, name in self._groups.values()],
            "callbacks": self._names,
            "steps": steps,
            "rings": self._rings,
        }

    def rings(self, ring: dict[str, Any]) -> None:
        self._rings.append(ring)

    def says(self, words: str) -> None:
        if (here := self._here()) is not None:
            self._note(f"{here} {words}")

    def _here(self) -> str | None:
        """Return the name of the calling thread; None if what it does is no step, or there are enough of them."""
        if self._is_full or self.clock.is_over:
            return None
        stack = current()
        if self._several and isinstance(stack, Stack):
            return name_of(stack) if stack.own_program.tells else None
        return threading.current_thread().name

    @property
    def _is_full(self) -> bool:
        return len(self._steps) >= _MOST or len(self._names) > _MOST_CALLBACKS

    def _running(self) -> list[Any] | None:
        """Return what runs now; None as long as there is nothing to tell."""
        raise NotImplementedError()

    def _before(self, when: int) -> None:
        if when > self.clock.now() and not self._is_full and (running := self._running()) is not None:
            verb = "is" if len(running) == 1 else "are"
            is_told = all(stack.own_program.tells for stack in self.clock.suspended())
            what = "No callback runs" if is_told else "No callback in Python runs"
            if running:
                what = f"{self._say(running)} {verb} at work"
            self._note(f"{what} until {when / NS:g} s.", until=when)
        self._pace(when)

    def _note(self, said: str, line: int = 0, until: int = 0) -> None:
        """Note a step, after which nothing changes ``until`` then. ``line`` is the calling thread's, if it is known."""
        raise NotImplementedError()

    def _inside(self, thread: Switched) -> Any:
        """Return what runs in a thread."""
        raise NotImplementedError()

    def _where(self, here: int) -> Iterator[tuple[int, int, int]]:
        """Find for each thread its number, the callback in it and its line."""
        for stack in self.clock.suspended():
            if self._several:
                name = stack.own_program.tells and stack.own_program.name and name_of(stack)
            else:
                name = getattr(threading._active.get(stack.ident), "name", "")  # type: ignore[attr-defined]
            if not name:
                continue
            number, _ = self._threads.setdefault(stack, (len(self._threads), name))
            is_here = stack is current()
            frames = trail(sys._getframe()) if is_here else stack.trail
            line = next((line for code, _, line in frames if code.co_filename == self._filename), 0)
            inside = self._inside(stack)
            yield number, -1 if inside is None else self._callbacks.get(inside, -1), is_here and here or line

    def _say(self, entities: Iterable[Any]) -> str:
        """Name callbacks; a new one gets a number, and so does its group."""
        for entity in entities:
            if entity not in self._callbacks:
                key, group = self._group(entity)
                number, _ = self._groups.setdefault(key, (len(self._groups), group))
                name, names = self._name(entity), [name for name, _ in self._names]
                same = sum(other.partition(" #")[0] == name for other in names)
                self._callbacks[entity] = len(names)
                self._names.append((f"{name} #{same + 1}" if same else name, number))
        return ", ".join(self._names[self._callbacks[entity]][0] for entity in entities)

    def _group(self, entity: Any) -> tuple[Any, str]:
        """Return the group of a callback, and its name."""
        raise NotImplementedError()

    def _name(self, entity: Any) -> str:
        raise NotImplementedError()

    def _begin(self, callback: Any) -> int:
        """Return the line in the file where a callback begins; 0 if it is of another file."""
        code = code_of(callback)
        return code.co_firstlineno if code and code.co_filename == self._filename else 0


class NotedThreads(NotedSteps):
    """The steps of a run of ROS 1, where each timer, and each topic, calls back in a thread of its own."""

    def __init__(self, *args: Any, **more: Any) -> None:
        super().__init__(*args, **more)
        self._calls: dict[Switched, list[Any]] = {}  # by thread: the callbacks in it, the innermost last

    def data(self, status: int) -> dict[str, Any] | None:
        """Return the same as for ROS 2, without groups."""
        data = super().data(status)
        return data and data | {"groups": []}

    def calls(self, entity: Any, executor: Any = None, late: int = 0) -> None:
        if (here := self._here()) is not None:
            self._calls.setdefault(current(), []).append(entity)
            lateness = f", {late / NS:g} s late" if late else ""
            self._note(f"{here} calls {self._say([entity])}{lateness}.", self._begin(entity))

    def ends(self, entity: Any) -> None:
        if self._here() is not None:
            self._calls[current()].remove(entity)
            self._note(f"{self._say([entity])} ends.")

    def _running(self) -> list[Any] | None:
        return list(dict.fromkeys(callback for calls in self._calls.values() for callback in calls))

    def _note(self, said: str, line: int = 0, until: int = 0) -> None:
        running = self._running() or ()
        how = ["runs" if callback in running else "" for callback in self._callbacks]
        self._steps.append([self.clock.seconds(), said, [], list(self._where(line)), how])

    def _inside(self, thread: Switched) -> Any:
        return next(reversed(self._calls.get(thread, ())), None)

    def _group(self, entity: Any) -> tuple[Any, str]:
        return None, ""

    def _name(self, entity: Any) -> str:
        return str(getattr(entity, "__name__", type(entity).__name__))


def code_of(callback: Any) -> CodeType | None:
    """Return the code of a callback, also of a partial or wrapped one."""
    code: CodeType | None = getattr(inspect.unwrap(getattr(callback, "func", callback)), "__code__", None)
    return code
