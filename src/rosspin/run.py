"""Run a node file or a function under a clock, and what comes of it: its console and its ticks."""

from __future__ import annotations

import contextvars
import ctypes
import io
import linecache
import math
import os
import signal
import sys
import threading
import tokenize
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any, NamedTuple, TextIO

from . import rospy
from .clock import NS, WallClock, nanoseconds
from .rospy import client, core, exceptions, genpy, names, rostime, timer
from .rospy.threads import own_frames, print_traceback
from .rospy.world import Handler, NotSimulated, World, current, handle_process_signals
from .simulation import Simulation, Standstill, running
from .stacks import Stack
from .virtual_time import virtual_time
from .watchdog import Stuck, watch

__all__ = ["Node", "Run", "Tick", "TimeStandsStill", "load", "measure", "simulate"]

# After Ctrl-C roslaunch waits 15 s, asks once more with SIGTERM, and kills after another 2 s.
_PATIENCE = 17

# What a node may import beside rospy and would not find.
_ROS_PACKAGES = {
    *("actionlib", "cv_bridge", "dynamic_reconfigure", "message_filters", "rosbag", "rosgraph", "roslaunch", "roslib"),
    *("rosnode", "rosparam", "rospkg", "rosservice", "rostopic", "tf", "tf2_ros", "tf_conversions"),
}


# A run that does not get on by so much (ns) in seconds of real time will not end.
_LEAST_STEP = 1_000_000


class TimeStandsStill(RuntimeError):
    """A node keeps simulated time from going on; the message says where."""

    def __init__(self, where: str, now: int) -> None:
        super().__init__(
            f"{where}{': ' if where else ''}simulated time stands still at {now / NS} s, because the node goes on "
            "without sleeping. Sleep in every loop (rate.sleep(), rospy.sleep(0.1)), and give timers and rates a "
            "period above 0."
        )


class Tick(NamedTuple):
    """One call of a timer's callback, or one pass of a loop. Times are in seconds since the run began.

    ``source`` is what ticked, ``number`` counts from 1, ``expected`` is when it should have begun and ``real`` when it
    did, ``duration`` how long it took (s; NaN if it had not ended when the run did).
    """

    source: str
    number: int
    expected: float
    real: float
    duration: float

    @property
    def lateness(self) -> float:
        """real - expected, in seconds."""
        return self.real - self.expected


@dataclass(frozen=True)
class Run:
    """What a node did in one run.

    ``console`` is what it printed, stdout and stderr in their order; ``ticks`` are in the order in which they began;
    ``status`` is its exit status; ``runtime`` says where it ran ("simulated", "wall", "ros1"); ``seconds`` is the time
    after which Ctrl-C was pressed; ``start`` is when the run began, in seconds since the epoch (0.0 when simulated).
    """

    console: str = field(repr=False)
    ticks: Sequence[Tick] = field(repr=False)
    status: int
    runtime: str
    seconds: float
    start: float = 0.0


class Node(NamedTuple):
    """What can be run: the node's own code, the first word of its command line, the file that the code is in."""

    main: Callable[[], Any]
    argv0: str
    filename: str
    folder: str | None  # of the node file: its neighbours can be imported


NodeLike = str | os.PathLike[str] | Callable[[], Any]


def load(node: NodeLike) -> Node:
    """The node in a file, or a function as a node. Raises OSError or SyntaxError for a file that is none."""
    if callable(node):
        code = getattr(node, "__code__", None)
        return Node(node, getattr(node, "__name__", "node"), code.co_filename if code else "", None)
    path = os.fspath(node)
    with tokenize.open(path) as file:
        return load_source(file.read(), path)


def load_source(source: str, filename: str) -> Node:
    """The node in a text. SyntaxError if it is not Python."""
    code = compile(source, filename, "exec", dont_inherit=True)
    linecache.cache[filename] = (len(source), None, source.splitlines(keepends=True), filename)
    folder = str(Path(filename).resolve().parent) if os.path.exists(filename) else None
    return Node(lambda: _execute(code, filename), filename, filename, folder)


def _execute(code: CodeType, filename: str) -> None:
    module = ModuleType("__main__")
    module.__file__ = filename
    sys.modules["__main__"] = module
    exec(code, module.__dict__)


def simulate(node: NodeLike, seconds: float, args: Sequence[str] = ()) -> Run:
    """Run a node for ``seconds`` of simulated time, which begins at 0 and takes next to none.

    ``node`` is the path of a node file, or a function; ``args`` are its command line, such as ``"__ns:=/mrp"``. What
    falls due exactly at ``seconds`` still runs, then Ctrl-C is pressed. A node that ends earlier ends the run. Its
    exceptions are printed, as on a real ROS, and give status 1.

    Raises OSError or SyntaxError for a file that is none, ValueError for ``seconds`` that are negative or no number,
    :class:`TimeStandsStill` for a node that never sleeps, :class:`NotSimulated` for one that needs a real ROS.
    """
    loaded = load(node)
    with capture() as console:
        result = run_simulated(loaded, seconds, args, record=True)
    return Run(console.text(), result.ticks, result.status, "simulated", seconds)


