"""Simulated time: a heap of wake-ups of suspended stacks. Time jumps to the next wake-up, or is paced.

Nothing runs in parallel and nothing waits: a stack runs until it sleeps or waits for another, then the stack that is
due next continues, and the time is what that stack was waiting for. Of several due at the same time, the one that began
to wait first goes first, so that the same run gives the same result every time.
"""

from __future__ import annotations

import contextlib
import io
import sys
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from heapq import heapify, heappop, heappush
from itertools import count, islice
from sys import modules
from typing import Any

from .clock import NS
from .ending import ending_here
from .frames import Place, places, trail
from .loops import put_aside, put_back
from .stacks import Program, Stack, StackExit, Switched, current, telling_no_turns

__all__ = ["FROM_OUTSIDE", "LAST", "PacedSimulation", "Simulation", "Standstill"]

# This many wake-ups in a row without the time moving mean a loop that never sleeps: ten thousand threads that begin,
# meet and end at one time take a tenth of them.
STANDSTILL = 1_000_000

# Added to a wake-up's order, the first makes it the last at its time; the second marks a pause, which comes even later.
LAST = 1 << 61
FROM_OUTSIDE = 1 << 60  # of what a test does: last of all that a run does by itself
_PAUSE = 1 << 62

_IN_PAGE = sys.platform == "emscripten"

# How many stacks a run may have, at some 13 KB each. A page has less room, and needs seconds to begin 1,000. A computer
# has room for some 30,000 threads.
MOST_STACKS = 400 if _IN_PAGE else 20_000

# A run whose time does not move on by this much (ns) within seconds of real time will not end.
_LEAST_STEP = 1_000_000

# For how many stacks, the newest, a simulation notes where they were when an exception ended it.
_SHOWN = 10

# The first thread's ident; the operating system gives none like it.
_FIRST_IDENT = 1 << 32

# Stacks that could not be ended. Kept, because dropping the last reference would throw into them once more.
_abandoned: list[Stack] = []


class Standstill(Exception):
    """The time does not move on. ``places`` is where the running stack was, innermost first.

    ``place`` is the line that started that stack. ``threads`` is how many threads there were, if they were too many.
    """

    def __init__(self, places: list[Place], place: str, threads: int = 0) -> None:
        super().__init__()
        self.places = places
        self.place = place
        self.threads = threads


@contextmanager
def _unlimited() -> Iterator[Callable[[], bool]]:
    yield lambda: False


