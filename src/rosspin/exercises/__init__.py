"""The checks of the exercises in ``notebooks/exercises.md``.

An answer is a text: a node file, or predictions as assignments. A check runs it in simulated time and says what is
right, what is wrong, and how to go on; whatever the answer is, it raises nothing.
"""

from __future__ import annotations

import ast
import math
import os
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import islice
from typing import Any, NamedTuple

from ..advice import advice
from ..clocks.simulation import Simulation
from ..console import read_lines, read_ticks
from ..process import Node, capture, load_source
from ..run import TimeStandsStill, run_node, simulate
from ..ticks import Run, Tick
from ..world import NotSimulated

__all__ = ["Feedback", "Finding", "check"]

# What the reader sees as the name of the node file: in tracebacks, and where a node never sleeps.
_FILENAME = "<answer>"

# An exception on the console; one that was raised outside of the node has no frames of its own.
_TRACE = re.compile(
    r"(?:(?P<thread>^Exception in thread .*\n)(?:^Traceback .*\n)?|^Traceback .*\n)"
    r"(?P<frames>(?:^ .*\n)*)(?P<error>^\S.*$)",
    re.MULTILINE,
)

# So many lines of a console are shown.
_MOST_LINES = 30

_ENDS_EARLY = "The node ended by itself, before its time was over. Does its main part come to `rospy.spin()`?"

# Nobody means a time difference below this (s).
_CLOSE = 1e-3


class Finding(NamedTuple):
    """One thing about an answer: whether it is right, and in words (Markdown) what it is. ``hint`` is how to go on."""

    right: bool
    text: str
    hint: str = ""


@dataclass(frozen=True)
class Feedback:
    """What a check has found; it shows itself as Markdown in a notebook and as text elsewhere.

    ``number`` is that of the exercise, ``findings`` are in the order in which they were made, ``console`` is what the
    node printed in its first run.
    """

    number: int
    findings: tuple[Finding, ...]
    hint: str
    console: str = field(default="", repr=False)

    @property
    def passed(self) -> bool:
        """Whether everything is right."""
        return all(finding.right for finding in self.findings)

    @property
    def verdict(self) -> str:
        """Right or not yet, in words."""
        return f"Exercise {self.number}: {'right' if self.passed else 'not yet'}."

    def shown_console(self) -> str:
        """The console as far as it is worth showing: enough for an error, of a node that prints without end not all."""
        lines = self.console.splitlines(keepends=True)
        more = f"... and {len(lines) - _MOST_LINES} more lines\n" if len(lines) > _MOST_LINES else ""
        return "".join(lines[:_MOST_LINES]) + more

    def _repr_markdown_(self) -> str:
        lines = [f"**{self.verdict}**", ""]
        for right, text, _ in self.findings:
            lines.append(f"- {'Right' if right else 'Wrong'}: {text[0].upper()}{text[1:]}")
        if not self.passed:
            lines += ["", f"**Hint:** {self.hint}"]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return self._repr_markdown_().replace("**", "").replace("\n\n", "\n")

    __str__ = __repr__


def check(number: int, answer: Any) -> Feedback:
    """Check the answer to an exercise, a text; one that is ``...`` is not right yet.

    Raises ValueError for a number that no exercise has.
    """
    if number not in _EXERCISES:
        raise ValueError(f"there is no exercise {number!r}: they are numbered 1 to {max(_EXERCISES)}")
    exercise = _EXERCISES[number]
    given = _Answer(answer)
    findings: list[Finding] = []
    try:
        # One by one: what was found before an answer fails is kept.
        for finding in exercise.find(given):
            findings.append(finding)
    except _Fails as failure:
        findings.append(failure.finding)
    hint = next((finding.hint for finding in findings if not finding.right and finding.hint), exercise.hint)
    if given.ended_early:
        hint = _ENDS_EARLY
    return Feedback(number, tuple(findings), hint, given.console)


# --- running an answer ------------------------------------------------------------------------------------------------


class _Fails(Exception):
    """Nothing more can be found out about an answer."""

    def __init__(self, text: str, hint: str = "") -> None:
        self.finding = Finding(False, text, hint)


