"""A compiled C++ node as the main program of a process: it runs in Node.js, and its time is the process's clock.

The two talk in batches, as ``js/node.mjs`` says: the node runs on its own for as long as nothing else is due, tells
what it has done, and waits. Here that wait is one of a stack on the clock, as any other node's is.
"""

from __future__ import annotations

import atexit
import codecs
import json
import os
import random
import select
import signal
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from ..clocks.frames import Place
from ..clocks.programs import end_run
from ..clocks.simulation import Simulation
from ..clocks.stacks import current
from ..world.world import NotSimulated, World, current_world
from .building import Built, node_command
from .values import packed, unpacked

__all__ = ["Program"]

_RUN = Path(__file__).parent / "js" / "run.mjs"

NEVER = 2**63 - 1

_TICK = 32  # bytes
_CHUNK = 1 << 16  # bytes that are read at once

# How often (s) a node is looked at while it computes, and after how much time of a processor (s) it will not end.
_LOOK = 0.2
_MOST = 10.0

_SEGMENTATION_FAULT = 128 + 11


class Program:
    """Runs a compiled node when it is called: ``built`` is the program, ``path`` its source."""

    def __init__(self, built: Built, path: str) -> None:
        self.wasm = built.program
        self.ros = built.ros
        self.path = path

    def __call__(self) -> None:
        """Run it to its end, on a stack of a simulation, within a process. Raises SystemExit with its status."""
        world = current_world()
        if not isinstance(world.clock, Simulation):
            raise NotSimulated("C++ on the wall clock", "in simulated time, or on a real ROS")
        world.bind(self.ros)
        _Running(self, world, world.clock).run()