def measure(node: NodeLike, seconds: float, args: Sequence[str] = ()) -> Run:
    """Run a node for ``seconds`` on the wall clock: its ticks show the jitter of this machine.

    As :func:`simulate`, but it takes that long, and must be called in the main thread (else RuntimeError).
    """
    loaded = load(node)
    _duration(seconds)  # run_wall takes None as for ever
    with capture() as console:
        result = run_wall(loaded, seconds, args, record=True)
    return Run(console.text(), result.ticks, result.status, "wall", seconds, result.start)


class Result(NamedTuple):
    """How a run ended: exit status, ticks (none if not recorded), start in seconds since the epoch."""

    status: int
    ticks: tuple[Tick, ...]
    start: float


def run_simulated(
    node: Node,
    seconds: float,
    args: Sequence[str],
    record: bool,
    simulation: Simulation | None = None,
) -> Result:
    """Run a loaded node in simulated time; its console goes where ``sys.stdout`` and ``sys.stderr`` do."""
    until = _duration(seconds)
    simulation = simulation or Simulation()
    handlers: list[Handler] = []
    status = 0

    def main(stack: Stack) -> None:
        nonlocal status
        current.set(world)
        simulation.at(until, lambda: simulation.interrupt(stack, press_ctrl_c))
        simulation.at(until + _PATIENCE * NS, kill)
        status = _run_main(node, world)

    def press_ctrl_c() -> None:
        world.over = True
        if not handlers:
            raise KeyboardInterrupt
        handlers[-1](signal.SIGINT, None)

    def kill() -> None:
        raise _Killed

    with _process_of(node, args), virtual_time():
        world = World(simulation, sys.argv, handlers.append)
        world.ticks = [] if record else None
        try:
            with watch(lambda: simulation.now() // _LEAST_STEP) as watchdog:
                simulation.run(main)
        except _Killed:
            status = _say_killed(seconds)
        except Standstill as error:
            raise TimeStandsStill(_where(node, error.stack) or error.name, simulation.now()) from None
        except Stuck:
            where = _where(node, watchdog.stack or []) or simulation.failed
            raise TimeStandsStill(where, simulation.now()) from None
    return _result(status, world, 0)


def run_wall(node: Node, seconds: float | None, args: Sequence[str], record: bool) -> Result:
    """Run a loaded node on the wall clock, until Ctrl-C if ``seconds`` is None; its console goes to ``sys.stdout``."""
    until = None if seconds is None else _duration(seconds) / NS
    if threading.current_thread() is not threading.main_thread():
        raise RuntimeError("a node runs on the wall clock in the main thread only: it handles signals there")
    clock = WallClock()
    over = False
    ident = threading.get_ident()

    def on_signal(number: int, frame: Any) -> None:
        if not over:
            raise KeyboardInterrupt

    def press_ctrl_c() -> None:
        world.over = True
        signal.pthread_kill(ident, signal.SIGINT)

    def kill() -> None:
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(_Killed))

    alarms = [] if until is None else [threading.Timer(until, press_ctrl_c), threading.Timer(until + _PATIENCE, kill)]
    handlers = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    with _process_of(node, args):
        world = World(clock, sys.argv, handle_process_signals)
        world.ticks = [] if record else None
        start = clock.now()
        context = contextvars.copy_context()
        context.run(current.set, world)
        signal.signal(signal.SIGINT, on_signal)
        for alarm in alarms:
            alarm.daemon = True
            alarm.start()
        try:
            status = context.run(_run_main, node, world)
        except _Killed:
            status = _say_killed(seconds)
        finally:
            over = True
            for alarm in alarms:
                alarm.cancel()
                alarm.join()
            clock.close()
            for number, handler in handlers.items():
                signal.signal(number, handler)
    return _result(status, world, start)


class _Killed(BaseException):
    """The node did not end at Ctrl-C."""


def _say_killed(seconds: float | None) -> int:
    sys.stderr.write(
        f"rosspin: Ctrl-C at {seconds} s did not end the node; killed {_PATIENCE} s later, as roslaunch does. "
        "Does its loop ask rospy.is_shutdown()?\n"
    )
    return 128 + signal.SIGKILL


def _where(node: Node, stack: Sequence[traceback.FrameSummary]) -> str:
    """The innermost line of the node's file in a call stack, as ``file:line``; empty if there is none."""
    for frame in reversed(stack):
        if frame.filename == node.filename:
            return f"{frame.filename}:{frame.lineno}"
    return ""


def say_error(error: Exception) -> str:
    """What ends a run, or keeps it from beginning, in words: with the place in the node's file if it has one."""
    if isinstance(error, SyntaxError):
        return "".join(traceback.format_exception_only(error)).strip()
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, NotSimulated):
        trace = own_frames((error.__cause__ or error).__traceback__)
        places = [frame for frame in traceback.extract_tb(trace) if not frame.filename.startswith("<frozen")]
        return f"{places[-1].filename}:{places[-1].lineno}: {error}" if places else str(error)
    return str(error)