class _Answer:
    """The answer to one exercise. ``console`` is that of its first run."""

    def __init__(self, text: Any) -> None:
        self._text = text
        self.console = ""
        self.ended_early = False  # whether a run of it was over before its time, without a tick and without an error
        self._ran = False

    def run(self, seconds: float, *args: str) -> Run:
        """Run the answer as a node in simulated time. A node that cannot be run, or fails, ends the check."""
        node = _load(self._text)
        if gaps := _gaps(self._text):
            lines = f"line {gaps[0]}" if len(gaps) == 1 else f"lines {', '.join(map(str, gaps))}"
            raise _Fails(f"There is still a gap, `...`, in {lines}.")
        return self._run(node, seconds, args)

    def variables(self) -> dict[str, Any]:
        """The variables that the answer assigns. One that cannot be run, or fails, ends the check."""
        node = _load(self._text)
        found: dict[str, Any] = {}

        def main() -> None:
            node.main()
            found.update(vars(sys.modules["__main__"]))

        self._run(node._replace(main=main), 0.0, ())
        return found

    def _run(self, node: Node, seconds: float, args: Sequence[str]) -> Run:
        started = f"Started with `{' '.join(args)}`, the" if args else "The"
        try:
            with capture() as console, _plain_environment():
                result = run_node(node, seconds, args, Simulation())
        except (TimeStandsStill, NotSimulated, RuntimeError) as error:
            raise _Fails(f"{started} node cannot be run: `{_plain(str(error))}`", _hint_for(error)) from None
        finally:
            if not self._ran:
                self.console, self._ran = console.text(), True
        run = Run(console.text(), result.ticks, result.status, "simulated", seconds)
        if failure := _failure(run):
            raise _Fails(f"{started} {failure}", _hint_for_errors(result.world.errors))
        self.ended_early |= not result.world.interrupted and not result.ticks
        return run


def _load(source: Any) -> Node:
    if source is ... or source is None:
        raise _Fails("There is no answer yet.", "Write it in a cell that begins with `%%answer`.")
    if not isinstance(source, str):
        raise _Fails(f"The answer is a text, not {_a(source)}.")
    read = "Python could not read the answer, so nothing ran. An error may be in the line before."
    try:
        return load_source(source, _FILENAME)
    except SyntaxError as error:
        said = _plain(error.msg)  # may end in a question
        raise _Fails(f"Line {error.lineno} is not Python: {said}{'' if said.endswith('?') else '.'}", read) from None
    except (ValueError, RecursionError, MemoryError) as error:
        raise _Fails(f"This is not Python: {_plain(str(error))}.", read) from None


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


def _failure(run: Run) -> str:
    """What went wrong in a run, as the rest of a sentence; empty if nothing did."""
    if traces := list(_TRACE.finditer(run.console)):
        trace = traces[-1]
        lines = re.findall(rf'File "{_FILENAME}", line (\d+)', trace["frames"])
        place = f" in line {lines[-1]}" if lines else ""
        return f"{'timer' if trace['thread'] else 'node'} died of `{_plain(trace['error'])}`{place}."
    if "did not end the node" in run.console:
        return "node did not end at Ctrl-C: its loop does not ask `rospy.is_shutdown()`."
    return f"node ended with status {run.status} instead of 0." if run.status else ""


def _hint_for_errors(errors: Sequence[BaseException]) -> str:
    if not errors:
        return ""
    if isinstance(errors[-1], (AttributeError, ImportError, NameError)):
        missing = "Python names what it did not find. Is it spelt as it is where it was made, with its `self.`?"
        return advice(errors[-1]) or missing
    return advice(errors[-1])


def _hint_for(error: Exception) -> str:
    if isinstance(error, TimeStandsStill):
        return "Something goes on without ever sleeping: a loop without a `sleep()`, or a period of 0."
    if isinstance(error, NotSimulated):
        return "Timers, rates, sleeps and log lines are all that an answer needs."
    return ""


def _plain(text: str) -> str:
    """Text of the reader's, or of Python's, that is to stand in Markdown."""
    return " ".join(text.split()).replace("`", "'")[:300]


