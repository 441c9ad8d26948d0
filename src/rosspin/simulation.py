"""Simulated time: a heap of wake-ups over suspended stacks. Time jumps to the next one, or is paced.

Nothing runs in parallel and nothing waits: a stack runs until it sleeps, then the stack that is due next goes on, and
the time is what that stack was waiting for. Of several due at the same time, the one that fell asleep first goes first,
so that the same run gives the same result every time.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable
from contextvars import ContextVar
from heapq import heapify, heappop, heappush, heappushpop

from .stacks import Stack, StackExit, current

__all__ = ["PacedSimulation", "Simulation", "Standstill", "running"]

# The simulation whose stack this is; None outside of any.
running: ContextVar[Simulation | None] = ContextVar("running", default=None)

# So many wake-ups in a row without the time moving are a loop that never sleeps.
STANDSTILL = 100_000

# Added to its order, this makes a wake-up the last at its time.
_LAST = 1 << 62

# Stacks that could not be ended. Kept, because dropping the last reference would throw into them once more.
_abandoned: list[Stack] = []


class Standstill(Exception):
    """Stacks go on without the time moving. ``stack`` is what was running, outermost frame first, ``name`` its name."""

    def __init__(self, stack: traceback.StackSummary, name: str) -> None:
        super().__init__()
        self.stack = stack
        self.name = name


class Simulation:
    """A clock on which sleeping takes no time.

    ``now``, ``sleep``, ``start`` and ``condition`` are those of :class:`rosspin.clock.Clock`.
    """

    def __init__(self) -> None:
        self._now = 0
        self._heap: list[tuple[int, int, Stack]] = []
        self._sleeps = 0
        self._last_move = 0
        self._home = current()
        self._stacks: dict[Stack, str] = {}  # those that have not ended, and their names
        self._interrupts: dict[Stack, Callable[[], None]] = {}
        self._closed = False
        self.failed = ""  # the name of the stack that an exception ended

    def now(self) -> int:
        return self._now

    def sleep(self, ns: int) -> None:
        me = current()
        if self._closed:
            self._home.switch()
        now = self._now
        wake = now + ns if ns > 0 else now
        self._sleeps = order = self._sleeps + 1
        due = heappushpop(self._heap, (wake, order, me))
        when, _, stack = due
        if when > now:
            self._now = when
            self._last_move = order
        elif order - self._last_move > STANDSTILL:
            self._home.throw(Standstill(traceback.extract_stack(), self._stacks.get(me, "")))
        if stack is not me:
            if not stack:
                # A stack begins as deep in calls as what starts it. Only run() is never deeper than before.
                heappush(self._heap, due)
                stack = self._home
            stack.switch()
        if self._interrupts and me in self._interrupts:
            self._interrupts.pop(me)()
            # As after a signal (PEP 475), the rest of the sleep is still to come.
            if self._now < wake:
                self.sleep(wake - self._now)

    def start(self, function: Callable[[], None], name: str) -> None:
        self._schedule(self._now, self._stack(function, name))

    def condition(self) -> _Condition:
        return _Condition(self)

    def at(self, when: int, function: Callable[[], None]) -> None:
        """Call ``function`` at the time ``when`` (ns), after everything that falls due then."""
        self._sleeps += 1
        heappush(self._heap, (when, _LAST + self._sleeps, self._stack(function, "")))

    def wake(self, stack: Stack) -> None:
        """End the sleep of ``stack`` now."""
        self._heap[:] = [entry for entry in self._heap if entry[2] is not stack]
        heapify(self._heap)
        self._schedule(self._now, stack)

    def interrupt(self, stack: Stack, handler: Callable[[], None]) -> None:
        """Call ``handler`` on the sleeping ``stack``, as a signal handler: its sleep goes on afterwards."""
        self._interrupts[stack] = handler
        self.wake(stack)

    def run(self, main: Callable[[Stack], None]) -> None:
        """Run ``main``, which is given its own stack, and all that it starts, until ``main`` returns.

        Raises what ``main`` raises, :class:`Standstill`, and RuntimeError if no stack is left that could go on.
        """
        stack = self._stack(lambda: main(stack), "")
        self._home = current()
        self._schedule(self._now, stack)
        try:
            while not stack.dead:
                if not self._heap:
                    raise RuntimeError(f"nothing is left to happen at {self._now / 1e9} s, and the node still waits")
                when, _, due = heappop(self._heap)
                if when > self._now:
                    self._move(when)
                due.switch()
        finally:
            self._close()

    def _move(self, when: int) -> None:
        self._now, self._last_move = when, self._sleeps

    def _stack(self, function: Callable[[], None], name: str) -> Stack:
        def run() -> None:
            running.set(self)
            try:
                function()
            except BaseException:
                if not self._closed:
                    self.failed = self._stacks[stack]
                raise
            finally:
                del self._stacks[stack]

        stack = Stack(run, self._home)
        self._stacks[stack] = name
        return stack

    def _schedule(self, when: int, stack: Stack) -> None:
        self._sleeps += 1
        heappush(self._heap, (when, self._sleeps, stack))

    def _close(self) -> None:
        self._closed = True
        for stack in list(self._stacks):
            try:
                stack.throw(StackExit)
            except (StackExit, Exception):
                pass
            if not stack.dead:
                _abandoned.append(stack)
        self._heap.clear()


class PacedSimulation(Simulation):
    """A simulation that does not jump: ``wait(when)`` is called before the time becomes ``when`` (ns)."""

    def __init__(self, wait: Callable[[int], None]) -> None:
        super().__init__()
        self._wait = wait

    def sleep(self, ns: int) -> None:
        wake = self._now + max(ns, 0)
        self._wait(min(wake, self._heap[0][0]) if self._heap else wake)
        super().sleep(ns)

    def _move(self, when: int) -> None:
        self._wait(when)
        super()._move(when)


class _Condition:
    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._waiting: list[Stack] = []

    def wait(self, ns: int) -> None:
        me = current()
        self._waiting.append(me)
        self._simulation.sleep(ns)
        if me in self._waiting:
            self._waiting.remove(me)

    def notify_all(self) -> None:
        waiting, self._waiting = self._waiting, []
        for stack in waiting:
            self._simulation.wake(stack)
