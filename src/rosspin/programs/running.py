"""A compiled node as the main program of a process, whose clock is its time, wherever the program itself runs.

The two talk in batches, as ``cpp/js/node.mjs`` says: the node runs on its own for as long as nothing else is due, tells
what it has done, and waits. Here that wait is one of a stack on the clock, as any other node's is.
"""

from __future__ import annotations

import codecs
import os
import random
import signal
import sys
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from typing import Any, Protocol

from ..clocks.real_time import RealTime
from ..clocks.simulation import Simulation
from ..clocks.stacks import current
from ..world.world import NotSimulated, World, current_world
from .values import packed, unpacked

__all__ = ["Batch", "Child", "Program", "Running"]

NEVER = 2**63 - 1

_TICK = 32  # bytes: see world.graph.Records
_DURATION = 24
_LASTS = b"\xff" * 8  # the duration of one that has not ended

_OTHERS = {"node": "node", "group": "callback group"}  # what can be lost besides timers and subscriptions

Batch = dict[str, Any]


class Child(Protocol):
    """Where a node runs."""

    def go_on(self, message: Mapping[str, Any]) -> Iterator[Batch]:
        """Let it begin, or continue, and yield its batches until one in which it waits or has ended."""

    def end(self, by_itself: bool) -> None:
        """Clear up after it."""


class Program:
    """Runs a compiled node of a ROS, whose source is ``path``, when it is called; ``begin`` makes what it runs in.

    ``load`` has that ready, so that it begins immediately. ``warnings`` are what the compiler has said of it.
    """

    def __init__(
        self,
        ros: int,
        path: str,
        begin: Callable[[World, Simulation], Child],
        load: Callable[[], None] = lambda: None,
        warnings: str = "",
    ) -> None:
        self.ros = ros
        self.path = path
        self.begin = begin
        self.load = load
        self.warnings = warnings

    def __call__(self) -> None:
        """Run it to its end, on a stack of a simulation, within a process. Raises SystemExit with its status."""
        world = current_world()
        assert isinstance(world.clock, Simulation)
        world.bind(self.ros)
        Running(self, world, world.clock).run()


