"""Run nodes on the wall clock: the text of a node in a process of its own, a function in the caller's."""

from __future__ import annotations

import os
import pickle
import select
import signal
import struct
import subprocess
import sys
import threading
import time
import traceback
import warnings
from _thread import start_new_thread
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from typing import Any, TextIO

from ..clocks.clock import Clock, WallClock
from ..clocks.descendants import adopt_orphans, kill_descendants
from ..clocks.frames import node_frames
from ..clocks.real_time import RealTime
from ..messages import pickles
from ..programs import Program
from ..results.ticks import Call, Message, Run, Tick
from ..world.graph import TickLog
from .host import Host, Result, duration
from .process import leave
from .saved_state import refuse_a_run_within_a_run
from .simulate import run_captured, run_node
from .source import Code, NodeLike, folder_of, load, load_source, refuse_text
from .streams import Capture, byte_stream

__all__ = ["measure", "measured", "wall_clock"]

# The node's process sends pieces that a pipe takes as a whole, whoever else writes into it: kind and length, then that
# many bytes.
_HEAD = struct.Struct("=cH")
_PIECE = 4096 - _HEAD.size
_STARTED, _STDOUT, _STDERR, _OUTCOME, _END = b"s", b"o", b"e", b"r", b"."

# What the node's process sends at its end, without the classes that only it has: status, start, ticks, messages.
_Outcome = tuple[int, float, list[tuple[Any, ...]], list[pickles.Packed], list[pickles.Packed]]


def measure(node: NodeLike, seconds: float, args: Sequence[str] = ()) -> Run:
    """Run a node for ``seconds`` on the wall clock; its ticks show the jitter of this machine.

    Like :func:`simulate`, but in real time. A node file runs in a process of its own, as with ``rosspin run``: its
    standard input is empty, and it sees nothing that you have replaced in your modules. When the run is over, nothing
    of it is left, whatever the node does. You can measure several files at a time, each in a thread.

    A C++ node runs on its stand-ins, in a process beside yours, and its threads take turns.

    A function runs in your process, so that it can fill lists of yours. It needs the main thread (else RuntimeError).
    If it is inside a call of C code that ignores signals, the run cannot end before that call returns.

    A message in the result is None if it could not leave the node's process, because it holds an object of the node's
    own class. No subscriber could have received it either.
    """
    refuse_text(args)
    return measured(load(node), seconds, args)


def measured(node: Code, seconds: float, args: Sequence[str], *streams: TextIO) -> Run:
    """Run a loaded node as :func:`measure` does. What it prints also goes to ``streams``: stdout's and stderr's."""
    if node.source is None or not hasattr(os, "fork"):
        return run_captured(wall_clock(node), node, seconds, args, *streams)
    refuse_a_run_within_a_run()
    duration(seconds)
    console = Capture(*streams)
    job = pickle.dumps((node.source, node.filename, seconds, list(args), Host.ending))
    read, write = os.pipe()
    # The node's process is a fresh one: a fork of this one would inherit the locks that its other threads hold.
    code = f"import sys; sys.path[:] = {sys.path!r}; from rosspin.run.wall import run_apart; run_apart({write})"
    child = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, pass_fds=[write], start_new_session=True
    )
    os.close(write)
    apart = _Apart(child, console)
    try:
        with _ctrl_c_for(apart):
            apart.listen(read, job)
    finally:
        apart.kill()
        os.close(read)
    status, start, ticks, *packed = apart.outcome()
    messages, calls = pickles.unpack(packed, (Message, Call), folder_of(node))
    return Run(console.text(), tuple(map(Tick._make, ticks)), status, "wall", seconds, start, messages, calls)