class _Running:
    """A node while it runs."""

    def __init__(self, program: Program, world: World, clock: Simulation) -> None:
        self._program = program
        self._world = world
        self._clock = clock
        self._stack: Any = current()
        self._events: list[tuple[int, str]] = []  # what should be given to the node: when it came, and what
        self._signals: list[int] = []
        self._sources: list[str] = []
        self._ticks = 0  # how many were told
        self._open: dict[int, int] = {}  # the places of ticks that have not ended, by their numbers
        self._streams = {1: _Stream(lambda: sys.stdout), 2: _Stream(lambda: sys.stderr)}
        self._ros = _answers(program.ros)(world, self._come)
        self._data = bytearray()  # that was read, and not used yet
        self._has_ended = False  # by itself

    def run(self) -> None:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._world.handlers[number] = self._on_signal
        self._child = _begin()
        try:
            self._send(self._start())
            self._follow()
        finally:
            if self._has_ended:
                _idle.append(self._child)
            else:
                _end(self._child)

    def _start(self) -> dict[str, Any]:
        return {
            "program": str(self._program.wasm),
            "args": self._world.argv,
            "environment": dict(os.environ),
            "start": str(self._clock.now()),
            "ahead": str(self._clock.ahead),
            "seed": random.getrandbits(32),
        }

    def _follow(self) -> None:
        """Run the node until it ends."""
        while True:
            batch = self._read_line()
            self._advance(int(batch["now"]))
            for entry in batch["log"]:
                self._note(*entry)
            if "ticks" in batch:
                self._note_ticks(self._read(lambda data: batch["ticks"]))
            if "trap" in batch:
                self._trapped(batch["trap"], batch["where"])
            if "status" in batch:
                self._has_ended = True
                raise SystemExit(batch["status"])
            if "asks" in batch:
                what, values = unpacked(batch["asks"])
                if what == "not_simulated":
                    raise NotSimulated(*values)
                self._reply(packed(self._ros.answer(what, values)))
            elif "wake" in batch:
                self._wait(int(batch["wake"]))
                self._reply()

    # --- time ---

    def _advance(self, now: int) -> None:
        """Move the clock to the node's time: it has been alone until then."""
        if now > self._clock.now():
            self._clock.sleep(now - self._clock.now())

    def _wait(self, until: int) -> None:
        """Wait as the node does, until its time has come, or something for it."""
        clock = self._clock
        if self._events or self._signals:
            clock.sleep(0)
        elif until <= clock.now():
            clock.sleep(0)
        else:
            clock.wait(until - clock.now() if until < NEVER else None)

    def _come(self, what: str, values: list[Any]) -> None:
        """Give something to the node as soon as it waits."""
        self._events.append((self._clock.now(), packed(what) + packed(values)))
        self._clock.wake(self._stack)

    def _on_signal(self, number: int, frame: object) -> None:
        self._signals.append(number)
        self._clock.wake(self._stack)

    # --- the pipes ---

    def _send(self, message: dict[str, Any]) -> None:
        assert self._child.stdin
        try:
            self._child.stdin.write(json.dumps(message).encode() + b"\n")
        except BrokenPipeError:
            pass  # what it has to say of its end is still to be read

    def _reply(self, answer: str = "") -> None:
        events, self._events = self._events, []
        signals, self._signals = self._signals, []
        self._send(
            {
                "now": str(self._clock.now()),
                "ahead": str(self._clock.ahead),
                "horizon": str(self._clock.horizon()),
                "events": [(str(when), text) for when, text in events],
                "signals": signals,
                "answer": answer,
            }
        )

    def _read_line(self) -> dict[str, Any]:
        batch: dict[str, Any] = json.loads(self._read(lambda data: data.find(b"\n", max(len(data) - _CHUNK, 0)) + 1))
        return batch

    def _read(self, find_end: Callable[[bytearray], int]) -> bytes:
        """Take what the node has written up to ``find_end(data)``: 0, or more than there is, until that has come."""
        assert self._child.stdout
        file = self._child.stdout.fileno()
        used = self._used()
        while not 0 < (end := find_end(self._data)) <= len(self._data):
            ready, _, _ = select.select([file], [], [], _LOOK)
            self._clock.beside += 1
            if ready:
                data = os.read(file, _CHUNK)
                if not data:
                    status = self._child.wait()
                    self._world.failure = RuntimeError(f"{self._program.path}: Node.js has ended, status {status}")
                    end_run()
                self._data += data
            elif self._used() - used > _MOST:
                self._stand_still()
        taken = bytes(self._data[:end])
        del self._data[:end]
        return taken

    def _used(self) -> float:
        """For how long (s) the node has had a processor."""
        try:
            with open(f"/proc/{self._child.pid}/stat") as file:
                fields = file.read().rpartition(")")[2].split()
        except OSError:
            return 0.0
        return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")

    # --- what it has done ---

    def _note(self, what: str, *values: Any) -> None:
        log = self._world.recording.log
        if what == "out":
            number, text = values
            self._streams[number].write(text.encode("latin-1"))
        elif what == "source":
            name, period = values
            self._sources.append(self._world.source(name))
            if log is not None:
                log.periods.setdefault(self._sources[-1], int(period))
        elif what == "end" and log is not None:
            tick, duration = map(int, values)
            log.end(self._open.pop(tick), duration)
        elif what == "tell":
            name, arguments = unpacked(values[0])
            if name != "coming":
                self._ros.take(name, arguments)
            elif log is not None and log.is_over:
                sources = [self._sources[number] for number in arguments[::4]]
                log.coming += zip(sources, arguments[1::4], arguments[2::4], arguments[3::4])

    def _note_ticks(self, data: bytes) -> None:
        """Record ticks, written as ``js/shared.mjs`` says, in whole columns: a run may have a million."""
        log = self._world.recording.log
        halves, wholes = memoryview(data).cast("i"), memoryview(data).cast("q")
        first, self._ticks = self._ticks, self._ticks + len(data) // _TICK
        if log is None:
            return
        durations: list[int | None] = [*wholes[3::4].tolist()]
        places = len(log)
        at = -1
        while -1 in durations[at + 1 :]:  # they last; there are as many as calls within calls
            at = durations.index(-1, at + 1)
            durations[at] = None
            self._open[first + at] = places + at
        sources = [self._sources[number] for number in halves[0::8].tolist()]
        log.extend(sources, halves[1::8].tolist(), wholes[1::4].tolist(), wholes[2::4].tolist(), durations)

    def _trapped(self, trap: str, where: list[str]) -> None:
        """Say what has ended the node from outside, as on a computer: a fault of its memory."""
        place = next((name for name in where if name), "")
        sys.stderr.write(f"rosspin: {self._program.path}: {trap}{f', in {place}' if place else ''}\n")
        raise SystemExit(_SEGMENTATION_FAULT)

    def _stand_still(self) -> None:
        self._child.kill()
        self._clock.stand_still(Place(self._program.path, 0))


# Processes of Node.js whose nodes have ended: to start another takes longer than most runs.
_idle: list[subprocess.Popen[bytes]] = []
os.register_at_fork(after_in_child=_idle.clear)


def _begin() -> subprocess.Popen[bytes]:
    while _idle:
        if (child := _idle.pop()).poll() is None:
            return child
    command = [*node_command(), str(_RUN)]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0, cwd=_RUN.parent)


def _end(child: subprocess.Popen[bytes]) -> None:
    with child:
        child.kill()


@atexit.register
def _end_idle() -> None:
    while _idle:
        _end(_idle.pop())


def _answers(ros: int) -> Any:
    """Return what answers nodes of a ROS: ROS 2's loads rclpy."""
    return getattr(import_module(f".ros{ros}", __package__), f"Ros{ros}")


class _Stream:
    """One of the streams of a process, to which bytes are written as text."""

    def __init__(self, find: Callable[[], Any]) -> None:
        self._find = find
        self._decode = codecs.getincrementaldecoder("utf-8")(errors="replace").decode

    def write(self, data: bytes) -> None:
        stream = self._find()
        stream.write(self._decode(data))
        stream.flush()
