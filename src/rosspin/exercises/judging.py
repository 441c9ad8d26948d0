"""Run an answer, and find out what it did: who printed what, which timers called back, how each of them ended."""

from __future__ import annotations

import ast
import io
import math
import os
import re
import sys
import threading
import traceback
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from types import CodeType, FrameType
from typing import Any, NamedTuple

from .. import rospy
from ..advice import advice
from ..clocks.clock import NS, nanoseconds
from ..clocks.simulation import Simulation
from ..process import Node, capture, execute, load_source
from ..rospy.state import State
from ..rospy.timer import Timer
from ..run import Result, TimeStandsStill, messages_of, run_node, ticks_of
from ..ticks import Message, Tick
from ..world import NotSimulated, World
from .feedback import Finding
from .shaking import shake, turns

__all__ = ["CLOSE", "Answer", "Fails", "Printed", "Seen", "SeenTimer", "a_value", "grid", "on_time", "plain", "say"]

# What the reader sees as the name of the node file: in tracebacks, and where a node never sleeps.
_FILENAME = "<answer>"

# Nobody means a time difference below this (s).
CLOSE = 1e-3

# A thread that has slept so often in one line of the answer runs a loop there.
_LOOPS = 3


class Fails(Exception):
    """Nothing more can be found out about an answer."""

    def __init__(self, text: str, hint: str = "") -> None:
        self.finding = Finding(False, text, hint)


# --- what a run shows -------------------------------------------------------------------------------------------------


class Printed(NamedTuple):
    """A line that was printed: when (s), in which thread, and its text."""

    time: float
    thread: int
    text: str


class SeenTimer(NamedTuple):
    """What a timer did: its thread, its calls, and how it was when Ctrl-C came.

    ``state`` is "running"; "stopped", as by ``shutdown()`` or after the call of a one-shot timer; "blocked" if a call
    had not ended for a second; "gone" if its thread had ended in some other way.
    """

    thread: int | None
    calls: tuple[Tick, ...]
    state: str


class Seen:
    """What an answer did in one run of ``seconds``.

    ``printed`` are the lines that it printed, also after Ctrl-C; ``timers`` are those that it had started by then;
    ``loops`` are the lines of the answer in which a thread other than a timer's slept again and again; ``messages`` are
    what it published.
    """

    def __init__(self, clock: _Watched, seconds: float, messages: Sequence[Message]) -> None:
        self.seconds = seconds
        self.messages = tuple(messages)
        self.printed = tuple(clock.printed)
        self.timers = tuple(clock.timers)
        of_timers = {timer.thread for timer in self.timers}
        self.loops = sorted(
            {line for (thread, line), count in clock.sleeps.items() if count >= _LOOPS and thread not in of_timers}
        )

    def values(self, tag: str, name: str) -> list[Printed]:
        """The lines ``[tag] name = value``, however they were printed, each with its value as the text."""
        sign = re.compile(rf"(?:^|: )\[{tag}\] {name} = (.*)")
        found = [(line, sign.search(line.text)) for line in self.printed]
        return [line._replace(text=match[1].strip()) for line, match in found if match]

    def counters(self, tag: str = "SPINNER PY NODE") -> list[Printed]:
        """The lines ``[tag] counter = 1`` and so on, up to Ctrl-C."""
        return [line for line in self.values(tag, "counter") if line.time <= self.seconds]

    def printers(self, lines: Collection[Printed]) -> tuple[list[SeenTimer], list[Printed]]:
        """The timers in whose threads lines were printed, and the lines that none of them printed."""
        threads = {line.thread for line in lines}
        timers = [timer for timer in self.timers if timer.thread in threads]
        return timers, [line for line in lines if line.thread not in {timer.thread for timer in timers}]


class _Watched(Simulation):
    """A simulated clock that notes what happens on it."""

    def __init__(self, until: float) -> None:
        super().__init__()
        self.printed: list[Printed] = []
        self.timers: list[SeenTimer] = []
        self.sleeps: Counter[tuple[int, int]] = Counter()
        self._whole = True  # whether the last line was printed to its end
        self.at(nanoseconds(until), self._note_timers)  # before Ctrl-C, which is to come then, too

    def sleep(self, ns: int) -> None:
        self._note_sleep(sys._getframe())
        super().sleep(ns)

    def wait(self, ns: int | None = None) -> bool:
        self._note_sleep(sys._getframe())
        return super().wait(ns)

    def note_print(self, text: str) -> None:
        for piece in text.splitlines(keepends=True):
            if self._whole:
                self.printed.append(Printed(self.seconds(), threading.get_ident(), piece))
            else:
                self.printed[-1] = self.printed[-1]._replace(text=self.printed[-1].text + piece)
            self._whole = piece.endswith("\n")

    def _note_sleep(self, frame: FrameType | None) -> None:
        while frame and frame.f_code.co_filename != _FILENAME:
            if frame.f_code is rospy.spin.__code__:
                return
            frame = frame.f_back
        if frame:
            self.sleeps[threading.get_ident(), frame.f_lineno] += 1

    def _note_timers(self) -> None:
        world = self.main.program
        assert isinstance(world, World)
        ticks = ticks_of(world.graph, 0)
        for timer in world.part(State).timers:
            calls = tuple(tick for tick in ticks if tick.source == timer.source)
            self.timers.append(SeenTimer(timer.ident, calls, self._state(timer, calls)))

    def _state(self, timer: Timer, calls: Sequence[Tick]) -> str:
        if not timer.is_alive():
            return "stopped" if timer._shutdown or timer._oneshot else "gone"
        if calls and math.isnan(calls[-1].duration) and nanoseconds(calls[-1].real) < self.now() - NS:
            return "blocked"
        return "stopped" if timer._shutdown else "running"


