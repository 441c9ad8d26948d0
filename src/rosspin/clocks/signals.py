"""Signals of simulated programs: each has handlers of its own, and its main stack runs them, as a main thread does."""

from __future__ import annotations

import _thread
import errno
import math
import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .clock import NS, nanoseconds
from .frames import is_installed, node_frame
from .patches import Patch, either, patched
from .stacks import Program, Stack

__all__ = ["PATCHES", "Died", "send", "simulated_signals"]

# Signals without effect on a program that does not handle them; Python itself ignores the last two.
_IGNORED = {getattr(signal, name, None) for name in ("SIGCHLD", "SIGCONT", "SIGWINCH", "SIGURG", "SIGPIPE", "SIGXFSZ")}

Handler = Callable[[int, Any], Any] | int | None


class Died(BaseException):
    """A signal without a handler has ended the program."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


def send(program: Program, number: int) -> None:
    """Send a signal to a program; it is handled when its main stack continues."""
    program.main.clock.interrupt(program.main, lambda: _handle(program, number))


def _handle(program: Program, number: int) -> None:
    handler = program.handlers.get(number, signal.SIG_DFL)
    if callable(handler):
        handler(int(number), node_frame(sys._getframe(1)))
    elif handler == signal.SIG_DFL and number not in _IGNORED:
        raise Died(number)


def _signal(stack: Stack, number: int, handler: Handler) -> Handler:
    if stack is not stack.program.main:
        raise ValueError("signal only works in main thread of the main interpreter")
    if not (callable(handler) or handler in (signal.SIG_DFL, signal.SIG_IGN)):
        raise TypeError("signal handler must be signal.SIG_IGN, signal.SIG_DFL, or a callable object")
    _check(number)
    if number in (signal.SIGKILL, signal.SIGSTOP):
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))
    before = _getsignal(stack, number)
    stack.program.handlers[number] = handler
    return before


def _getsignal(stack: Stack, number: int) -> Handler:
    handler: Handler = stack.program.handlers.get(number, signal.SIG_DFL)
    return handler


def _raise_signal(stack: Stack, number: int) -> None:
    _check(number)
    if number == 0:
        return
    if stack is stack.program.main:
        _handle(stack.program, number)
    else:
        send(stack.program, number)


def _interrupt_main(stack: Stack, number: int = signal.SIGINT) -> None:
    """Send a signal that wakes no one: the main stack handles it when it next continues by itself."""
    program = stack.program
    if stack is program.main:
        _handle(program, number)
    else:
        stack.clock.interrupt_later(program.main, lambda: _handle(program, number))


_VALID = {0, *signal.valid_signals()}


def _check(number: int) -> None:
    if number not in _VALID:
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))


def _setitimer(stack: Stack, which: int, seconds: float, interval: float = 0.0) -> tuple[float, float]:
    if which != signal.ITIMER_REAL:
        raise NotImplementedError("timers of the processor's time are not simulated; run this node on the wall clock")
    program, clock = stack.program, stack.clock
    before = max(program.alarm[1] - clock.now(), 0) / NS if program.alarm[0] else 0.0, program.alarm[2]

    def set_for(delay: float) -> None:
        when = clock.now() + nanoseconds(delay)
        alarm = program.alarm = (delay > 0, when, interval)

        def ring() -> None:
            if program.alarm is alarm and not program.over:
                send(program, signal.SIGALRM)
                set_for(interval)

        if delay > 0:
            clock.at(when, ring)

    set_for(seconds)
    return before


def _getitimer(stack: Stack, which: int) -> tuple[float, float]:
    pending, when, interval = stack.program.alarm
    return (max(when - stack.clock.now(), 0) / NS, interval) if pending else (0.0, 0.0)


def _alarm(stack: Stack, seconds: int) -> int:
    return math.ceil(_setitimer(stack, signal.ITIMER_REAL, seconds)[0])


def _never(name: str) -> Patch:
    def virtual(stack: Stack, *args: Any) -> Any:
        raise NotImplementedError(f"signal.{name} is not simulated; run this node on the wall clock")

    return signal, name, either(virtual)


def _mask(real: Callable[..., Any]) -> Callable[..., Any]:
    def virtual(stack: Stack, *args: Any) -> Any:
        if is_installed(sys._getframe(2)):  # a library that blocks something for a moment, as multiprocessing does
            return real(*args)
        raise NotImplementedError("signal.pthread_sigmask is not simulated; run this node on the wall clock")

    return either(virtual)(real)


def _kill(real: Callable[[int, int], None]) -> Callable[[int, int], None]:
    def virtual(stack: Stack, pid: int, number: int) -> None:
        if pid == os.getpid():
            _raise_signal(stack, number)
        else:
            real(pid, number)

    return either(virtual)(real)


PATCHES: list[Patch] = [
    (signal, "signal", either(_signal)),
    (signal, "getsignal", either(_getsignal)),
    (signal, "raise_signal", either(_raise_signal)),
    (os, "kill", _kill),
    (signal, "pthread_kill", either(lambda stack, ident, number: _raise_signal(stack, number))),
    (signal, "setitimer", either(_setitimer)),
    (signal, "getitimer", either(_getitimer)),
    (signal, "alarm", either(_alarm)),
    # asyncio tells the operating system where to report signals and what to do after them; it does not see these.
    (signal, "set_wakeup_fd", either(lambda stack, descriptor, **options: -1)),
    (signal, "siginterrupt", either(lambda stack, number, flag: None)),
    *map(_never, ("pause", "sigwait", "sigwaitinfo", "sigtimedwait")),
    (signal, "pthread_sigmask", _mask),
    (_thread, "interrupt_main", either(_interrupt_main)),
]


@contextmanager
def simulated_signals() -> Iterator[None]:
    """Within this context the stacks of simulations handle and send the signals of their own programs only."""
    with patched(PATCHES):
        yield
