"""Orders of events other than the usual one.

A simulated run has one order of events, the same each time. Much of it is a convention of the clock: of several stacks
that are due at one instant, any might go first on a real computer. An :class:`Order` decides that, and other things
that ROS leaves open, for an :class:`ExploredSimulation`; and it is known by where it deviates from the usual order.
"""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Hashable, Mapping, Sequence
from heapq import heappop, heappush
from typing import NamedTuple

from .frames import node_place, places
from .simulation import LAST, STANDSTILL, Simulation
from .stacks import Program, Stack, current

__all__ = ["Decide", "Deviation", "ExploredSimulation", "Order", "Turn", "name_of"]

# A token: the version of what is counted, whether inside of lines too, and where and how the order deviates. A ``t``
# comes before the number of a point at which a test continues first.
_VERSION = 1
_TOKEN = re.compile(r"(\d+)(d?)((?:-t?\d+\.\d+)*)")

# So many wake-ups at one instant may pass over one that is due then; more would not be fair. On a real computer a
# thread that only looks again and again does not keep another one from its turn.
_PATIENCE = 200

# What comes instead of a stack if a test continues before it.
_TEST = "the test"

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
        self.acts: set[int] | None = None  # the steps of a test after which it may act early; None: all of them
        self.acted: set[int] = set()  # those after which it did something to a node, before it looked at anything
        self._steps = 0
        self._test_steps: list[int] = []  # the steps at whose end the test could continue first, once for each time
        self._unseen: int | None = None  # the newest step, unless the test has looked at what came of it
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
        return cls({int(point.replace("t", "-")): int(choice) for point, _, choice in points}, deep=bool(deep))

    @property
    def token(self) -> str:
        """Its deviations so far, in one short line that :meth:`of` reads."""
        pairs = "".join(f"-{_name(point)}.{choice}" for point, choice in sorted(self.made.items()))
        return f"{_VERSION}{'d' * self.deep}{pairs}"

    def begin_step(self, is_looked_at: bool) -> None:
        """A test lets the time of a node pass; ``is_looked_at`` says whether it takes what that returns."""
        self._steps += 1
        self._unseen = None if is_looked_at else self._steps

    def note_look(self) -> None:
        """A test looks at a node: nothing that is due may be left for later."""
        self._unseen = None

    def note_act(self) -> None:
        """A test does something to a node."""
        if self._unseen is not None:
            self.acted.add(self._unseen)

    @property
    def test_points(self) -> list[int]:
        """The points of a test's steps at which the test, too, may be next: below 0, the first of them is -1."""
        steps = self.acted if self.acts is None else self.acts
        return [-number for number, step in enumerate(self._test_steps, 1) if step in steps]

    def lets_test_go_on(self, due: Hashable, now: int) -> bool:
        """Whether a test continues at a time (ns) before something that is due then, the end of its step."""
        self._test_steps.append(self._steps)
        point = -len(self._test_steps)
        if self._decide:
            is_open = self.acts is not None and self._steps in self.acts
            choice = self._decide(point, [due, _TEST]) if is_open else 0
        else:
            choice = self.planned.get(point, 0)
        return self._note(point, choice, [due, _TEST], now) == 1

    def choose(self, options: Sequence[Hashable], now: int) -> int:
        """Return the place of what is next, at a time (ns)."""
        point = len(self.options)
        self.options.append(len(options))
        if self._decide:
            self._known.update(options)
            choice = self._decide(point, options)
        elif (choice := self.planned.get(point, 0)) >= len(options):
            choice = 0
        return self._note(point, choice, options, now)

    def _note(self, point: int, choice: int, options: Sequence[Hashable], now: int) -> int:
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
                at = f"{_name(point)}.{choice}"
                there = (
                    f"a test's step has {len(self._test_steps)} points at which the test could continue first"
                    if point < 0
                    else f"{self.options[point]} things can happen next"
                    if point < len(self.options)
                    else f"the run has only {len(self.options)} points at which the order is open"
                )
                raise ValueError(
                    f"the schedule does not fit, from {at} on: {there}. It is of another node, or other seconds, or "
                    "the node has changed: explore again"
                )


