"""Run an answer, and note what it does: who prints what, which timers call back, and how each ends."""

from __future__ import annotations

import io
import math
import os
import random
import re
import signal
import sys
import threading
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property, partial
from itertools import islice
from json import dumps
from types import CodeType, FrameType
from typing import Any, Protocol, TypeVar

from ..clocks.clock import NS, nanoseconds
from ..clocks.explored import ExploredSimulation, Order
from ..clocks.frames import as_printed
from ..clocks.programs import press_ctrl_c
from ..clocks.signals import send
from ..results.ticks import Call, Message, Tick
from ..run.beside import run_beside
from ..run.explain import TimeStandsStill, waits_for_a_rate, where_it_was_kept
from ..run.host import Result
from ..run.shaking import shaken
from ..run.simulate import run_node
from ..run.source import Code, NodeLike, code_of_program, load_source
from ..run.streams import capture
from ..vehicle import ros1, ros2
from ..vehicle.drives import NODE, OTHERS, Drive
from ..world.graph import RecordedEndpoint, TickLog
from ..world.world import NotSimulated, World, current_world
from . import in_rospy
from .advice import not_called, not_found
from .judging import MADE_AGAIN, MANY_TIMERS, language_of, not_python, plain, started
from .observed import Called, Error, Kept, ObservedEndpoint, ObservedRun, ObservedTimer, Printed, Sent, Value
from .traces import LONGEST, Failure, Outcome, Request
from .watched import Watched

__all__ = ["Runner"]

# The name of the node file as the reader sees it: in tracebacks, and in the error of a node that never sleeps.
_FILENAME = "<answer>"
_FILE_OF_PROGRAM = "answer.cpp"

# A thread that has slept so often in one line of the answer runs a loop there.
_LOOPS = 3

# How many lines and characters of a console are shown.
_MOST_LINES = 30
_LONGEST_CONSOLE = 25_000

# How much is kept of the runs of one answer, in characters of JSON. Only lists count; the rest is small.
_ROOM = LONGEST * 3 // 4

# How many characters of a line are kept, and how many items of what no exercise looks at closely.
_LONGEST_LINE = 1000
_LEAST_LINE = 20  # besides its text
_MOST = 100

# The nodes that can run together with an answer, by the ROS and the name.
_BESIDE: dict[tuple[int, str], NodeLike] = {
    (2, "vehicle"): ros2.vehicle,
    (2, "silent vehicle"): partial(ros2.vehicle, silent=(3.0, 5.0)),
    (2, "vehicle, silent earlier"): partial(ros2.vehicle, silent=(2.0, 3.5)),
    (2, "joystick"): ros2.joystick,
    (2, "tablet"): partial(ros2.joystick, pressed=(2.0, 3.5), name="tablet"),
    (1, "vehicle"): ros1.vehicle,
}

_FIRST = "Nothing ran. Begin with the compiler's first error: others may follow from it. It may be in the line before."

# How long (s) a node stalls.
_STALL = 0.93

# When (ns) it is first looked whether a timer is endless: in ROS 1 such a timer is called every 1 ns.
_LOOKS = (25_000, 250_000)

Item = TypeVar("Item")


class Ros(Protocol):
    """What has to be known about a ROS to see what a node does.

    ``ENDINGS`` are the exceptions with which Ctrl-C may end a node; ``WAITING`` is the code that waits for its end.
    """

    ENDINGS: tuple[type[BaseException], ...]
    WAITING: Collection[CodeType]

    def timer_of(self, frame: FrameType) -> Any:
        """Return the timer that calls back from a frame; None if no timer does."""

    def timers(self, world: World, printers: Iterable[Any]) -> list[Watched]:
        """Return the started timers. ``printers`` are those that have printed something."""

    def heard_in(self, frame: FrameType) -> Any:
        """Return the message with which a subscription calls back from a frame; None if none does."""

    def parameters(self, world: World) -> list[str]:
        """Return the parameters that were declared, or asked for where none is declared."""

    def in_words(self, qos: Any) -> str:
        """Return the QoS of an endpoint in words; empty if there is none."""

    def whose(self, codes: Collection[CodeType]) -> str:
        """Return what of ROS an exception has ended in a node, by the code that it came through; empty if nothing."""

    def hint(self, error: BaseException, whose: str) -> str:
        """Return a hint for whoever meets an exception; empty if there is none."""


