"""Real time for stacks that take turns: the clock of a node in C++ that does not run in simulated time."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from select import select
from time import monotonic_ns, time_ns
from typing import Any

from .clock import NS
from .programs import Killed
from .signals import send
from .simulation import Simulation
from .stacks import Program, Stack, current

__all__ = ["FOREVER", "RealTime"]

FOREVER = 1 << 62
"""So long (ns) a run lasts that only Ctrl-C ends."""


class RealTime(Simulation):
    """A simulation whose time passes by itself: whatever is due waits for its time, and is late if others compute.

    ``offset`` is how much its time is ahead of ``time.monotonic_ns()``. It never jumps. A program that has not ended
    ``patience`` ns after it was asked to, as it computes and does not wait, is given up.
    """

    patience = 0

    def __init__(self) -> None:
        self.offset = time_ns() - monotonic_ns()
        super().__init__(monotonic_ns() + self.offset)
        self._ends = FOREVER << 1  # when the program is asked to end
        self.is_late = True  # no program runs ahead
        self._woken, self._wakes = os.pipe()
        os.set_blocking(self._woken, False)
        os.set_blocking(self._wakes, False)

    def __del__(self) -> None:
        os.close(self._woken)
        os.close(self._wakes)

    def now(self) -> int:
        """The time, in ns."""
        self._now = max(self._now, monotonic_ns() + self.offset)
        self._last_move = self._order
        return self._now

    def seconds(self) -> float:
        """The time, in s."""
        return self.now() / NS

    def system(self) -> int:
        """What the system's clock tells, in ns."""
        return self.now() + self.ahead

    def sign_of_life(self) -> int:
        """Return a number that changes when the time moves on, so always."""
        return self.now()

    def sleep(self, ns: int) -> None:
        """Suspend the caller for ``ns`` nanoseconds; others run meanwhile. 0 or less only lets others run."""
        me = current()
        assert isinstance(me, Stack)
        wake = self.now() + max(ns, 0)
        self._schedule(wake, me)
        self._go_on(me)
        if me.interrupt:
            self._handle_interrupt(me)
            if self.now() < wake:
                self.sleep(wake - self._now)

    def wait(self, ns: int | None = None) -> bool:
        """Suspend the caller until another stack wakes it, for at most ``ns`` nanoseconds. Returns whether one did."""
        self.now()
        return super().wait(ns)

    def give_up_if_overdue(self) -> None:
        """End the run if the program that the calling stack waits for should have ended long before."""
        if self.now() > self._ends + self.patience:
            self._home.throw(Killed([], False))

    def _pause_at(self, when: int) -> None:
        self._ends = min(self._ends, when)
        super()._pause_at(when)

    def _next(self) -> tuple[int, int, Stack] | None:
        while True:
            self._drop_cancelled()
            if not self._heap or (left := self._heap[0][0] - self.now()) <= 0:
                return super()._next()
            select([self._woken], [], [], left / NS)
            self._forget_signals()

    def _forget_signals(self) -> None:
        """Forget which signals have woken it: their handlers were called."""
        try:
            os.read(self._woken, 4096)
        except BlockingIOError:
            pass

    @contextmanager
    def heeding_signals(self, program: Program) -> Iterator[None]:
        """See :meth:`.Simulation.heeding_signals`: the first Ctrl-C ends a step, and the rest is for the program."""
        if threading.current_thread() is not threading.main_thread():
            yield  # only the main thread gets signals
            return
        earlier: Any = signal.getsignal(signal.SIGINT)  # ends what does not end when it is taken down

        def on_signal(number: int, frame: Any) -> None:
            if self.is_over:
                earlier(number, frame)
            elif number == signal.SIGINT and self.now() < self._ends:
                self.pause()
            else:
                self.soon(lambda: send(program, number))

        before = {number: signal.signal(number, on_signal) for number in (signal.SIGINT, signal.SIGTERM)}
        descriptor = signal.set_wakeup_fd(self._wakes, warn_on_full_buffer=False)
        try:
            yield
        finally:
            signal.set_wakeup_fd(descriptor)
            for number, handler in before.items():
                signal.signal(number, handler)
