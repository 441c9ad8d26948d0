"""Orders of events other than the usual one.

A simulated run has one order of events, the same each time. Much of it is a convention of the clock: of several stacks
that are due at one instant, any might go first on a real computer. An :class:`Order` decides that, and other things
that ROS leaves open, for an :class:`ExploredSimulation`; and it is known by where it deviates from the usual order.
"""

from __future__ import annotations

import re
import sys
import threading
from collections.abc import Callable, Hashable, Mapping, Sequence
from heapq import heappop, heappush
from typing import Any, NamedTuple

from .frames import node_place, places
from .simulation import LAST, STANDSTILL, Simulation
from .stacks import Stack, current

__all__ = ["Decide", "Deviation", "ExploredSimulation", "Order", "Turn", "name_of"]

# A token: the version of what is counted, whether inside of lines too, and where and how the order deviates.
_VERSION = 1
_TOKEN = re.compile(r"(\d+)(d?)((?:-\d+\.\d+)*)")

# So many wake-ups at one instant may pass over one that is due then; more would not be fair. On a real computer a
# thread that only looks again and again does not keep another one from its turn.
_PATIENCE = 200

Due = tuple[int, int, Stack]
"""A wake-up, as it is on a simulation's heap."""

Decide = Callable[[int, Sequence[Hashable]], int]
"""Is given the number of a point and what may be next there, the usual first. Returns the place of what is next."""


class Turn(NamedTuple):
    """A line that a thread runs: when (ns), the thread's name, the file and the line."""

    time: int
    thread: str
    filename: str
    line: int


class Deviation(NamedTuple):
    """Where an order deviates: when (ns), what would usually be next, and what is."""

    time: int
    usual: str
    here: str


class Order:
    """Decides at each point of a run, or of several in a row, what is next there: 0 is the usual.

    It deviates as ``deviations`` say, which map the numbers of points to choices, or as ``decide`` does. ``deep`` says
    that each value that a node looks up or calculates is followed by a point, if another of its threads is ready.
    """

    def __init__(self, deviations: Mapping[int, int] | None = None, decide: Decide | None = None, deep: bool = False):
        self.deep = deep
        self.options: list[int] = []  # how many there were at each point
        self.made: dict[int, int] = {}  # its deviations so far
        self.turns: list[Turn] | None = None  # the lines that are run, if they are wanted
        self.said: list[Deviation] = []  # the deviations in words, if the turns are wanted
        self.planned = dict(deviations or {})
        self._decide = decide
        self._known: set[Hashable] = set()  # what there was to choose among

    @classmethod
    def of(cls, token: str) -> Order:
        """Read a token. Raises ValueError for anything else."""
        found = _TOKEN.fullmatch(token) if isinstance(token, str) else None
        if not found:
            raise ValueError(f"{token!r} is no schedule: one looks like 1-12.1, or 1d-12.1-40.2")
        version, deep, pairs = found.groups()
        if int(version) != _VERSION:
            raise ValueError(f"the schedule {token} is of another version of rosspin: explore again")
        points = [pair.partition(".") for pair in pairs.split("-")[1:]]
        return cls({int(point): int(choice) for point, _, choice in points}, deep=bool(deep))

    @property
    def token(self) -> str:
        """Its deviations so far, in one short line that :meth:`of` reads."""
        pairs = "".join(f"-{point}.{choice}" for point, choice in sorted(self.made.items()))
        return f"{_VERSION}{'d' * self.deep}{pairs}"

    def choose(self, options: Sequence[Hashable], now: int) -> int:
        """Return the place of what is next, at a time (ns)."""
        point = len(self.options)
        self.options.append(len(options))
        if self._decide:
            self._known.update(options)
            choice = self._decide(point, options)
        elif (choice := self.planned.get(point, 0)) >= len(options):
            choice = 0
        if choice:
            self.made[point] = choice
            if self.turns is not None:
                self.said.append(Deviation(now, _say(options[0]), _say(options[choice])))
        return choice

    def forget(self) -> int:
        """Forget what there was to choose among, which are the stacks of a run that is over, and say how many."""
        known, self._known, self._decide = len(self._known), set(), None
        return known

    def has_to_fit(self) -> None:
        """Raise ValueError unless it has deviated where it was to."""
        for point, choice in sorted(self.planned.items()):
            if self.made.get(point) != choice:
                at = f"{point}.{choice}"
                there = (
                    f"{self.options[point]} things can happen next"
                    if point < len(self.options)
                    else f"the run has only {len(self.options)} points at which the order is open"
                )
                raise ValueError(
                    f"the schedule does not fit, from {at} on: {there}. It is of another node, or other seconds, or "
                    "the node has changed: explore again"
                )