# --- what a run shows -------------------------------------------------------------------------------------------------


class _Watched(ExploredSimulation):
    """A simulated clock that notes what happens on it."""

    def __init__(self, ros: Ros, until: float, seed: int | None) -> None:
        draw = random.Random(seed)
        decide = None if seed is None else lambda point, options: draw.randrange(len(options))
        super().__init__(Order(decide=decide, deep=seed is not None))
        self.printed: list[Printed] = []
        self.timers: list[ObservedTimer] = []
        self.parameters: tuple[str, ...] = ()
        self.cut = False
        self.world: World | None = None  # the answer's, as soon as it runs
        self.first = 0  # the thread in which its main part runs
        self._ros = ros
        self._timers: dict[int, tuple[int, Any]] = {}  # the timers met so far and their numbers, by id
        self._sleeps: Counter[tuple[int, int, bool]] = Counter()
        self._whole = True  # whether the last line was printed to its end
        self._left = _ROOM  # so many characters may still be printed
        self.at(nanoseconds(until), self._note_timers)  # before Ctrl-C, which comes at the same time
        if seed is None:
            for time in (*_LOOKS, *range(NS // 2, nanoseconds(until), NS // 2)):
                self.at(time, self._stop_if_endless)

    def terminate(self, at: float) -> None:
        """Send the node SIGTERM at a time (s)."""
        self._at_answer(at, lambda world: send(world, signal.SIGTERM))

    def press(self, at: float) -> None:
        """Press Ctrl-C at a time (s) in the answer alone."""
        self._at_answer(at, press_ctrl_c)

    def _at_answer(self, at: float, act: Callable[[World], None]) -> None:
        def do() -> None:
            if self.world and not self.world.over:
                act(self.world)

        self.at(nanoseconds(at), do)

    def stall(self, at: float) -> None:
        """Let time pass at a time (s) while nothing runs, as on a machine that is busy with something else."""
        self.at(nanoseconds(at), lambda: self._move(self.now() + nanoseconds(_STALL)))

    def horizon(self) -> int:
        """A node in C++ never runs on its own: what it prints is noted when it prints it."""
        return self.now()

    def sleeps(self, of_timers: bool) -> list[int]:
        """Return the lines of the answer in which timers' callbacks, or else all others, slept again and again."""
        return sorted({line for (_, line, of), count in self._sleeps.items() if count >= _LOOPS and of is of_timers})

    def sleeps_aside(self) -> list[int]:
        """Return the lines in which another thread than the node's first slept again and again."""
        threads = {(thread, line) for (thread, line, _), count in self._sleeps.items() if count >= _LOOPS}
        return sorted({line for thread, line in threads if thread != self.first})

    def sleep(self, ns: int) -> None:
        self._note_sleep(sys._getframe())
        super().sleep(ns)

    def wait(self, ns: int | None = None) -> bool:
        self._note_sleep(sys._getframe())
        return super().wait(ns)

    def numbers(self) -> dict[Any, int]:
        """Return the numbers of the timers met so far, by what stands for them."""
        return {timer: number for number, timer in self._timers.values()}

    def note_print(self, text: str) -> None:
        for piece in text.splitlines(keepends=True):
            self._left -= min(len(piece), _LONGEST_LINE) + _LEAST_LINE
            if self._whole:
                if self._left < 0:
                    self.cut = True
                    return
                timer, heard = self._caller(sys._getframe())
                self.printed.append(Printed(self.seconds(), _cut(piece), self._number(timer), heard))
            else:
                self.printed[-1] = self.printed[-1]._replace(text=_cut(self.printed[-1].text + piece))
            self._whole = piece.endswith("\n")

    def _caller(self, frame: FrameType | None) -> tuple[Any, str]:
        """Return the timer whose call a frame belongs to, or None, and what the message holds of which it is told."""
        while frame:
            timer, message = self._ros.timer_of(frame), self._ros.heard_in(frame)
            if timer is not None or message is not None:
                return timer, _data(message)
            frame = frame.f_back
        return None, ""

    def _number(self, timer: Any) -> int:
        if timer is None:
            return 0
        number, _ = self._timers.setdefault(id(timer), (len(self._timers) + 1, timer))
        return number

    def _note_sleep(self, frame: FrameType | None) -> None:
        while frame and frame.f_code.co_filename != _FILENAME:
            if frame.f_code in self._ros.WAITING:
                return
            frame = frame.f_back
        if frame:
            self._sleeps[threading.get_ident(), frame.f_lineno, self._caller(frame)[0] is not None] += 1

    def _stop_if_endless(self) -> None:
        """Press Ctrl-C if a timer is called without a pause: what it does a thousand times says no more."""
        self._note_timers()
        if self.world and self._has_endless() and not self.world.interrupted:
            press_ctrl_c(self.world)

    def _has_endless(self) -> bool:
        return any(timer.is_endless for timer in self.timers)

    def _note_timers(self) -> None:
        if not (world := self.world) or self._has_endless():  # it has been told to end
            return
        ticks = world.recording.ticks()
        printers = [timer for _, timer in self._timers.values()]
        self.parameters = tuple(map(plain, self._ros.parameters(world)))[:_MOST]
        self.timers = []
        for timer, source, has_ended, was_asked, period, node in self._ros.timers(world, printers):
            calls = [tick for tick in ticks if tick.source == source]
            state = self._state(calls, has_ended, was_asked)
            observed = ObservedTimer(self._number(timer), tuple(tick.real for tick in calls), state, period, node)
            self.timers.append(observed._replace(calls=observed.calls[:2]) if observed.is_endless else observed)

    def _state(self, calls: Sequence[Tick], has_ended: bool, was_asked: bool) -> str:
        if not has_ended and calls and math.isnan(calls[-1].duration):
            if nanoseconds(calls[-1].real) < self.now() - NS:
                return "blocked"
        if was_asked:
            return "stopped"
        return "gone" if has_ended else "running"


# What sets colours on a terminal, as roscpp prints it.
_COLOURS = re.compile("\x1b\\[[\\d;]*m")


class _Listener(io.TextIOBase):
    """A stream that tells a clock what is printed."""

    def __init__(self, clock: _Watched) -> None:
        self._clock = clock

    def write(self, text: str) -> int:
        self._clock.note_print(_COLOURS.sub("", text))
        return len(text)


# --- running an answer ------------------------------------------------------------------------------------------------


class Runner:
    """Runs the answer to one exercise, which is on ROS 1 or 2; ``console`` and ``cut`` go into its trace."""

    def __init__(self, text: str, ros: int) -> None:
        self.console = ""
        self.cut = False
        self._text = text
        self._language = language_of(text)
        self._ros_number = ros
        self._room = _ROOM
        self._ran = False
        self._warned = ""  # what its compiler has said

    @cached_property
    def _ros(self) -> Ros:
        ros: Ros = in_rospy
        if self._ros_number == 2:
            from . import in_rclpy

            ros = in_rclpy
        if self._language:
            from .in_cpp import InCpp

            ros = InCpp(ros)
        return ros

    def __call__(self, request: Request) -> Outcome:
        """Run the answer as requested, and return the outcome."""
        try:
            run, failure = self._run(request), None
        except _Failed as failed:
            run, failure = None, failed.failure
        return Outcome(request, run, failure)

    def _run(self, request: Request) -> ObservedRun:
        node = self._node
        clock = _Watched(self._ros, request.seconds, request.seed)
        if request.terminated_at is not None:
            clock.terminate(request.terminated_at)
        if request.interrupted_at is not None:
            clock.press(request.interrupted_at)
        if request.stalls_at is not None:
            clock.stall(request.stalls_at)
        if request.seed is not None:
            node = self._shaken
        variables: list[tuple[str, Value]] = []

        def main() -> None:
            clock.world, clock.first = current_world(), threading.get_ident()
            node.main()  # a program in C++ ends here
            found = vars(sys.modules["__main__"])
            variables.extend((name, _value(found[name])) for name in request.variables if name in found)

        listener: Any = _Listener(clock)
        try:
            with capture(listener, listener) as console, _plain_environment():
                result = self._beside(node._replace(main=main), request, clock)
        except (TimeStandsStill, NotSimulated, RuntimeError) as error:
            said = str(error)
            if isinstance(error, TimeStandsStill) and not said.startswith((_FILENAME, _FILE_OF_PROGRAM)):
                said = said.partition(": ")[2]  # another node than the answer ran then
            text = f"{started(request.args)} node cannot be run: `{plain(said)}`"
            raise _Failed(text, MADE_AGAIN if len(clock.timers) > MANY_TIMERS else _hint_for(error)) from None
        finally:
            if not self._ran:
                self.console, self._ran = _shown(self._warned + console.text()), True
        return self._observed(request, node, clock, result, variables)

    def _beside(self, node: Code, request: Request, clock: _Watched) -> Result:
        """Run the answer, with the others that the request names."""
        if not request.beside:
            return run_node(node, request.seconds, request.args, clock, TickLog())
        others = [_BESIDE[self._ros_number, name] for name in request.beside]
        return run_beside(node, request.args, others, request.seconds, clock, TickLog())

    def _observed(
        self, request: Request, node: Code, clock: _Watched, result: Result, variables: list[tuple[str, Value]]
    ) -> ObservedRun:
        world = result.world
        kept_at = where_it_was_kept(node, world.waited)
        self.cut |= clock.cut
        timers, errors = self._fitting(clock.timers), self._fitting(map(self._error, world.errors))
        if self._language:
            from . import in_cpp

            timers = in_cpp.that_stopped(timers, clock.numbers(), clock.printed, world)
            errors = in_cpp.errors(world, clock.printed, node.filename)
        endpoints = self._fitting(map(self._endpoint, world.recording.endpoints))
        messages = result.messages()
        own = [message for message in messages if not request.beside or message.node not in (NODE, *OTHERS)]
        sent, calls = self._fitting(map(_sent, own)), self._fitting(map(_called, result.calls()))
        spots, commands = Drive.of(messages if request.beside else ())
        printed = self._fitting(clock.printed)
        return ObservedRun(
            request.seconds,
            printed,
            timers,
            tuple(clock.sleeps(of_timers=False)[:_MOST]),
            tuple(clock.sleeps(of_timers=True)[:_MOST]),
            endpoints,
            clock.parameters,
            sent,
            calls,
            result.status,
            errors,
            world.interrupted,
            kept_at and Kept(kept_at.line, plain(kept_at.call)),
            waits_for_a_rate(node, world.ros, world.waited),
            tuple(variables),
            Drive(self._fitting(spots), self._fitting(commands)),
            self._language.name if self._language else "python",
            tuple(clock.sleeps_aside()[:_MOST]),
        )

    def _endpoint(self, made: RecordedEndpoint) -> ObservedEndpoint:
        qos = self._ros.in_words(made.qos)
        return ObservedEndpoint(plain(made.topic), made.publishes, made.made, qos, made.joined, made.refused)

    def _fitting(self, items: Iterable[Item]) -> tuple[Item, ...]:
        """Return the first items, as many as fit into half of the room. The other half is for what comes later."""
        kept, room = [], self._room // 2
        for item in items:
            size = len(dumps(item)) + 1
            if size > room:
                self.cut = True
                break
            room -= size
            self._room -= size
            kept.append(item)
        return tuple(kept)

    @cached_property
    def _node(self) -> Code:
        if self._language:
            try:
                program = self._language.program(_FILE_OF_PROGRAM, lambda: None, self._text, closed=True)
                self._warned = f"{program.warnings}\n" if program.warnings else ""
                return code_of_program(program)
            except NotSimulated as error:
                raise _Failed(f"This is not simulated: `{plain(str(error))}`.", _hint_for(error)) from None
            except ValueError as error:
                self.console, self._ran = _shown(str(error)), True
                raise _Failed(*_not_compiled(str(error))) from None
        try:
            return load_source(self._text, _FILENAME)._replace(hint=self._ros_number)
        except SyntaxError as error:
            raise _Failed(*not_python(error)) from None

    @cached_property
    def _shaken(self) -> Code:
        return shaken(self._node)

    def _error(self, error: BaseException) -> Error:
        frames = list(_frames(error))
        line = next((line for code, line in reversed(frames) if code.co_filename == _FILENAME), 0)
        codes = {code for code, _ in frames}
        whose = self._ros.whose(codes) or ("thread" if threading.Thread.run.__code__ in codes else "node")
        hint = ""
        with suppress(Exception):  # an error, and what it names, may be the answer's own
            hint = self._ros.hint(error, whose) or not_found(error, self._text) or not_called(error, self._text, line)
        said = plain([*as_printed(error).format_exception_only()][-1])
        is_ending = isinstance(error, self._ros.ENDINGS)
        return Error(_type(error), said, line, whose, is_ending, hint)


class _Failed(Exception):
    """An answer cannot be run."""

    def __init__(self, text: str, hint: str) -> None:
        self.failure = Failure(text, hint)


def _not_compiled(said: str) -> tuple[str, str]:
    """Return what to say about a text that the compiler cannot read, and how to continue."""
    from ..cpp import faults  # a page has a compiler of its own

    line, column, what = faults.first(said, _FILE_OF_PROGRAM)
    where = f"Line {line}, column {column}, does not compile" if line else "It does not compile"
    return f"{where}: `{plain(what)}`.", faults.advice(said) or _FIRST


# A reader may have set these, which change the console or the namespace of every node.
_VARIABLES = ("ROSCONSOLE_FORMAT", "ROS_NAMESPACE", "RCUTILS_CONSOLE_OUTPUT_FORMAT", "RCUTILS_COLORIZED_OUTPUT")


@contextmanager
def _plain_environment() -> Iterator[None]:
    kept = {name: os.environ.pop(name) for name in _VARIABLES if name in os.environ}
    try:
        yield
    finally:
        os.environ.update(kept)


def _frames(error: BaseException) -> Iterator[tuple[CodeType, int]]:
    """Yield the code and the line of each frame that an exception came through, outermost first."""
    trace = error.__traceback__
    while trace:
        yield trace.tb_frame.f_code, trace.tb_lineno
        trace = trace.tb_next


def _hint_for(error: Exception) -> str:
    if isinstance(error, TimeStandsStill):
        return "Something runs without ever sleeping: a loop without a `sleep()`, or a period of 0."
    if isinstance(error, NotSimulated):
        return "Timers, rates, sleeps, topics, services, in ROS 2 actions, and log lines are all that an answer needs."
    return ""


# --- what is kept of it -----------------------------------------------------------------------------------------------


def _shown(console: str) -> str:
    """Cut a console to what is worth showing: enough to see an error, not all that an endless node prints."""
    lines = _COLOURS.sub("", console).splitlines(keepends=True)
    more = f"... and {len(lines) - _MOST_LINES} more lines\n" if len(lines) > _MOST_LINES else ""
    text = "".join(lines[:_MOST_LINES])
    return (text if len(text) <= _LONGEST_CONSOLE else f"{text[:_LONGEST_CONSOLE]} ...\n") + more


def _cut(line: str) -> str:
    return line if len(line) <= _LONGEST_LINE else f"{line[:_LONGEST_LINE]} ..."


def _type(value: object) -> str:
    name = type(value).__name__  # a metaclass may have made it anything
    return plain(name) if type(name) is str else "object"


def _sent(message: Message) -> Sent:
    topic, _, time, content = message
    return Sent(topic, time, str(getattr(content, "_type", _type(content))), _data(content))


def _data(message: Any) -> str:
    """Return the field ``data`` of a message as a text."""
    data = getattr(message, "data", None)
    return _cut(str(data)) if type(data) in (bool, int, float, str) else ""


def _called(call: Call) -> Called:
    return Called(call.service, call.asked, call.answered if call.server else None)


def _value(value: Any) -> Value:
    """Describe the value of a variable. Call this within the run: the type may be the answer's own."""
    with suppress(Exception):
        if type(value) is str:
            return Value("str", _cut(value))
        plainly = _unwrapped(value)
        if type(plainly) in (list, tuple, range):
            return Value(_type(value), numbers=tuple(_number(each) for each in islice(plainly, _MOST)))
        if type(value) in (int, float):
            return Value(_type(value), repr(value))
    return Value(_type(value))


def _unwrapped(value: Any) -> Any:
    """Turn an array, or a number from one, into Python's own types. Other values stay as they are."""
    return value.tolist() if hasattr(type(value), "tolist") else value


def _number(value: Any) -> float:
    """Return a number of any type as a float. Raises an exception for anything else, and for one that is not finite."""
    value = _unwrapped(value)
    if type(value) is bool or not hasattr(type(value), "__float__") or not math.isfinite(number := float(value)):
        raise ValueError(value)
    return number
