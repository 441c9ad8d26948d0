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
from collections.abc import Callable, Iterator, Mapping
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
    left = math.inf if until is None else until + patience
    with _guardian(left, {b"!": patience}, last_words) as (write, dump):

        def interrupted() -> None:
            os.write(write, b"!")
            faulthandler.dump_traceback_later(patience - _BEFORE, file=dump)

        if until is not None and until < _LATEST:
            faulthandler.dump_traceback_later(until + patience - _BEFORE, file=dump)
        yield interrupted


@contextmanager
def guard_threads(last_words: LastWords) -> Iterator[None]:
    """Start a process that kills this one if code in C keeps its threads from running for a minute."""
    with _guardian(_SILENT, {b"+": _SILENT}, last_words) as (write, dump):
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
def _guardian(left: float, after: Mapping[bytes, float], last_words: LastWords) -> Iterator[tuple[int, int]]:
    """Start a process that kills this one when :func:`_watch` returns.

    Yields the ends of two pipes to write to: that reads the first; stacks for the last words go into the second.
    """
    read, write = os.pipe()
    stacks, dump = os.pipe()
    sys.stderr.flush()
    guarded = os.getpid()
    guardian = os.fork()
    if not guardian:
        os.close(write)
        os.close(dump)
        _watch(guarded, read, left, after)
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


def _watch(guarded: int, read: int, left: float, after: Mapping[bytes, float]) -> None:
    """Return in ``left`` seconds; exit if the guarded process ends first.

    What it writes leaves it as long as ``after`` says: "+" from now on, "!", as a Ctrl-C does, at most. The time is
    counted, not read from a clock: both processes may have been stopped.
    """

    def interrupted(number: int, frame: object) -> None:
        nonlocal left
        left = min(left, after.get(b"!", left))

    signal.signal(signal.SIGINT, interrupted)
    while os.getppid() == guarded and left > 0:
        if not select.select([read], [], [], _BEFORE)[0]:
            left -= _BEFORE
        elif (byte := os.read(read, 1)) == b"!":
            interrupted(0, None)
        elif byte not in after:
            break  # the guarded process has come to its end
        else:
            left = after[byte]
    if left > 0:
        os._exit(0)


def _kill(guarded: int, words: str) -> None:
    sys.stderr.write(words)
    sys.stderr.flush()
    kill_descendants(guarded)
    os.kill(guarded, signal.SIGKILL)
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