def _a(value: object) -> str:
    return f"a value of type `{type(value).__name__}`"


# --- looking at a run -------------------------------------------------------------------------------------------------


def _grid(period: float, seconds: float, start: float | None = None) -> list[float]:
    """Times ``period`` apart, from ``start`` (one period, if none) up to ``seconds``, both included."""
    first = period if start is None else start
    return [first + n * period for n in range(int((seconds - first) / period + 1e-6) + 1)]


def _counters(run: Run, tag: str = "SPINNER PY NODE") -> list[Tick]:
    return [tick for tick in read_ticks(run.console) if tick.source == tag]


def _on_time(found: Sequence[Tick], wanted: Sequence[float], what: str = "", hint: str = "") -> Finding:
    """Whether counters 1, 2, ... came at the times that are wanted, and no others; ``what`` begins the sentence."""
    start = f"{what}: " if what else ""
    if not found:
        return Finding(False, f"{start}no counter was printed.", hint)
    for number, (tick, time) in enumerate(zip(found, wanted, strict=False), 1):
        if tick.number != number:
            return Finding(False, f"{start}where counter {number} was due, counter {tick.number} came.", hint)
        if abs(tick.real - time) > _CLOSE:
            return Finding(False, f"{start}counter {number} came at {_s(tick.real)}, not at {_s(time)}.", hint)
    if len(found) > len(wanted):
        extra = found[len(wanted)]
        return Finding(False, f"{start}counter {extra.number} came at {_s(extra.real)}; it should not come.", hint)
    if len(found) < len(wanted):
        text = f"{start}counter {len(found) + 1}, due at {_s(wanted[len(found)])}, did not come."
        return Finding(False, text, hint)
    if len(wanted) == 1:
        return Finding(True, f"{start}counter 1 came at {_s(wanted[0])}, and no other.")
    text = f"{start}counters 1 to {len(wanted)} came from {_s(wanted[0])} to {_s(wanted[-1])}, each at its time."
    return Finding(True, text)


def _s(seconds: float) -> str:
    return f"{round(seconds, 3):.10g} s"


# --- the exercises ----------------------------------------------------------------------------------------------------


class _Exercise(NamedTuple):
    find: Callable[[_Answer], Iterator[Finding]]
    hint: str


_EXERCISES: dict[int, _Exercise] = {}


def _exercise(
    number: int, hint: str
) -> Callable[[Callable[[_Answer], Iterator[Finding]]], Callable[[_Answer], Iterator[Finding]]]:
    def add(find: Callable[[_Answer], Iterator[Finding]]) -> Callable[[_Answer], Iterator[Finding]]:
        _EXERCISES[number] = _Exercise(find, hint)
        return find

    return add


@_exercise(1, "A timer takes a period in seconds, not a frequency: the period is 1 / frequency.")
def _change_the_rate(answer: _Answer) -> Iterator[Finding]:
    yield _on_time(_counters(answer.run(1.0)), _grid(0.1, 1.0))


@_exercise(2, "`rospy.Timer` has a parameter `oneshot`; its period is then the time until the only call.")
def _one_shot(answer: _Answer) -> Iterator[Finding]:
    yield _on_time(_counters(answer.run(5.0)), [1.5])


@_exercise(3, "Keep the timer in `self.timer`, and call its `shutdown()` in the callback that is to be the last.")
def _stop_after_five(answer: _Answer) -> Iterator[Finding]:
    run = answer.run(6.0)
    yield _on_time(_counters(run), _grid(0.5, 2.5))
    stops = "`rospy.signal_shutdown()` and `sys.exit()` end more than the one timer."
    yield _on_time(_counters(run, "HEARTBEAT"), _grid(1.0, 6.0), "The heartbeat", stops)
    calls = len(run.ticks)
    if calls > 11:
        text = f"the callbacks of both timers were called {calls} times in 6 s; 5 calls and 6 heartbeats make 11."
        yield Finding(False, text, "A callback that returns at once is still called. Stop the timer itself.")
    else:
        yield Finding(True, "a timer that has been stopped calls back no more.")