class _Listener(io.TextIOBase):
    """A stream whose lines a clock is told of."""

    def __init__(self, clock: _Watched) -> None:
        self._clock = clock

    def write(self, text: str) -> int:
        self._clock.note_print(text)
        return len(text)


# --- running an answer ------------------------------------------------------------------------------------------------


_Allowed = Callable[[BaseException], bool]


def _nothing(error: BaseException) -> bool:
    return False


class Answer:
    """The answer to one exercise.

    ``console`` is that of its first run; ``ended_early`` says whether a run was over before its time.
    """

    def __init__(self, text: Any) -> None:
        self._text = text
        self.console = ""
        self.ended_early = False
        self._ran = False

    def run(self, seconds: float, *args: str, seed: int | None = None, allowed: _Allowed = _nothing) -> Seen:
        """Run the answer as a node in simulated time; ``args`` are its command line.

        With a ``seed`` its threads take turns at any line. A node that cannot be run, or fails of an error that is not
        ``allowed``, ends the check.
        """
        node = _load(self._text)
        if gaps := _gaps(self._text):
            lines = f"line {gaps[0]}" if len(gaps) == 1 else f"lines {', '.join(map(str, gaps))}"
            raise Fails(f"There is still a gap, `...`, in {lines}.")
        if seed is None:
            seen, interrupted = self._run(node, seconds, args, allowed)
            self.ended_early |= not interrupted and allowed is _nothing
            return seen
        code = compile(shake(self._text), _FILENAME, "exec", dont_inherit=True)
        with turns(seed):
            return self._run(node._replace(main=lambda: execute(code, _FILENAME)), seconds, args, allowed)[0]

    def variables(self) -> dict[str, Any]:
        """The variables that the answer assigns. One that cannot be run, or fails, ends the check."""
        node = _load(self._text)
        found: dict[str, Any] = {}

        def main() -> None:
            node.main()
            found.update(vars(sys.modules["__main__"]))

        self._run(node._replace(main=main), 0.0, ())
        return found

    def _run(self, node: Node, seconds: float, args: Sequence[str], allowed: _Allowed = _nothing) -> tuple[Seen, bool]:
        """What was seen, and whether the node ran until Ctrl-C."""
        started = f"Started with `{' '.join(args)}`, the" if args else "The"
        clock = _Watched(seconds)
        listener: Any = _Listener(clock)
        try:
            with capture(listener, listener) as console, _plain_environment():
                result = run_node(node, seconds, args, clock)
        except (TimeStandsStill, NotSimulated, RuntimeError) as error:
            raise Fails(f"{started} node cannot be run: `{plain(str(error))}`", _hint_for(error)) from None
        finally:
            if not self._ran:
                self.console, self._ran = console.text(), True
        if failure := _failure(result, allowed):
            raise Fails(f"{started} {failure}", _hint_for_errors(result.world.errors))
        return Seen(clock, seconds, messages_of(result.world.graph, 0)), result.world.interrupted


def _load(source: Any) -> Node:
    if source is ... or source is None:
        raise Fails("There is no answer yet.", "Write it in a cell that begins with `%%answer`.")
    if not isinstance(source, str):
        raise Fails(f"The answer is a text, not {a_value(source)}.")
    read = "Python could not read the answer, so nothing ran. The error may be in the line before."
    try:
        return load_source(source, _FILENAME)
    except SyntaxError as error:
        said = plain(error.msg)  # may end in a question
        raise Fails(f"Line {error.lineno} is not Python: {said}{'' if said.endswith('?') else '.'}", read) from None
    except (ValueError, RecursionError, MemoryError) as error:
        raise Fails(f"This is not Python: {plain(str(error))}.", read) from None


def _gaps(source: str) -> list[int]:
    """The lines in which there still is a gap."""
    return [node.lineno for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Constant) and node.value is ...]