class ExploredSimulation(Simulation):
    """A simulation in which an order decides which of the stacks that are due at one instant continues.

    It does so until Ctrl-C; what comes after that is in the usual order. Functions that should be called ``at`` a time
    come after all stacks, as usual.
    """

    explores = True

    def __init__(self, order: Order, start: int = 0) -> None:
        super().__init__(start)
        self.order = order
        self._due: list[Due] = []  # wake-ups that are due together, off the heap, in their usual order
        self.in_steps = False  # whether a test lets it continue: at the end of a step, that may continue first
        self._until: int | None = None

    def advance(self, until: int | None = None) -> None:
        self._until = until if self.in_steps else None
        super().advance(until)

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
        others = [entry for entry in self._due if entry[2].own_program is me.own_program]
        if others and not self._has_waited_enough(others[0]):
            if choice := self.order.choose([me, *(stack for _, _, stack in others)], now):
                self._due.remove(others[choice - 1])
                heappush(self._heap, _now(others[choice - 1]))
                self._schedule(now, me)
                self._go_on(me)
                if me.interrupt:
                    self._handle_interrupt(me)

    def interrupt(self, stack: Stack, handler: Callable[[], None]) -> None:
        self._put_back()
        super().interrupt(stack, handler)

    def close(self) -> None:
        super().close()
        self._due.clear()

    @property
    def _is_open(self) -> bool:
        return not (self._closed or self.main.own_program.interrupted)

    def _next(self) -> Due | None:
        self._drop_cancelled()
        heap, due = self._heap, self._due
        if heap and heap[0][1] < 0:
            return super()._next()
        if due:
            when = due[0][0]
        elif heap and heap[0][0] == self._until:
            when = self._until
        elif len(heap) > 1 and heap[0][0] in (heap[1][0], heap[-1][0] if len(heap) == 2 else heap[2][0]):
            when = heap[0][0]
        else:
            return super()._next()
        self._collect(when)
        if not due:
            return super()._next()
        choice = 0
        if self._is_open and not self._has_waited_enough(due[0]):
            if when == self._until and self.order.lets_test_go_on(due[0][2], when):
                choice = -1
            elif len(due) > 1:
                choice = self.order.choose([stack for _, _, stack in due], when)
        chosen = self._end_of_step(when) if choice < 0 else due.pop(choice)
        if when > self._now:
            self._move(when)
        elif self._order - self._last_move > STANDSTILL:
            self._stand_still(chosen[2])
        return chosen if chosen[2] else _now(chosen)

    def _end_of_step(self, when: int) -> Due:
        """Return what ends a step before all that is due has run."""

        def pause() -> None:
            self._paused = True

        return when, -1, self._stack(pause, Program(), 0, "")

    def _collect(self, when: int) -> None:
        """Take the wake-ups of stacks that are due at a time off the heap."""
        heap, due, cancelled = self._heap, self._due, self._cancelled
        before = len(due)
        while heap and heap[0][0] == when and heap[0][1] < LAST:
            due.append(heappop(heap))
        if before and due[before - 1][1] > due[-1][1]:
            due.sort()  # what a test has done comes last
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


def _name(point: int) -> str:
    return f"t{-point}" if point < 0 else str(point)


def _now(due: Due) -> Due:
    """Change a wake-up so that it is the next one on the heap, and nothing more is chosen before."""
    return due[0], -1, due[2]


def name_of(stack: Stack) -> str:
    """The name of a thread, of several nodes after its node's; a main one has its node's or file's."""
    program = stack.own_program
    node = program.name or program.file
    if stack is program.main:
        return node or "MainThread"
    thread = threading._active.get(stack.ident) or program.active.get(stack.ident)  # type: ignore[attr-defined]
    name = str(thread.name) if thread else "a thread"
    return name if program.main is stack.clock.main or not node else f"{node}: {name}"


def _say(option: Hashable) -> str:
    if not isinstance(option, Stack):
        return str(option)
    place = None if option is current() else node_place(places(option.trail))
    return f"{name_of(option)} in line {place.line}" if place else name_of(option)