class Running:
    """A node while it runs."""

    def __init__(self, program: Program, world: World, clock: Simulation) -> None:
        self._program = program
        self._world = world
        self._clock = clock
        self._stack: Any = current()
        self._events: list[tuple[int, str]] = []  # what should be given to the node: when it came, and what
        self._signals: list[int] = []
        self._sources: list[str] = []
        self._names: list[str] = []  # of the functions that they call, or of what they are
        self._ticks = 0  # how many were told
        self._open: dict[int, int] = {}  # the places of ticks that have not ended, by their numbers
        self._came: tuple[int, str, list[Any]] = (-1, "", [])  # what it was given last, and when
        self._streams = {1: _Stream(lambda: sys.stdout), 2: _Stream(lambda: sys.stderr)}
        self._ros = _answers(program.ros)(world, self._come)
        self._has_ended = False  # by itself

    def run(self) -> None:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._world.handlers[number] = self._on_signal
        self._world.tells = False
        child = self._program.begin(self._world, self._clock)
        try:
            message = self._start()
            while True:
                for batch in child.go_on(message):
                    message = self._follow(batch)
        finally:
            child.end(self._has_ended)

    def _start(self) -> dict[str, Any]:
        return {
            "args": self._world.argv,
            "environment": dict(os.environ),
            "start": str(self._clock.now()),
            "ahead": str(self._clock.ahead),
            "seed": random.getrandbits(32),
            **({"real": str(self._clock.offset)} if isinstance(self._clock, RealTime) else {}),
        }

    def _follow(self, batch: Batch) -> dict[str, Any]:
        """Note what the node has done; if it waits, wait with it, and return what to tell it."""
        self._advance(int(batch["now"]))
        for entry in batch["log"]:
            self._note(*entry)
        if "ticks" in batch:
            self._note_ticks(batch["ticks"])
        if "trap" in batch:
            self._trapped(**batch["trap"])
        if "status" in batch:
            self._has_ended = True
            self._world.waiting = batch["waiting"]
            raise SystemExit(batch["status"])
        if "asks" in batch:
            what, values = unpacked(batch["asks"])
            if what == "not_simulated":
                raise NotSimulated(values[0], place=self._program.path)
            return self._reply(packed(self._ros.answer(what, values)))
        if "wake" in batch:
            self._wait(int(batch["wake"]))
            return self._reply()
        return {}

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
        self._came = (self._clock.now(), what, values)
        self._events.append((self._clock.now(), packed(what) + packed(values)))
        self._clock.wake(self._stack)

    def _on_signal(self, number: int, frame: object) -> None:
        self._signals.append(number)
        self._clock.wake(self._stack)

    def _reply(self, answer: str = "") -> dict[str, Any]:
        events, self._events = self._events, []
        signals, self._signals = self._signals, []
        return {
            "now": str(self._clock.now()),
            "ahead": str(self._clock.ahead),
            "horizon": str(self._clock.horizon()),
            "events": [(str(when), text) for when, text in events],
            "signals": signals,
            "answer": answer,
        }

    # --- what it has done ---

    @property
    def calling(self) -> str:
        """The source of the tick that began last, of those that last; empty if none does."""
        log = self._world.recording.log
        return log.source(self._open[max(self._open)]) if log is not None and self._open else ""

    @property
    def heard(self) -> Any:
        """The message that it was given just now, or None."""
        when, what, values = self._came
        return self._ros.message(*values[:2]) if (when, what) == (self._clock.now(), "message") else None

    def _note(self, what: str, *values: Any) -> None:
        log = self._world.recording.log
        if what == "out":
            number, text = values
            self._streams[number].write(text.encode("latin-1"))
        elif what == "source":
            name, period = values
            self._names.append(name)
            self._sources.append(self._world.source(name))
            if log is not None:
                log.periods.setdefault(self._sources[-1], int(period))
        elif what == "end" and log is not None:
            tick, duration = map(int, values)
            log.end(self._open.pop(tick), duration)
        elif what == "tell":
            name, arguments = unpacked(values[0])
            if name == "ring":
                return  # a picture for a page that runs it alone: in words, the program has said it
            if name == "lost":
                self._world.lost = [*self._lost(arguments[0].split())]
            elif name != "coming":
                self._ros.take(name, arguments)
            elif log is not None and log.is_over:
                sources = [self._sources[number] for number in arguments[::4]]
                log.coming += zip(sources, arguments[1::4], arguments[2::4], arguments[3::4])

    def _lost(self, told: list[str]) -> Iterator[str]:
        """Yield in words what was destroyed before the node spun, and not made again."""
        sources = {str(source): name for source, name in enumerate(self._names)}
        kept = {name for source, name in sources.items() if source not in told}
        for each in told:
            if each not in sources:
                yield _OTHERS.get(each) or f"subscription to {each}"
            elif (name := sources[each]) not in kept:
                yield f"timer of {'a lambda' if name == 'lambda' else name}"

    def _note_ticks(self, data: bytes) -> None:
        """Record ticks, as bytes: a run may have a million."""
        log = self._world.recording.log
        first, self._ticks = self._ticks, self._ticks + len(data) // _TICK
        if log is None:
            return
        place = log.extend(data, self._sources)
        at = data.find(_LASTS)
        while at >= 0:  # there are as many as calls within calls
            if at % _TICK == _DURATION:
                self._open[first + at // _TICK] = place + at // _TICK
            at = data.find(_LASTS, at + 1)

    def _trapped(self, why: str, signal: int, file: str, line: int) -> None:
        """Say what has ended the node from outside, as on a computer, and where, if that is known."""
        sys.stderr.write(f"rosspin: {file or self._program.path}:{f'{line}:' if line else ''} {why}\n")
        raise SystemExit(128 + signal)


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