@contextmanager
def _plain_environment() -> Iterator[None]:
    """Without the variables by which a reader may have changed the console or the namespace of every node."""
    kept = {name: os.environ.pop(name) for name in ("ROSCONSOLE_FORMAT", "ROS_NAMESPACE") if name in os.environ}
    try:
        yield
    finally:
        os.environ.update(kept)


def _failure(result: Result, allowed: _Allowed) -> str:
    """What went wrong in a run, as the rest of a sentence; empty if nothing did."""
    errors = result.world.errors
    if wrong := [error for error in errors if not allowed(error)]:
        error = wrong[-1]
        lines = [line for code, line in _frames(error) if code.co_filename == _FILENAME]
        place = f" in line {lines[-1]}" if lines else ""
        said = plain(traceback.format_exception_only(error)[-1])
        return f"{_whose(error)} died of `{said}`{place}."
    if result.status == 137:
        return "node did not end at Ctrl-C: its loop does not ask `rospy.is_shutdown()`."
    return f"node ended with status {result.status} instead of 0." if result.status and not errors else ""


def _frames(error: BaseException) -> Iterator[tuple[CodeType, int]]:
    """The code and the line of each frame that an exception came through, outermost first."""
    trace = error.__traceback__
    while trace:
        yield trace.tb_frame.f_code, trace.tb_lineno
        trace = trace.tb_next


def _whose(error: BaseException) -> str:
    codes = {code for code, _ in _frames(error)}
    if Timer.run.__code__ in codes:
        return "timer"
    if rospy.signal_shutdown.__code__ in codes:
        return "shutdown hook"
    return "thread" if threading.Thread.run.__code__ in codes else "node"


def _hint_for_errors(errors: Sequence[BaseException]) -> str:
    if not errors:
        return ""
    if isinstance(errors[-1], TypeError) and _whose(errors[-1]) == "shutdown hook":
        return "A shutdown hook is called without arguments."
    if isinstance(errors[-1], (AttributeError, ImportError, NameError)):
        missing = "Python names what it did not find. Is it spelt as it is where it was made, with its `self.`?"
        return advice(errors[-1]) or missing
    return advice(errors[-1])


def _hint_for(error: Exception) -> str:
    if isinstance(error, TimeStandsStill):
        return "Something goes on without ever sleeping: a loop without a `sleep()`, or a period of 0."
    if isinstance(error, NotSimulated):
        return "Timers, rates, sleeps, topics and log lines are all that an answer needs."
    return ""


# --- words ------------------------------------------------------------------------------------------------------------


def plain(text: str) -> str:
    """Text of the reader's, or of Python's, that is to stand in Markdown."""
    return " ".join(text.split()).replace("`", "'")[:300]


def a_value(value: object) -> str:
    """What a value is, for a reader who gave one of the wrong type."""
    return f"a value of type `{type(value).__name__}`"


def say(seconds: float) -> str:
    """A time in s."""
    return f"{round(seconds, 3):.10g} s"


# --- counters ---------------------------------------------------------------------------------------------------------


def grid(period: float, seconds: float, start: float | None = None) -> list[float]:
    """Times ``period`` apart, from ``start`` (one period, if none) up to ``seconds``, both included."""
    first = period if start is None else start
    return [first + n * period for n in range(int((seconds - first) / period + 1e-6) + 1)]


def on_time(found: Sequence[Printed], wanted: Sequence[float], what: str = "", hint: str = "") -> Finding:
    """Whether counters 1, 2, ... came at the times that are wanted, and no others; ``what`` begins the sentence."""
    start = f"{what}: " if what else ""
    if not found:
        return Finding(False, f"{start}no counter was printed.", hint)
    for number, (line, time) in enumerate(zip(found, wanted, strict=False), 1):
        if line.text != str(number):
            text = f"{start}where counter {number} was due, counter {plain(line.text)} came."
            return Finding(False, text, hint)
        if abs(line.time - time) > CLOSE:
            return Finding(False, f"{start}counter {number} came at {say(line.time)}, not at {say(time)}.", hint)
    if len(found) > len(wanted):
        extra = found[len(wanted)]
        text = f"{start}counter {plain(extra.text)} came at {say(extra.time)}; it should not come."
        return Finding(False, text, hint)
    if len(found) < len(wanted):
        text = f"{start}counter {len(found) + 1}, due at {say(wanted[len(found)])}, did not come."
        return Finding(False, text, hint)
    if len(wanted) == 1:
        return Finding(True, f"{start}counter 1 came at {say(wanted[0])}, and no other.")
    text = f"{start}counters 1 to {len(wanted)} came from {say(wanted[0])} to {say(wanted[-1])}, each at its time."
    return Finding(True, text)