def split_words(words: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """A command line in two: rosspin's own words and, after ``--``, the node's."""
    at = words.index("--") if "--" in words else len(words)
    return words[:at], words[at + 1 :]


def _duration(seconds: float) -> int:
    if not (isinstance(seconds, (int, float)) and math.isfinite(seconds) and seconds >= 0):
        raise ValueError(f"seconds must be a number from 0 up, not {seconds!r}")
    return nanoseconds(seconds)


def _run_main(node: Node, world: World) -> int:
    """Do with a node's code what the interpreter does with a program; the exit status."""
    status = 0
    try:
        node.main()
    except SystemExit as error:
        if isinstance(error.code, str):
            sys.stderr.write(error.code + "\n")
        status = error.code if isinstance(error.code, int) else int(error.code is not None)
    except (NotSimulated, Stuck, _Killed):
        raise
    except (Exception, KeyboardInterrupt) as error:
        if isinstance(error, ModuleNotFoundError) and _is_ros_package(error.name or ""):
            raise NotSimulated(error.name or "") from error
        print_traceback()
        status = 128 + signal.SIGINT if type(error) is KeyboardInterrupt else 1
    core.signal_shutdown("atexit")
    if world.failure:
        raise world.failure
    return status


def _is_ros_package(name: str) -> bool:
    root, _, rest = name.partition(".")
    return root in _ROS_PACKAGES or root.endswith("_msgs") or (root == "rospy" and rest in rospy.NOT_SIMULATED)


def _result(status: int, world: World, start: int) -> Result:
    ticks = tuple(
        Tick(
            source,
            number,
            (expected - start) / NS,
            (real - start) / NS,
            math.nan if duration is None else duration / NS,
        )
        for source, number, expected, real, duration in world.ticks or ()
    )
    return Result(status, ticks, start / NS)


# --- the process around a node ----------------------------------------------------------------------------------------

_ROSPY = {"rospy": rospy, "genpy": genpy}
for _module in (client, core, exceptions, names, rostime, timer):
    _ROSPY[_module.__name__.removeprefix("rosspin.")] = _module

# A run changes what the whole process shares, so there is one at a time.
_one_at_a_time = threading.RLock()


@contextmanager
def _process_of(node: Node, args: Sequence[str]) -> Iterator[None]:
    """Within this context the process looks as it does to a node: command line, path, ``import rospy``."""
    if running.get():
        raise RuntimeError("a node that runs in simulated time cannot start a run of its own")
    with _one_at_a_time:
        argv, path, modules, environ = sys.argv, sys.path[:], dict(sys.modules), dict(os.environ)
        sys.argv = [node.argv0, *args]
        if node.folder is not None:
            sys.path.insert(0, node.folder)
        sys.modules.update(_ROSPY)
        try:
            yield
        finally:
            sys.argv, sys.path[:] = argv, path
            if os.environ != environ:
                os.environ.clear()
                os.environ.update(environ)
            for name in [name for name in sys.modules if name not in modules]:
                if name in _ROSPY or _lies_in(node.folder, name):
                    del sys.modules[name]
            sys.modules.update({name: modules[name] for name in ("__main__", *_ROSPY) if name in modules})


def _lies_in(folder: str | None, name: str) -> bool:
    """Whether a module is, or belongs to, a neighbour of the node; a virtual environment below its folder is none."""
    file: str | None = getattr(sys.modules[name], "__file__", None)
    if folder is None or file is None:
        return False
    neighbour = os.path.join(folder, name.partition(".")[0])
    return os.path.abspath(file).startswith((neighbour + ".", neighbour + os.sep))


class Console:
    """What is written to two streams, in its order; it is passed on to ``stdout`` and ``stderr`` if these are given."""

    def __init__(self, stdout: TextIO | None = None, stderr: TextIO | None = None) -> None:
        self._chunks: list[str] = []
        self.stdout = _Stream(self._chunks, stdout)
        self.stderr = _Stream(self._chunks, stderr)

    def text(self) -> str:
        """All of it."""
        return "".join(self._chunks)


class _Stream(io.TextIOBase):
    encoding = "utf-8"

    def __init__(self, chunks: list[str], onward: TextIO | None) -> None:
        self._chunks = chunks
        self._onward = onward

    def write(self, text: str) -> int:
        self._chunks.append(text)
        if self._onward is not None:
            self._onward.write(text)
        return len(text)


@contextmanager
def capture(stdout: TextIO | None = None, stderr: TextIO | None = None) -> Iterator[Console]:
    """Within this context, what is printed goes to a :class:`Console`, and from there on to what is given."""
    console = Console(stdout, stderr)
    with _one_at_a_time:
        before = sys.stdout, sys.stderr
        sys.stdout, sys.stderr = console.stdout, console.stderr
        try:
            yield console
        finally:
            sys.stdout, sys.stderr = before