@_exercise(4, "What stands in the loop goes into a callback, the loop goes, and `rospy.spin()` takes its place.")
def _rate_to_timer(answer: _Answer) -> Iterator[Finding]:
    run = answer.run(2.0)
    spin = "Does the main part come to `rospy.spin()`? Without it the node is over at once." if not run.ticks else ""
    yield _on_time(_counters(run), _grid(0.5, 2.0), hint=spin)
    sources = {tick.source for tick in run.ticks}
    if any(source.startswith("Rate") for source in sources):
        yield Finding(False, "a loop with a `rospy.Rate` still runs.")
    elif sources:
        yield Finding(True, "a timer calls back, and no rate is left.")
    else:
        yield Finding(False, "no timer calls back.", spin)


@_exercise(
    5, "`rospy.get_param(name, default)`; the name of a private parameter begins with `~`; the default is in Hz, too."
)
def _frequency_from_a_parameter(answer: _Answer) -> Iterator[Finding]:
    yield _on_time(_counters(answer.run(2.0)), _grid(0.5, 2.0), "Without the parameter")
    private = "Does the name begin with `~`? Is it a frequency that you read, and a period that the timer is given?"
    for frequency, seconds in ((10, 1.0), (0.5, 4.0)):
        word = f"_frequency:={frequency}"
        run = answer.run(seconds, word)
        yield _on_time(_counters(run), _grid(1 / frequency, seconds), f"With `{word}`", private)


@_exercise(6, "A node can have as many timers as it likes, each with its own period, callback and counter.")
def _two_rates(answer: _Answer) -> Iterator[Finding]:
    run = answer.run(2.0)
    own = "Give each timer a counter of its own."
    for tag, frequency in (("FAST", 10), ("SLOW", 2)):
        counters = _counters(run, tag)
        times = [tick.real for tick in counters]
        wanted = _grid(1 / frequency, 2.0)
        shared = len(times) == len(wanted) and all(map(lambda a, b: abs(a - b) < _CLOSE, times, wanted))
        yield _on_time(counters, wanted, f"`[{tag}]`", own if shared else "")


# The ticks after one slow callback that other rules would give, and what to say to those who predict them.
_QUEUE = "this is what a queue of calls would give; there is none. Ticks are lost here."
_ROSCPP = "this is what roscpp does: it counts anew from the late call. rospy does so only after a longer block."
_DROP = "this is what ROS 2 does: it drops ticks and keeps to the grid. rospy does not."
_SHORT = "two calls in a row are what follows a shorter block. More than 2 periods behind, rospy counts anew."
_UNMOVED = "a timer has one thread, and the slow callback keeps it busy. It cannot be called again before it returns."
_BELIEFS = {
    1.2: {(2.0, 2.5, 3.0): _UNMOVED, (2.7, 3.2, 3.7): _ROSCPP, (2.7, 3.0, 3.5): _DROP},
    2.2: {
        (2.0, 2.5, 3.0): _UNMOVED,
        (3.7, 3.7, 3.7): _QUEUE,
        (3.7, 4.0, 4.5): _DROP,
        (3.7, 3.7, 4.0): _SHORT,
        (3.7, 3.7, 4.2): _SHORT,
    },
}


@_exercise(7, "The callback ends at 1.5 s plus the time it blocks. Which ticks were due by then?")
def _ticks_after_a_slow_callback(answer: _Answer) -> Iterator[Finding]:
    variables = answer.variables()
    for blocks_for, beliefs in _BELIEFS.items():
        what = f"blocked for {_s(blocks_for)}"
        value = variables.get(f"after_{blocks_for}_seconds".replace(".", "_"))
        if value is ... or value is None:
            yield Finding(False, f"{what}: there is no prediction yet.")
            continue
        predicted = _times(value)
        if predicted is None:
            text = f"{what}: the prediction is a list of three times in seconds, not {_a(value)}."
            yield Finding(False, text, "Write it as `[1.0, 2.0, 3.0]`.")
            continue
        real = [tick.real for tick in simulate(_blocking_node(blocks_for), 5.0).ticks[3:6]]
        yield _compare_prediction(what, predicted, real, beliefs)


