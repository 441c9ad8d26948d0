"""Where a compiled node runs on a computer: in Node.js, with which its host talks over pipes (see ``js/run.mjs``)."""

from __future__ import annotations

import atexit
import json
import os
import select
import signal
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from ..clocks.frames import Place
from ..clocks.programs import end_run
from ..clocks.real_time import RealTime
from ..clocks.simulation import Simulation
from ..programs import Batch, Program
from ..world.world import World
from .building import Built, node_command

__all__ = ["program"]

_RUN = Path(__file__).parent / "js" / "run.mjs"

_CHUNK = 1 << 16  # bytes that are read at once

# How often (s) a node is looked at while it computes; and after how much time of a processor (s) it will not end, so
# that it says where it is (js/watch.mjs), and after how much it is ended if it could not.
_LOOK = 0.2
_ASKED = 10.0
_ENDED = 20.0

# Linux makes the number of a process's clock from its own number and this one; see clock_getcpuclockid(3). There is
# one where there is no /proc, too.
_PROCESS = 2


def program(built: Built, path: str) -> Program:
    """Return what runs a compiled node, whose source is ``path``, when it is called."""
    return Program(built.ros, path, partial(_Child, built, path), partial(_load, built), built.warnings)


def _load(built: Built) -> None:
    child = _begin()
    child.stdin.write(json.dumps({"program": str(built.program), "loads": True}).encode() + b"\n")
    child.stdout.readline()
    IDLE.append(child)


class _Child:
    """A process of Node.js."""

    def __init__(self, built: Built, path: str, world: World, clock: Simulation) -> None:
        self._path = path
        self._world = world
        self._clock = clock
        self._first: Mapping[str, Any] = {"program": str(built.program), "most": _ASKED}  # with the first message
        self._data = bytearray()  # that was read, and not used yet
        self._child = _begin()

    def go_on(self, message: Mapping[str, Any]) -> Iterator[Batch]:
        assert self._child.stdin
        try:
            self._child.stdin.write(json.dumps({**self._first, **message}).encode() + b"\n")
        except BrokenPipeError:
            pass  # what it has to say of its end is still to be read
        self._first = {}
        batch: Batch = {}
        while batch.keys().isdisjoint(("asks", "wake", "status", "stuck")):
            batch = json.loads(self._read(lambda data: data.find(b"\n", max(len(data) - _CHUNK, 0)) + 1))
            if "ticks" in batch:
                length = batch["ticks"]
                batch["ticks"] = self._read(lambda data: length)
            yield batch
        if "stuck" in batch:
            self._stand_still(batch["stuck"])

    def end(self, by_itself: bool) -> None:
        if by_itself:
            IDLE.append(self._child)
        else:
            _end(self._child)

    def _read(self, find_end: Callable[[bytearray], int]) -> bytes:
        """Take what the node has written up to ``find_end(data)``: 0, or more than there is, until that has come."""
        assert self._child.stdout
        file = self._child.stdout.fileno()
        used: float | None = None  # when it was looked at first
        while not 0 < (end := find_end(self._data)) <= len(self._data):
            ready, _, _ = select.select([file], [], [], _LOOK)
            self._clock.beside += 1
            if ready:
                data = os.read(file, _CHUNK)
                if not data:
                    status = self._child.wait()
                    self._world.failure = RuntimeError(f"{self._path}: Node.js has ended, status {status}")
                    end_run()
                self._data += data
            elif isinstance(self._clock, RealTime):
                self._clock.give_up_if_overdue()
            elif used is None:
                used = self._used()
            elif self._used() - used > _ENDED:
                self._stand_still("")
        taken = bytes(self._data[:end])
        del self._data[:end]
        return taken

    def _stand_still(self, function: str) -> None:
        self._child.send_signal(signal.SIGKILL)
        self._clock.stand_still(Place(self._path, 0, function=function))

    def _used(self) -> float:
        """For how long (s) the node has had a processor."""
        try:
            return time.clock_gettime(~self._child.pid << 3 | _PROCESS)
        except OSError:
            return 0.0


# Processes of Node.js whose nodes have ended: to start another takes longer than most runs.
IDLE: list[Any] = []
os.register_at_fork(after_in_child=IDLE.clear)


def run_command() -> list[str]:
    """Return the command that runs nodes."""
    return [*node_command(), str(_RUN)]


def _begin() -> Any:
    while IDLE:
        if (child := IDLE.pop()).poll() is None:
            return child
    return subprocess.Popen(run_command(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0, cwd=_RUN.parent)


def _end(child: subprocess.Popen[bytes]) -> None:
    with child:
        child.kill()


@atexit.register
def _end_nodes() -> None:
    while IDLE:
        _end(IDLE.pop())