class Simulation:
    """A clock on which sleeping takes no time. ``now`` and ``sleep`` are as in :class:`rosspin.clocks.clock.Clock`.

    It begins at ``start`` (ns). The system's clock is ``ahead`` of it by so many ns, once someone has set that.

    From outside, ``run`` it; or ``begin`` it and ``advance`` it in steps, until it ``is_over`` or you ``close`` it.
    ``now``, ``at``, ``pause``, ``wake`` and ``interrupt`` also work from outside. The rest is for its stacks.
    """

    explores = False

    def __init__(self, start: int = 0) -> None:
        self._now = start
        self.ahead = 0
        self.is_late = False  # whether sleeps end later than they should
        self._heap: list[tuple[int, int, Stack]] = []
        # Wake-ups in their order. Many timers' come in this order, and what does needs no heap.
        self._row: deque[tuple[int, int, Stack]] = deque()
        self._order = 0  # the number of the newest wake-up; of two at one time, the smaller goes first
        self._cancelled: set[int] = set()  # wake-ups in the heap that are not to happen
        self._last_move = 0
        self._home: Switched = current()
        self._stacks: dict[Stack, None] = {}  # those that have not ended, in the order of their beginning
        self._most = 0  # how many there were at a time, in a page
        self.beside = 0  # grows while a stack waits for a program that computes meanwhile
        self._idents = count(_FIRST_IDENT)
        self._pauses = 0  # how many were asked for; only the newest ends a step
        self._paused = False
        self._closed = False
        self._to_end: list[tuple[Program, Stack | None]] = []  # what end() was asked for, and the stack that continues
        # Makes a context in which stacks are ended; it yields a function that says whether the time for that is up.
        self.taking_down: Callable[[], AbstractContextManager[Callable[[], bool]]] = _unlimited
        self.main: Stack
        self.failed = ""  # the line that started the stack that an exception ended
        self.left: list[Place] = []  # where some stacks were when an exception ended the run, the newest first

    def now(self) -> int:
        """The time, in ns."""
        return self._now

    def seconds(self) -> float:
        """The time, in s."""
        return self._now / NS

    def system(self) -> int:
        """What the system's clock tells, in ns."""
        return self._now + self.ahead

    def sign_of_life(self) -> int:
        """Return a number that changes when the time moves on.

        In a page, where stacks are slow to begin, it also changes when there are more of them than ever before, and it
        does while a stack waits for such a program.
        """
        return self._now // _LEAST_STEP + self._most + self.beside

    def horizon(self) -> int:
        """Return when (ns) the next stack is due. Until then, the one that is running is alone."""
        if self.is_late or self._closed:
            return self._now
        self._drop_cancelled()
        return min((entries[0][0] for entries in (self._heap, self._row) if entries), default=self._now)

    def sleep(self, ns: int) -> None:
        """Suspend the caller for ``ns`` nanoseconds; others run meanwhile. 0 or less only lets others run."""
        if self._cancelled or self._closed:
            self._drop_cancelled()
        me = current()
        now = self._now
        wake = now + ns if ns > 0 else now
        self._order = order = self._order + 1
        due: Any = (wake, order, me)
        heap, row = self._heap, self._row
        if not row or wake >= row[-1][0]:
            row.append(due)
        else:
            if len(row) < 2 or wake >= row[-2][0]:
                row[-1], due = due, row[-1]  # the one that comes long after all others keeps none out
            heappush(heap, due)
        due = heappop(heap) if heap and heap[0] < row[0] else row.popleft()
        when, _, stack = due
        if when > now:
            self._now = when
            self._last_move = order
        elif order - self._last_move > STANDSTILL:
            self._stand_still(me)
        if stack is not me:
            if "asyncio.events" in modules and (running := put_aside()):
                try:
                    self._switch_to(due)
                finally:
                    put_back(running)
            elif stack:
                stack.switch()
            else:
                self._switch_to(due)
        if me.interrupt:  # type: ignore[attr-defined]
            self._handle_interrupt(me)  # type: ignore[arg-type]
            # As after a signal (PEP 475), the rest of the sleep is still to come.
            if self._now < wake:
                self.sleep(wake - self._now)

    def be_late(self, draw: Callable[[], int]) -> None:
        """Let each sleep, and each wait with a limit, end ``draw()`` ns later than it should."""
        # Methods are replaced, since to ask in each sleep would cost all runs a part of a tick.
        sleep, wait = self.sleep, self.wait
        self.is_late = True
        self.sleep = lambda ns: sleep(ns + draw() if ns > 0 else ns)  # type: ignore[method-assign]
        self.wait = lambda ns=None: wait(ns + draw() if ns and ns > 0 else ns)  # type: ignore[method-assign]

    def choose(self, options: Sequence[str]) -> int:
        """See :class:`rosspin.clocks.clock.Clock`."""
        return 0

    def give_way(self) -> None:
        """See :class:`rosspin.clocks.clock.Clock`."""

    def wait(self, ns: int | None = None) -> bool:
        """Suspend the caller until another stack wakes it, for at most ``ns`` nanoseconds. Returns whether one did."""
        me = current()
        assert isinstance(me, Stack)
        until = None if ns is None else self._now + ns
        me.waits = True
        while True:
            if until is not None:
                me.ticket = self._schedule(until, me)
            try:
                self._go_on(me)
                me.ticket = 0
                if me.interrupt:
                    self._handle_interrupt(me)
                    if me.waits and (until is None or self._now < until):
                        continue
            except BaseException:
                me.waits = False
                raise
            woken, me.waits = not me.waits, False
            return woken

    def wake(self, stack: Stack) -> None:
        """Let a waiting stack continue."""
        if stack.waits:
            stack.waits = False
            # A stack that is running, in a signal handler, continues by itself.
            if not stack.resumed and stack is not current():
                self._resume(stack)

    def start(self, function: Callable[[], object], program: Program, place: str) -> Stack:
        """Run ``function`` on a stack of its own, beginning when the caller gives way."""
        if self._closed:
            self._home.switch()  # a stack that is being ended starts nothing
        if len(self._stacks) >= MOST_STACKS:
            self._stand_still(current(), threads=len(self._stacks))
        stack = self._stack(function, program, next(self._idents), place)
        if _IN_PAGE:
            self._most = max(self._most, len(self._stacks))
        self._schedule(self._now, stack)
        return stack

    def end(self, program: Program, spare_me: bool = True) -> None:
        """End all stacks of a program, wherever they are; the caller's, too, unless ``spare_me``."""
        me = current()
        assert isinstance(me, Stack)
        self._to_end.append((program, me if spare_me or me.own_program is not program else None))
        self._home.switch()

    def at(self, when: int, function: Callable[[], object]) -> None:
        """Call ``function`` at the time ``when`` (ns), after everything that falls due then."""
        self._order += 1
        stack = self._stack(function, Program(), 0, "")
        heappush(self._heap, (when, LAST + self._order, stack))

    def soon(self, function: Callable[[], object]) -> None:
        """Call ``function`` now, after all stacks that are due."""
        self._order += 1
        heappush(self._heap, (self._now, FROM_OUTSIDE + self._order, self._stack(function, Program(), 0, "")))

    def interrupt(self, stack: Stack, handler: Callable[[], None]) -> None:
        """Call ``handler`` on a suspended stack, as a signal handler: its sleep, or its wait, continues afterwards."""
        if not stack.resumed:
            if not stack.waits:
                self._keep(lambda stack: True)  # now all are in the heap
                pending = (order for _, order, each in self._heap if each is stack)
                stack.ticket = next(pending, 0)
            self._resume(stack)
        self.interrupt_later(stack, handler)
        stack.resumed = True

    def interrupt_later(self, stack: Stack, handler: Callable[[], None]) -> None:
        """Do the same without waking the stack: ``handler`` is called when it continues by itself."""
        earlier = stack.interrupt

        def both() -> None:
            if earlier:
                earlier()
            handler()

        stack.interrupt = both

    def run(self, main: Callable[[], object], program: Program, ident: int) -> None:
        """``begin``, and ``advance`` to the end."""
        self._home = current()
        self.begin(main, program, ident)
        self.advance()

    def begin(self, main: Callable[[], object], program: Program, ident: int) -> None:
        """Let ``main`` run in the steps to come, on a stack of its own; ``ident`` is the thread's."""
        self.begin_beside(main, program, ident)
        self.main = program.main

    def begin_beside(self, main: Callable[[], object], program: Program, ident: int) -> None:
        """Run ``main`` as the main stack of another program, beginning when the caller gives way."""
        program.main = self._stack(main, program, ident, "")
        self._schedule(self._now, program.main)

    def advance(self, until: int | None = None) -> None:
        """Continue until all that is due by ``until`` (ns) has run, or until ``main`` has returned.

        If ``main`` has returned, or anything is raised, the simulation is over, and all other stacks are ended. Raises
        what ``main`` raises, :class:`Standstill`, and RuntimeError if no stack can continue, or in another thread.
        """
        if current() is not self._home:
            raise RuntimeError("a node can continue only in the thread that started it")
        if until is not None:
            self._pause_at(until)
        self._paused = False
        try:
            with ending_here():
                while not (self.main.dead or self._paused):
                    if self._to_end:
                        self._end(*self._to_end.pop())
                        continue
                    due = self._next()
                    if due is None:
                        raise RuntimeError(f"nothing is left to happen at {self.seconds()} s, and the node still waits")
                    due[2].switch()
        except BaseException:
            newest = islice(reversed(self._stacks), _SHOWN)
            self.left = [place for stack in (*newest, self.main) if stack for place in places(stack.trail)]
            self.close()
            raise
        if self.main.dead:
            self.close()

    def pause(self) -> None:
        """Let ``advance`` return as soon as all that is due now has run."""
        self._pause_at(self._now)

    def _pause_at(self, when: int) -> None:
        self._pauses = this = self._pauses + 1

        def pause() -> None:
            self._paused = this == self._pauses

        self._order += 1
        heappush(self._heap, (when, _PAUSE + self._order, self._stack(pause, Program(), 0, "")))

    @property
    def is_over(self) -> bool:
        """Whether nothing more can happen."""
        return self._closed

    def heeding_signals(self, program: Program) -> AbstractContextManager[None]:
        """Return a context in which signals that come from outside are for a program: in simulated time none are."""
        return contextlib.nullcontext()

    def suspended(self) -> list[Stack]:
        """The stacks that have begun and not ended, in the order of their beginning."""
        return [stack for stack in self._stacks if stack]

    def _handle_interrupt(self, me: Stack) -> None:
        handler, me.interrupt, me.resumed = me.interrupt, None, False
        assert handler
        handler()

    def _resume(self, stack: Stack) -> None:
        """Schedule a stack for now, even if it is in the heap for later."""
        if stack.ticket:
            self._cancelled.add(stack.ticket)
            stack.ticket = 0
            if len(self._cancelled) > 1000 + len(self._heap) // 2:
                self._keep(lambda stack: True)
        self._schedule(self._now, stack)

    def _keep(self, is_wanted: Callable[[Stack], bool]) -> None:
        """Drop wake-ups that are cancelled, or of stacks that are not wanted."""
        cancelled, entries = self._cancelled, [*self._heap, *self._row]
        self._heap[:] = [entry for entry in entries if entry[1] not in cancelled and is_wanted(entry[2])]
        heapify(self._heap)
        self._row.clear()
        cancelled.clear()

    def _drop_cancelled(self) -> None:
        """Drop cancelled wake-ups from the front of the heap. When all is over, go home for good."""
        if self._closed and current() is not self._home:
            self._home.switch()
        heap, cancelled = self._heap, self._cancelled
        while heap and heap[0][1] in cancelled:
            cancelled.remove(heappop(heap)[1])

    def _next(self) -> tuple[int, int, Stack] | None:
        """Take the next wake-up off the heap and move the time on to it; None if there is none."""
        if self._cancelled or self._closed:
            self._drop_cancelled()
        heap, row = self._heap, self._row
        if not (heap or row):
            return None
        due = row.popleft() if row and not (heap and heap[0] < row[0]) else heappop(heap)
        if due[0] > self._now:
            self._move(due[0])
        elif self._order - self._last_move > STANDSTILL:
            self._stand_still(due[2])
        return due

    def _go_on(self, me: Stack) -> None:
        """Continue with the stack that is due next."""
        due = self._next()
        if due and due[2] is me:
            return
        if "asyncio.events" in modules and (running := put_aside()):
            try:
                self._switch_to(due)
            finally:
                put_back(running)
        else:
            self._switch_to(due)

    def _switch_to(self, due: tuple[int, int, Stack] | None) -> None:
        """Continue with the stack that is due, or at home if it is one that has not begun, or none."""
        if due and due[2]:
            due[2].switch()
        else:
            if due:
                # A stack begins as deep in calls as whatever starts it. Home starts them all: it never gets deeper.
                heappush(self._heap, due)
            self._home.switch()

    def _stand_still(self, me: Switched, threads: int = 0) -> None:
        self._home.throw(Standstill(places(trail(sys._getframe())), getattr(me, "place", ""), threads))

    def stand_still(self, place: Place) -> None:
        """End the run, as the calling stack waits for a program that computes at ``place`` without an end."""
        self._home.throw(Standstill([place], ""))

    def _move(self, when: int) -> None:
        self._now, self._last_move = when, self._order

    def _stack(self, function: Callable[[], object], program: Program, ident: int, place: str) -> Stack:
        def run() -> None:
            try:
                function()
            except BaseException:
                if not self._closed:
                    self.failed = place
                raise
            finally:
                self._stacks.pop(stack, None)

        stack = Stack(run, self._home, self, program, ident, place)
        self._stacks[stack] = None
        return stack

    def _schedule(self, when: int, stack: Stack) -> int:
        self._order += 1
        heappush(self._heap, (when, self._order, stack))
        return self._order

    def _end(self, program: Program, spared: Stack | None) -> None:
        """Do, from home, what ``end`` was asked for."""
        program.over = True
        self._throw_exit([stack for stack in self._stacks if stack.own_program is program and stack is not spared])
        self._closed = False
        for function in program.at_end:
            self.start(function, Program(), "")
        self._keep(lambda stack: stack.own_program is not program)
        if spared:
            spared.switch()

    def close(self) -> None:
        """End the stacks that are left."""
        self._throw_exit(list(self._stacks))
        self._heap.clear()
        self._row.clear()

    def _throw_exit(self, stacks: list[Stack]) -> None:
        """End stacks for good.

        What they print meanwhile is dropped: Python's daemon threads would just stop.
        """
        self._closed = True
        nowhere = io.StringIO()
        with telling_no_turns(), contextlib.redirect_stdout(nowhere), contextlib.redirect_stderr(nowhere):
            with self.taking_down() as is_time_over:
                for stack in stacks:
                    if not is_time_over():
                        try:
                            with ending_here():
                                stack.throw(StackExit)
                        except BaseException:
                            pass
                    if not stack.dead:
                        stack.waits = False  # no one can wake it
                        _abandoned.append(stack)
                    self._stacks.pop(stack, None)


class PacedSimulation(Simulation):
    """A simulation that does not jump: ``pace(when)`` is called before the time becomes ``when`` (ns)."""

    def __init__(self, pace: Callable[[int], None]) -> None:
        super().__init__()
        self._pace = pace

    def sleep(self, ns: int) -> None:
        wake = self._now + max(ns, 0)
        self._drop_cancelled()
        self._pace(min([wake, *(entries[0][0] for entries in (self._heap, self._row) if entries)]))
        super().sleep(ns)

    def _move(self, when: int) -> None:
        self._pace(when)
        super()._move(when)