def _blocking_node(seconds: float) -> Callable[[], None]:
    """The node of exercise 7."""

    def node() -> None:
        import rospy  # type: ignore[import-not-found]

        rospy.init_node("spinner_py_node")
        counter = 0

        def callback(event: object) -> None:
            nonlocal counter
            counter += 1
            if counter == 3:
                rospy.sleep(seconds)

        rospy.Timer(rospy.Duration(0.5), callback)
        rospy.spin()

    return node


def _times(value: Any) -> list[float] | None:
    """A prediction as numbers; None if it is none."""
    try:
        times = [float(time) for time in islice(iter(value), 100)]
    except Exception:  # whatever the value is
        return None
    return times if not isinstance(value, (str, bytes)) and all(map(math.isfinite, times)) else None


def _compare_prediction(
    what: str, predicted: list[float], real: list[float], beliefs: dict[tuple[float, float, float], str]
) -> Finding:
    def same(times: Sequence[float]) -> bool:
        return len(predicted) == len(times) and all(
            abs(one - other) < 0.01 for one, other in zip(predicted, times, strict=True)
        )

    said = ", ".join(map(_s, predicted))
    if same(real):
        return Finding(True, f"{what}: the ticks come at {said}.")
    if len(predicted) != len(real):
        return Finding(False, f"{what}: {len(real)} times are asked for, not {len(predicted)}.")
    for times, why in beliefs.items():
        if same(times):
            return Finding(False, f"{what}: {said}: {why}")
    first = next(n for n, (one, other) in enumerate(zip(predicted, real, strict=True)) if abs(one - other) >= 0.01)
    return Finding(False, f"{what}: tick {4 + first} does not come at {_s(predicted[first])}.")


@_exercise(8, "`event.current_real - event.current_expected` is how late this call is. How many whole periods is that?")
def _count_missing_ticks(answer: _Answer) -> Iterator[Finding]:
    for blocks_for in (2.2, 1.2, 0.9):
        word = f"_blocks_for:={blocks_for}"
        run = answer.run(5.0, word)
        found = [line.text.rpartition(" = ")[2] for line in read_lines(run.console) if "] missing = " in line.text]
        wanted = [str(int(tick.lateness / 0.5 + 1e-6)) for tick in run.ticks]
        yield _compare_missing(f"With `{word}`", found, wanted)


def _compare_missing(what: str, found: Sequence[str], wanted: Sequence[str]) -> Finding:
    if not found:
        return Finding(False, f"{what}: no line with `missing = ` was printed.")
    if len(found) != len(wanted):
        return Finding(False, f"{what}: {len(wanted)} callbacks printed {len(found)} lines with `missing = `.")
    for number, (said, true) in enumerate(zip(found, wanted, strict=True), 1):
        if said != true:
            why = "" if said.isdigit() else "A tick is missing or not: the number is a whole one. "
            text = f"{what}: callback {number} printed `missing = {_plain(said)}`, but {true} were missing."
            return Finding(False, text, why and why + _EXERCISES[8].hint)
    return Finding(True, f"{what}: the callbacks printed {', '.join(found)}.")


@_exercise(9, "Before it sleeps, move the deadline on by whole periods until it lies ahead.")
def _survive_an_overrun(answer: _Answer) -> Iterator[Finding]:
    for work in (0.7, 1.7, 0.1):
        word = f"_work:={work}"
        back = math.ceil((1.0 + work) / 0.5) * 0.5
        wanted = [0.0, 0.5, 1.0, *_grid(0.5, 5.0, start=back)]
        counters = _counters(answer.run(5.0, word))
        hint = ""
        for tick, after in zip(counters, counters[1:], strict=False):
            if after.real - tick.real < 0.5 - _CLOSE and after.real > 1.0:
                hint = "A lost pass is not to be made up for: two passes in a row would send two commands at once."
        if not hint and counters and abs(counters[-1].real / 0.5 - round(counters[-1].real / 0.5)) > _CLOSE:
            hint = "The loop has left its grid of 0.5 s: count deadlines on from the old one, not from now."
        yield _on_time(counters, wanted, f"With `{word}`", hint)