class ExploredSimulation(Simulation):
    """A simulation in which an order decides which of the stacks that are due at one instant goes on.

    It does so until Ctrl-C; what comes after that is in the usual order. Functions that were to be called ``at`` a time
    come after all stacks, as usual.
    """

    explores = True

    def __init__(self, order: Order, start: int = 0) -> None:
        super().__init__(start)
        self.order = order
        self._due: list[Due] = []  # wake-ups that are due together, off the heap, in their usual order

    def sleep(self, ns: int) -> None:
        me = current()
        wake = self._now + max(ns, 0)
        self._schedule(wake, me)  # type: ignore[arg-type]
        self._go_on(me)  # type: ignore[arg-type]
        if me.interrupt:  # type: ignore[attr-defined]
            self._handle_interrupt(me)  # type: ignore[arg-type]
            if self._now < wake:
                self.sleep(wake - self._now)

    def choose(self, options: Sequence[str]) -> int:
        return self.order.choose(options, self._now) if self._is_open else 0

    def give_way(self) -> None:
        me, now = current(), self._now
        if self._closed or not isinstance(me, Stack):
            return
        self._collect(now)
        if not (self._due and self._is_open):
            return
        others = [entry for entry in self._due if entry[2].owner is me.owner]
        if others and not self._has_waited_enough(others[0]):
            if choice := self.order.choose([me, *(stack for _, _, stack in others)], now):
                self._due.remove(others[choice - 1])
                heappush(self._heap, _now(others[choice - 1]))
                self._schedule(now, me)
                self._go_on(me)
                if me.interrupt:
                    self._handle_interrupt(me)

    def _go_on(self, me: Stack) -> None:
        # Whichever loop of asyncio runs on this stack does so on no other, wherever the stack gives way.
        events: Any = None if sys.platform == "emscripten" else sys.modules.get("asyncio.events")
        if events is None or (loop := events._get_running_loop()) is None:
            super()._go_on(me)
            return
        events._set_running_loop(None)
        try:
            super()._go_on(me)
        finally:
            events._set_running_loop(loop)

    def interrupt(self, stack: Stack, handler: Callable[[], None]) -> None:
        self._put_back()
        super().interrupt(stack, handler)

    def close(self) -> None:
        super().close()
        self._due.clear()

    @property
    def _is_open(self) -> bool:
        return not (self._closed or self.main.owner.interrupted)

    def _next(self) -> Due | None:
        self._drop_cancelled()
        heap, due = self._heap, self._due
        if heap and heap[0][1] < 0:
            return super()._next()
        if due:
            when = due[0][0]
        elif len(heap) > 1 and heap[0][0] in (heap[1][0], heap[-1][0] if len(heap) == 2 else heap[2][0]):
            when = heap[0][0]
        else:
            return super()._next()
        self._collect(when)
        if not due:
            return super()._next()
        choice = 0
        if len(due) > 1 and self._is_open and not self._has_waited_enough(due[0]):
            choice = self.order.choose([stack for _, _, stack in due], when)
        chosen = due.pop(choice)
        if when > self._now:
            self._move(when)
        elif self._order - self._last_move > STANDSTILL:
            self._stand_still(chosen[2])
        return chosen if chosen[2] else _now(chosen)

    def _collect(self, when: int) -> None:
        """Take the wake-ups of stacks that are due at a time off the heap."""
        heap, due, cancelled = self._heap, self._due, self._cancelled
        while heap and heap[0][0] == when and heap[0][1] < LAST:
            due.append(heappop(heap))
        if cancelled:
            gone = [entry for entry in due if entry[1] in cancelled]
            for entry in gone:
                due.remove(entry)
                cancelled.remove(entry[1])

    def _put_back(self) -> None:
        for entry in self._due:
            heappush(self._heap, entry)
        self._due.clear()

    def _keep(self, is_wanted: Callable[[Stack], bool]) -> None:
        self._put_back()
        super()._keep(is_wanted)

    def _has_waited_enough(self, due: Due) -> bool:
        return due[0] == self._now and self._order - max(due[1], self._last_move) > _PATIENCE + 2 * len(self._heap)


def _now(due: Due) -> Due:
    """Change a wake-up so that it is the next one on the heap, and nothing more is chosen before."""
    return due[0], -1, due[2]


def name_of(stack: Stack) -> str:
    """The name of a thread, of several nodes after its node's; of a main one, that of its node or file."""
    owner = stack.owner
    node = owner.name or owner.file
    if stack is owner.main:
        return node or "MainThread"
    thread = threading._active.get(stack.ident) or owner.active.get(stack.ident)  # type: ignore[attr-defined]
    name = str(thread.name) if thread else "a thread"
    return name if owner.main is stack.clock.main or not node else f"{node}: {name}"


def _say(option: Hashable) -> str:
    if not isinstance(option, Stack):
        return str(option)
    place = None if option is current() else node_place(places(option.trail))
    return f"{name_of(option)} in line {place.line}" if place else name_of(option)
