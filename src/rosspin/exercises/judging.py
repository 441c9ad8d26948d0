"""Run an answer, and find out what it did: who printed what, which timers called back, how each of them ended."""

from __future__ import annotations

import ast
import io
import math
import os
import signal
import sys
import threading
import traceback
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from types import CodeType, FrameType
from typing import Any

from ..clocks.clock import NS, nanoseconds
from ..clocks.programs import send
from ..clocks.simulation import Simulation
from ..process import Node, capture, execute, load_source
from ..run import TimeStandsStill, messages_of, run_node, ticks_of, waits_for_a_rate, where_it_was_kept
from ..ticks import Tick
from ..world import NotSimulated, World
from . import in_rospy
from .feedback import Finding
from .seen import Printed, Ros, Seen, SeenTimer
from .shaking import shake, turns

__all__ = ["CLOSE", "Answer", "Fails", "a_value", "grid", "on_time", "plain", "say"]

# What the reader sees as the name of the node file: in tracebacks, and where a node never sleeps.
_FILENAME = "<answer>"

# Nobody means a time difference below this (s).
CLOSE = 1e-3

# What a node of each ROS imports.
_MODULES = {1: "rospy", 2: "rclpy"}

_NO_ANSWER = "There is no answer yet."

# A thread that has slept so often in one line of the answer runs a loop there.
_LOOPS = 3


class Fails(Exception):
    """Nothing more can be found out about an answer: it is wrong, or with None for ``right`` not there yet."""

    def __init__(self, text: str, hint: str = "", right: bool | None = False) -> None:
        self.finding = Finding(right, text, hint)


# --- what a run shows -------------------------------------------------------------------------------------------------


