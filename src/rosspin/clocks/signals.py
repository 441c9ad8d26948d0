"""Signals of simulated programs: each has handlers of its own, and its main stack runs them, as a main thread does."""

from __future__ import annotations

import _thread
import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .patches import Patch, either, patched
from .stacks import Program, Stack

__all__ = ["Died", "send", "simulated_signals"]

Handler = Callable[[int, Any], Any] | int | None


class Died(BaseException):
    """A signal without a handler has ended the program."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


def send(stack: Stack, number: int) -> None:
    """Send a signal to the program whose main stack this is; it is handled when that stack goes on."""
    stack.clock.interrupt(stack, lambda: _handle(stack.program, number))


def _handle(program: Program, number: int) -> None:
    handler = program.handlers.get(number, signal.SIG_DFL)
    if callable(handler):
        handler(number, sys._getframe(1))
    elif handler == signal.SIG_DFL:
        raise Died(number)


def _signal(stack: Stack, number: int, handler: Handler) -> Handler:
    if stack is not stack.clock.main:
        raise ValueError("signal only works in main thread of the main interpreter")
    if not (callable(handler) or handler in (signal.SIG_DFL, signal.SIG_IGN)):
        raise TypeError("signal handler must be signal.SIG_IGN, signal.SIG_DFL, or a callable object")
    number = signal.Signals(number)
    before = _getsignal(stack, number)
    stack.program.handlers[number] = handler
    return before


def _getsignal(stack: Stack, number: int) -> Handler:
    handler: Handler = stack.program.handlers.get(number, signal.SIG_DFL)
    return handler


def _raise_signal(stack: Stack, number: int) -> None:
    main = stack.clock.main
    if stack is main:
        _handle(stack.program, number)
    else:
        send(main, number)


def _interrupt_main(stack: Stack, number: int = signal.SIGINT) -> None:
    """As a signal, but it wakes nobody: it is handled when the main stack goes on."""
    stack.clock.main.interrupt = lambda: _handle(stack.program, number)


def _kill(real: Callable[[int, int], None]) -> Callable[[int, int], None]:
    def virtual(stack: Stack, pid: int, number: int) -> None:
        if pid == os.getpid():
            _raise_signal(stack, number)
        else:
            real(pid, number)

    return either(virtual)(real)


_PATCHES: list[Patch] = [
    (signal, "signal", either(_signal)),
    (signal, "getsignal", either(_getsignal)),
    (signal, "raise_signal", either(_raise_signal)),
    (os, "kill", _kill),
    (_thread, "interrupt_main", either(_interrupt_main)),
]


@contextmanager
def simulated_signals() -> Iterator[None]:
    """Within this context the stacks of simulations handle and send the signals of their own programs only."""
    with patched(_PATCHES):
        yield
