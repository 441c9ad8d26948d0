"""Guard this process by another one, which kills it if nothing within can end it."""

from __future__ import annotations

import faulthandler
import math
import os
import re
import select
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from .descendants import kill_descendants
from .frames import Place, Whereabouts

__all__ = ["LastWords", "guard", "guard_threads"]

# Turns the whereabouts of the guarded process's threads into the text that is printed before it is killed.
LastWords = Callable[[list[Whereabouts]], str]

# How long before the end the stacks are looked at (s).
_BEFORE = 0.2

# How long code in C may keep all other threads from running, and how often a thread shows that it can run (s).
_SILENT = 60.0
_BEAT = 0.5

# The latest time for which a timer of faulthandler can be set (s).
_LATEST = threading.TIMEOUT_MAX / 2


@contextmanager
def guard(until: float | None, patience: float, last_words: LastWords) -> Iterator[Callable[[], None]]:
    """Start a process that kills this one if it continues for ``patience`` seconds after a Ctrl-C, whatever it does.

    A thread would not do: code in C may keep all others from running. ``until`` is in how many seconds Ctrl-C will
    come, if that is known. The guardian hears a Ctrl-C from a terminal by itself; the function that this context yields
    tells it of any other. The last words go to ``sys.stderr``.
    """
    deadline = time.monotonic() + (math.inf if until is None else until + patience)
    with _guardian(lambda guarded, read: _watch(guarded, read, deadline, patience), last_words) as (write, dump):

        def interrupted() -> None:
            os.write(write, b"!")
            faulthandler.dump_traceback_later(patience - _BEFORE, file=dump)

        if until is not None and until < _LATEST:
            faulthandler.dump_traceback_later(until + patience - _BEFORE, file=dump)
        yield interrupted


@contextmanager
def guard_threads(last_words: LastWords) -> Iterator[None]:
    """Start a process that kills this one if code in C keeps its threads from running for a minute."""
    with _guardian(_listen, last_words) as (write, dump):
        over = threading.Event()

        def beat() -> None:
            while not over.wait(_BEAT):
                faulthandler.dump_traceback_later(_SILENT - _BEFORE, file=dump)
                os.write(write, b"+")

        faulthandler.dump_traceback_later(_SILENT - _BEFORE, file=dump)
        beating = threading.Thread(target=beat, daemon=True)
        beating.start()
        try:
            yield
        finally:
            over.set()
            beating.join()


@contextmanager
def _guardian(watch: Callable[[int, int], None], last_words: LastWords) -> Iterator[tuple[int, int]]:
    """Start a process that calls ``watch(guarded, read)`` and then kills this one.

    Yields the ends of two pipes to write to: ``watch`` reads the first; stacks for the last words go into the second.
    """
    read, write = os.pipe()
    stacks, dump = os.pipe()
    sys.stderr.flush()
    guarded = os.getpid()
    guardian = os.fork()
    if not guardian:
        os.close(write)
        os.close(dump)
        watch(guarded, read)
        _kill(guarded, last_words(_read_stacks(stacks)))
    os.close(read)
    os.close(stacks)
    try:
        yield write, dump
    finally:
        faulthandler.cancel_dump_traceback_later()
        os.write(write, b".")  # closing it is not enough: a child that a node has forked may hold it open
        os.close(write)
        os.close(dump)
        os.waitpid(guardian, 0)


def _listen(guarded: int, read: int) -> None:
    """Return when nothing has come for too long; exit if the guarded process ends first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    silent = 0.0  # counted, not read from a clock: both processes may have been stopped
    while os.getppid() == guarded and silent < _SILENT:
        if not select.select([read], [], [], _BEFORE)[0]:
            silent += _BEFORE
        elif os.read(read, 1) == b"+":
            silent = 0.0
        else:
            os._exit(0)
    if os.getppid() != guarded:
        os._exit(0)


def _kill(guarded: int, words: str) -> None:
    sys.stderr.write(words)
    sys.stderr.flush()
    kill_descendants(guarded)
    os.kill(guarded, signal.SIGKILL)
    os._exit(0)


def _watch(guarded: int, read: int, deadline: float, patience: float) -> None:
    """Wait until the deadline, or until ``patience`` seconds after a Ctrl-C; exit if the guarded process ends first."""

    def interrupted(number: int, frame: object) -> None:
        nonlocal deadline
        deadline = min(deadline, time.monotonic() + patience)

    signal.signal(signal.SIGINT, interrupted)
    while os.getppid() == guarded:
        if select.select([read], [], [], 0.2)[0]:
            if os.read(read, 1) != b"!":
                break  # the guarded process has come to its end
            interrupted(0, None)
        if time.monotonic() > deadline:
            return
    os._exit(0)


def _read_stacks(stacks: int) -> list[Whereabouts]:
    """Read the stacks that :mod:`faulthandler` has written, which it can even where no Python code can run."""
    os.set_blocking(stacks, False)
    try:
        text = os.read(stacks, 1 << 16).decode(errors="replace")
    except BlockingIOError:
        return []
    main, found = threading.main_thread(), []
    for ident, stack in re.findall(r"hread 0x([0-9a-f]+).*\n((?:  .*\n)*)", text):
        name = main.name if int(ident, 16) == main.ident else "another thread"
        lines = re.findall(r'  File "(.*)", line (\d+) in', stack)
        found.append(Whereabouts(name, [Place(file, int(line)) for file, line in lines]))
    return sorted(found, key=lambda each: each.thread != main.name)  # the main thread first