class _Watched(Simulation):
    """A simulated clock that notes what happens on it."""

    def __init__(self, ros: Ros, until: float) -> None:
        super().__init__()
        self.printed: list[Printed] = []
        self.timers: list[SeenTimer] = []
        self._ros = ros
        self._sleeps: Counter[tuple[int, int]] = Counter()
        self._whole = True  # whether the last line was printed to its end
        self.at(nanoseconds(until), self._note_timers)  # before Ctrl-C, which is to come then, too

    def terminate(self, at: float) -> None:
        """Send the node SIGTERM at a time (s)."""
        self.at(nanoseconds(at), lambda: send(self.main.program, signal.SIGTERM))

    def loops(self) -> list[int]:
        """The lines of the answer in which something other than a timer's callback slept again and again."""
        return sorted({line for (_, line), count in self._sleeps.items() if count >= _LOOPS})

    def sleep(self, ns: int) -> None:
        self._note_sleep(sys._getframe())
        super().sleep(ns)

    def wait(self, ns: int | None = None) -> bool:
        self._note_sleep(sys._getframe())
        return super().wait(ns)

    def note_print(self, text: str) -> None:
        for piece in text.splitlines(keepends=True):
            if self._whole:
                self.printed.append(Printed(self.seconds(), piece, self._timer(sys._getframe())))
            else:
                self.printed[-1] = self.printed[-1]._replace(text=self.printed[-1].text + piece)
            self._whole = piece.endswith("\n")

    def _timer(self, frame: FrameType | None) -> Any:
        """The timer in whose call a frame is."""
        while frame:
            timer = self._ros.timer_of(frame)
            if timer is not None:
                return timer
            frame = frame.f_back
        return None

    def _note_sleep(self, frame: FrameType | None) -> None:
        while frame and frame.f_code.co_filename != _FILENAME:
            if frame.f_code in self._ros.WAITING:
                return
            frame = frame.f_back
        if frame and self._timer(frame) is None:
            self._sleeps[threading.get_ident(), frame.f_lineno] += 1

    def _note_timers(self) -> None:
        world = self.main.program
        assert isinstance(world, World)
        ticks = ticks_of(world.graph, 0)
        for timer, source, has_ended, was_asked in self._ros.timers(world, self.printed):
            calls = tuple(tick for tick in ticks if tick.source == source)
            self.timers.append(SeenTimer(timer, calls, self._state(calls, has_ended, was_asked)))

    def _state(self, calls: Sequence[Tick], has_ended: bool, was_asked: bool) -> str:
        if not has_ended and calls and math.isnan(calls[-1].duration):
            if nanoseconds(calls[-1].real) < self.now() - NS:
                return "blocked"
        if was_asked:
            return "stopped"
        return "gone" if has_ended else "running"


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
    """The answer to one exercise, which is on ROS 1 or 2.

    ``console`` is that of its first run; ``ended_early`` says whether a run was over before its time.
    """

    def __init__(self, text: Any, ros: int = 1) -> None:
        self._text = text
        self._ros_number = ros
        self.console = ""
        self.ended_early = False
        self._ran = False

    @property
    def ros(self) -> Ros:
        """What there is to know of its ROS."""
        if self._ros_number == 1:
            return in_rospy
        from . import in_rclpy

        return in_rclpy

    def run(
        self,
        seconds: float,
        *args: str,
        seed: int | None = None,
        allowed: _Allowed = _nothing,
        has_to_end: bool = True,
    ) -> Seen:
        """Run the answer as a node in simulated time; ``args`` are its command line.

        With a ``seed`` its threads take turns at any line. A node that cannot be run, or fails of an error that is not
        ``allowed``, ends the check, and so does one that Ctrl-C does not end, if it ``has_to_end``. That Ctrl-C ends it
        as its ROS has it is no failure.
        """
        seen = self.ending(seconds, *args, seed=seed)
        if has_to_end or not seen.killed:
            self._refuse(seen, args, allowed)
        self.ended_early |= not seen.interrupted and allowed is _nothing and seed is None
        return seen

    def ending(self, seconds: float, *args: str, terminated_at: float | None = None, seed: int | None = None) -> Seen:
        """Run it likewise, however it ends; SIGTERM may come before Ctrl-C. One that cannot be run ends the check."""
        node = self._load()
        if gaps := _gaps(self._text):
            lines = f"line {gaps[0]}" if len(gaps) == 1 else f"lines {', '.join(map(str, gaps))}"
            raise Fails(f"There is still a gap, `...`, in {lines}.", right=None)
        if not ast.parse(self._text).body:
            raise Fails(_NO_ANSWER, right=None)
        if seed is None:
            return self._run(node, seconds, args, terminated_at)
        code = compile(shake(self._text), _FILENAME, "exec", dont_inherit=True)
        with turns(seed):
            return self._run(node._replace(main=lambda: execute(code, _FILENAME)), seconds, args, terminated_at)

    def variables(self) -> dict[str, Any]:
        """The variables that the answer assigns. One that cannot be run, or fails, ends the check."""
        node = self._load()
        found: dict[str, Any] = {}

        def main() -> None:
            node.main()
            found.update(vars(sys.modules["__main__"]))

        self._refuse(self._run(node._replace(main=main), 0.0, ()), (), _nothing)
        return found

    def _run(self, node: Node, seconds: float, args: Sequence[str], terminated_at: float | None = None) -> Seen:
        clock = _Watched(self.ros, seconds)
        if terminated_at is not None:
            clock.terminate(terminated_at)
        listener: Any = _Listener(clock)
        try:
            with capture(listener, listener) as console, _plain_environment():
                result = run_node(node, seconds, args, clock)
        except (TimeStandsStill, NotSimulated, RuntimeError) as error:
            raise Fails(f"{_started(args)} node cannot be run: `{plain(str(error))}`", _hint_for(error)) from None
        finally:
            if not self._ran:
                self.console, self._ran = console.text(), True
        world, loops = result.world, clock.loops()
        messages = messages_of(world.graph, 0)
        how = result.status, world.errors, world.interrupted
        kept = where_it_was_kept(node, world.waited), waits_for_a_rate(node, world.waited)
        return Seen(seconds, clock.printed, clock.timers, loops, messages, *how, *kept)

    def _load(self) -> Node:
        source = self._text
        if source is ... or source is None:
            raise Fails(_NO_ANSWER, "Write it in a cell that begins with `%%answer`.", right=None)
        if not isinstance(source, str):
            raise Fails(f"The answer is a text, not {a_value(source)}.")
        read = "Python could not read the answer, so nothing ran. The error may be in the line before."
        try:
            self._refuse_the_other_ros(_imported(source))
            return load_source(source, _FILENAME)._replace(ros=self._ros_number)
        except SyntaxError as error:
            said = plain(error.msg)  # may end in a question
            raise Fails(f"Line {error.lineno} is not Python: {said}{'' if said.endswith('?') else '.'}", read) from None
        except (ValueError, RecursionError, MemoryError) as error:
            raise Fails(f"This is not Python: {plain(str(error))}.", read) from None

    def _refuse_the_other_ros(self, imported: Collection[str]) -> None:
        own, other = _MODULES[self._ros_number], _MODULES[3 - self._ros_number]
        if other not in imported:
            return
        here = f"This exercise is on ROS {self._ros_number}, where a node imports `{own}`."
        if own in imported:
            raise Fails("The node imports both `rospy` (ROS 1) and `rclpy` (ROS 2). A node has one ROS.", here)
        raise Fails(f"This node is for ROS {3 - self._ros_number}: it imports `{other}`.", here)

    def _refuse(self, seen: Seen, args: Sequence[str], allowed: _Allowed) -> None:
        """End the check if something went wrong in a run."""
        started = _started(args)
        endings = self.ros.ENDINGS if seen.interrupted else ()
        if wrong := [error for error in seen.errors if not (allowed(error) or isinstance(error, endings))]:
            raise Fails(f"{started} {self.say_error(wrong[-1])}", self._hint_for_errors(seen.errors))
        if seen.killed:
            raise Fails(f"{started} node did not end at Ctrl-C: {self.say_kept(seen)}", self.hint_for_kept(seen))
        if seen.status and not seen.errors and not endings:
            raise Fails(f"{started} node ended with status {seen.status} instead of 0.")

    def say_error(self, error: BaseException) -> str:
        """What an exception has ended, and where, as the rest of a sentence."""
        lines = [line for code, line in _frames(error) if code.co_filename == _FILENAME]
        where = f"in line {lines[-1]}:" if lines else "of"
        said = plain(traceback.format_exception_only(error)[-1])
        return f"{self._whose(error)} died {where} `{said}`."

    def say_kept(self, seen: Seen) -> str:
        """What kept a node that was killed from its end, as the rest of a sentence."""
        if seen.kept_by_rate:
            return "one of its threads was still asleep in a Rate's `sleep()`."
        asks = f"Does its loop ask `{self.ros.GOES_ON}`?"
        if seen.kept_at is None:
            return asks
        return f"it was still in line {seen.kept_at.line}, `{plain(seen.kept_at.call)}`. {asks}"

    def hint_for_kept(self, seen: Seen) -> str:
        """How to go on with a node that was killed; empty if nothing more is known."""
        if not seen.kept_by_rate:
            return ""
        return (
            "After Ctrl-C nothing wakes a Rate any more, and Python waits for the thread that is asleep. Use a Rate "
            "only in a daemon thread: `Thread(target=..., daemon=True)`."
        )

    def _whose(self, error: BaseException) -> str:
        codes = {code for code, _ in _frames(error)}
        return self.ros.whose(codes) or ("thread" if threading.Thread.run.__code__ in codes else "node")

    def _hint_for_errors(self, errors: Sequence[BaseException]) -> str:
        if not errors:
            return ""
        error = errors[-1]
        missing = ""
        if isinstance(error, (AttributeError, ImportError, NameError)):
            missing = "Python names what it did not find. Is it spelt as it is where it was made, with its `self.`?"
        return self.ros.hint(error, self._whose(error)) or missing


