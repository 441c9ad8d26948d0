"""Suspend one Python call stack and continue another, and tell which program the calling code belongs to.

The only module that knows how stacks switch: with greenlet, so that all of them live in one thread and give way only
where they ask to. In a web page there is no greenlet; there it is done by :mod:`rosspin.clocks.jspi`.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import Context
from itertools import count
from typing import TYPE_CHECKING, Any, cast

from .frames import Trail, trail

if TYPE_CHECKING:
    from .simulation import Simulation

__all__ = [
    *("Program", "Stack", "StackExit", "acting_for", "current", "enter", "keeper"),
    *("Switched", "telling_no_turns", "telling_turns", "thread_name", "waiting_for", "whose"),
]


class StackExit(BaseException):
    """Thrown into a stack that should end now; nothing but its own ``finally`` blocks should see it."""


class Program:
    """What runs as one program: its stacks, or threads, belong to it, and so does what they start.

    ``main`` is its main stack, if it is simulated, and ``handlers`` are its signal handlers. ``interrupted`` is true
    once Ctrl-C has come at the end of its time, ``ending`` once it waits for its last threads, as Python does at the
    end of a program, and ``over`` once it has ended among others that continue.
    """

    main: Stack
    name = ""  # of its node, once it has one
    file = ""  # of its code
    tells = True  # whether it tells what it calls, as a node in C++ does not

    def __init__(self) -> None:
        self.interrupted = False
        self.ending = False
        self.thread_numbers = count(1)
        self.pool_numbers = count()
        self.handlers: dict[int, Any] = {signal.SIGINT: signal.default_int_handler}
        self.alarm = (False, 0, 0.0)  # whether one is set, when (ns) it rings, and after how long (s) again
        self.main_ended: Any = None  # a lock, held by the main thread for as long as it runs the program's own code
        self.idents: set[int] = set()  # of the threads that it started and that have not ended
        self.active: dict[int, Any] = {}  # those threads, while it is not running (simulated programs only)
        self.working: dict[Any, Any] = {}  # the ones that belong to a pool, and its queue
        self.over = False
        self.at_end: list[Callable[[], None]] = []  # what should be done when it is over, however it ended


if sys.platform == "emscripten":
    from .jspi import Switched, current, settrace
else:
    from greenlet import getcurrent, greenlet, settrace

    class Switched(greenlet):
        """A call stack that can be suspended; it begins at its first ``switch()``.

        ``switch()`` suspends the caller and continues with this stack; ``throw(exception)`` also raises in it. When
        ``function`` returns (or raises), this stack is ``dead`` and the stack ``home`` continues (or raises). A stack
        is true from its beginning to its end.
        """

        __slots__ = ()

        def __init__(self, function: Callable[[], Any], home: Switched) -> None:
            super().__init__(function, home)
            self.gr_context = Context()  # as a thread's: empty

        @property
        def trail(self) -> Trail:
            """Where it is suspended."""
            return trail(self.gr_frame)

    current = cast(Callable[[], Switched], getcurrent)
    """The stack that is running. One that was not made as a Stack can at least be switched to."""


class Stack(Switched):
    """A stack of a program on a simulated clock.

    It belongs to ``own_program`` and acts for ``program``, which is another program only within :func:`acting_for`.
    ``ident`` is its ``threading.get_ident()``; ``place`` is the line that started it, as ``file:line``.
    """

    __slots__ = (
        "clock",
        "ended",
        "ident",
        "interrupt",
        "lock",
        "needs",
        "own_program",
        "place",
        "polled",
        "polls",
        "program",
        "resumed",
        "ticket",
        "waits",
    )

    def __init__(
        self, function: Callable[[], Any], home: Switched, clock: Simulation, program: Program, ident: int, place: str
    ) -> None:
        super().__init__(function, home)
        self.clock = clock
        self.own_program = self.program = program
        self.ident = ident
        self.place = place
        self.ticket = 0  # the number of its wake-up, while it waits with a time limit
        self.waits = False  # whether it waits for someone to wake it
        self.lock: Any = None  # the lock for which it waits, or last waited, without a limit
        self.needs: tuple[str, Callable[[], Switched | None]] | None = (
            None  # what else it waits for, and who should give it
        )
        self.polled = -1  # when (ns) it last looked in vain for something
        self.polls = 0  # how often in a row it has
        self.interrupt: Callable[[], None] | None = None  # what it should call as soon as it continues
        self.resumed = False  # whether it was scheduled to continue for its interrupt
        self.ended: Any = None  # a lock that is released when it has ended


class _Here(threading.local):
    program: Program | None = None


# Each thread of the operating system has its own, whatever stack is on it.
_here = _Here()


def whose() -> Program | None:
    """The program that the calling code belongs to; None outside of all runs."""
    stack = current()
    return stack.program if isinstance(stack, Stack) else _here.program


@contextmanager
def waiting_for(what: str, giver: Callable[[], Switched | None]) -> Iterator[None]:
    """Within this context the calling stack waits for what another, ``giver()``, should give; ``what`` names it."""
    me = current()
    if not isinstance(me, Stack):
        yield
        return
    me.needs = what, giver
    try:
        yield
    finally:
        me.needs = None


def keeper(stack: object) -> tuple[Stack, bool] | None:
    """Return who has the lock for which a stack waits, and whether that lock is its end; None if no other has it."""
    lock = stack.lock if isinstance(stack, Stack) else None
    holder = lock.holder if lock and stack in lock._waiting else None
    if holder is None or holder is stack or holder.dead:
        return None
    return holder, lock in (holder.ended, holder.program.main_ended)


def thread_name(stack: Stack) -> str:
    """Call a stack by the name of its thread."""
    thread = threading._active.get(stack.ident)  # type: ignore[attr-defined]
    return f"the thread {thread.name}" if thread else "a thread"


def enter(program: Program | None) -> Program | None:
    """Make the calling thread of the operating system belong to ``program``. Returns what it belonged to before."""
    before, _here.program = _here.program, program
    return before


def _tell_nobody(program: Program) -> None:
    pass


_tell_turn: Callable[[Program], None] = _tell_nobody


@contextmanager
def telling_turns(tell: Callable[[Program], None]) -> Iterator[None]:
    """Within this context ``tell(program)`` is called whenever code of a program continues, even if it ran last.

    Only runs of several programs need this: the switches of all others cost nothing more for it.
    """
    global _tell_turn

    def trace(event: str, stacks: Any) -> None:
        target = stacks[1]
        if isinstance(target, Stack):
            tell(target.program)

    before = settrace(trace), _tell_turn
    _tell_turn = tell
    try:
        yield
    finally:
        settrace(before[0])
        _tell_turn = before[1]


@contextmanager
def telling_no_turns() -> Iterator[None]:
    """Within this context ``tell`` is not called."""
    global _tell_turn
    before, _tell_turn = _tell_turn, _tell_nobody
    trace = None if before is _tell_nobody else settrace(None)
    try:
        yield
    finally:
        _tell_turn = before
        if trace:
            settrace(trace)


@contextmanager
def acting_for(program: Program) -> Iterator[None]:
    """Within this context the calling code belongs to ``program``, and so does what it starts."""
    stack = current()
    if isinstance(stack, Stack):
        before, stack.program = stack.program, program
        _tell_turn(program)
        try:
            yield
        finally:
            stack.program = before
            _tell_turn(before)
    else:
        outer = enter(program)
        try:
            yield
        finally:
            enter(outer)