class _Apart:
    """A node's process, seen from its caller's."""

    def __init__(self, child: subprocess.Popen[bytes], console: Capture) -> None:
        self._child = child
        self._console = console
        self._outcome = b""
        self._start: float | None = None
        self._ended = 0.0
        self._interrupted = False

    def interrupt(self) -> None:
        """Press Ctrl-C, now or as soon as the node has started."""
        self._interrupted = True
        if self._start is not None and not self._ended:
            self._signal(signal.SIGINT)

    def listen(self, read: int, job: bytes) -> None:
        """Send the process its job, and take all that it sends, until its end."""
        assert self._child.stdin
        with suppress(BrokenPipeError):
            self._child.stdin.write(job)
            self._child.stdin.flush()  # left open: it closes with the caller, and then the process ends
        received = b""
        while True:
            if select.select([read], [], [], 0.2)[0]:
                data = os.read(read, 1 << 16)
                if not data:
                    return
                received = self._take(received + data)
            elif self._child.poll() is not None:
                return  # only a child of the node's still holds the pipe
            elif self._ended and time.monotonic() > self._ended + Host.ending.patience:
                return

    def _take(self, received: bytes) -> bytes:
        """Take all whole pieces, and return the rest."""
        at = 0
        while len(received) >= at + _HEAD.size:
            kind, length = _HEAD.unpack_from(received, at)
            if len(received) < at + _HEAD.size + length:
                break
            at += _HEAD.size
            self._piece(kind, received[at : at + length])
            at += length
        return received[at:]

    def _piece(self, kind: bytes, data: bytes) -> None:
        if kind == _STDOUT:
            self._console.stdout.buffer.write(data)
        elif kind == _STDERR:
            self._console.stderr.buffer.write(data)
        elif kind == _OUTCOME:
            self._outcome += data
        elif kind == _END:
            self._ended = time.monotonic()
        elif kind == _STARTED:
            self._start = time.time()
            if self._interrupted:
                self.interrupt()

    def kill(self) -> None:
        """Kill what is left: the process, and those that it has started."""
        self._signal(signal.SIGKILL)
        self._child.wait()
        assert self._child.stdin
        with suppress(BrokenPipeError):
            self._child.stdin.close()

    def _signal(self, number: int) -> None:
        with suppress(ProcessLookupError):
            os.killpg(self._child.pid, number)

    def outcome(self) -> _Outcome:
        """Return the result of the run, after its end. Raises the error that prevented it."""
        if self._ended:
            outcome: _Outcome | Exception = pickle.loads(self._outcome)
            if isinstance(outcome, Exception):
                raise outcome
            return outcome
        if self._start is None:
            raise RuntimeError(f"the process of the node did not start (status {self._child.returncode})")
        status = self._child.returncode  # something has killed it
        return 128 - status if status < 0 else status, self._start, [], [], []


def wall_clock(node: Code) -> Clock:
    """Make the clock on which a node runs in real time, and have ready what it runs in."""
    if not isinstance(node.main, Program):
        return WallClock()
    node.main.load()
    return RealTime()


@contextmanager
def _ctrl_c_for(apart: _Apart) -> Iterator[None]:
    """Within this context a Ctrl-C that the main thread gets is for the node."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, lambda number, frame: apart.interrupt())
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


# --- in the node's process --------------------------------------------------------------------------------------------


def run_apart(pipe: int) -> None:
    """Run the node that stdin describes, and write into a pipe what becomes of it."""
    os.set_inheritable(pipe, False)
    adopt_orphans()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # before the run and after it
    source, filename, seconds, args, ending = pickle.load(sys.stdin.buffer)
    caller, empty = os.dup(0), os.open(os.devnull, os.O_RDONLY)
    os.dup2(empty, 0)
    with warnings.catch_warnings(action="ignore"):  # the caller has seen them
        node = load_source(source, filename)
    send = partial(_send, pipe)
    sys.stdout, sys.stderr = byte_stream(partial(send, _STDOUT)), byte_stream(partial(send, _STDERR))

    def main() -> None:
        start_new_thread(_end_with, (caller,))
        send(_STARTED)
        node.main()

    def give(result: Result | Exception) -> None:
        kill_descendants()
        send(_OUTCOME, pickle.dumps(result if isinstance(result, Exception) else _plain(result)))
        send(_END)

    try:
        result = run_node(node._replace(main=main), seconds, args, WallClock(), TickLog(), give, ending=ending)
    except Exception as error:
        where = traceback.format_tb(node_frames((error.__cause__ or error).__traceback__))
        error.add_note("In the process of the node:\n" + "".join(where).rstrip())
        give(error)
    else:
        give(result)
        leave(0, result.world)


def _end_with(caller: int) -> None:
    """Kill this process, and what it has started, when its caller is gone."""
    os.read(caller, 1)
    os.killpg(0, signal.SIGKILL)


def _send(pipe: int, kind: bytes, data: bytes = b"") -> None:
    for at in range(0, len(data) or 1, _PIECE):
        piece = data[at : at + _PIECE]
        os.write(pipe, _HEAD.pack(kind, len(piece)) + piece)


def _plain(result: Result) -> _Outcome:
    packed = pickles.pack(result.messages()), pickles.pack(result.calls())
    return result.status, result.start, list(map(tuple, result.ticks)), *packed