def _started(args: Sequence[str]) -> str:
    return f"Started with `{' '.join(args)}`, the" if args else "The"


def _imported(source: str) -> set[str]:
    """The modules that an answer imports, by the first words of their names."""
    nodes = list(ast.walk(ast.parse(source)))
    names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    names += [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
    return {name.partition(".")[0] for name in names}


def _gaps(source: str) -> list[int]:
    """The lines in which there still is a gap."""
    return [node.lineno for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Constant) and node.value is ...]


# By these a reader may have changed the console, or the namespace of every node.
_VARIABLES = ("ROSCONSOLE_FORMAT", "ROS_NAMESPACE", "RCUTILS_CONSOLE_OUTPUT_FORMAT", "RCUTILS_COLORIZED_OUTPUT")


@contextmanager
def _plain_environment() -> Iterator[None]:
    kept = {name: os.environ.pop(name) for name in _VARIABLES if name in os.environ}
    try:
        yield
    finally:
        os.environ.update(kept)


def _frames(error: BaseException) -> Iterator[tuple[CodeType, int]]:
    """The code and the line of each frame that an exception came through, outermost first."""
    trace = error.__traceback__
    while trace:
        yield trace.tb_frame.f_code, trace.tb_lineno
        trace = trace.tb_next


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
        text = f"{start}counter {plain(extra.text)} came at {say(extra.time)}; it should not have come."
        return Finding(False, text, hint)
    if len(found) < len(wanted):
        text = f"{start}counter {len(found) + 1}, due at {say(wanted[len(found)])}, did not come."
        return Finding(False, text, hint)
    if len(wanted) == 1:
        return Finding(True, f"{start}counter 1 came at {say(wanted[0])}, and no other.")
    text = f"{start}counters 1 to {len(wanted)} came from {say(wanted[0])} to {say(wanted[-1])}, each at its time."
    return Finding(True, text)
