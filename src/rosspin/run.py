"""Run nodes on a clock, simulated or on the wall, and collect their consoles, ticks and messages."""

from __future__ import annotations

import math
import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import NamedTuple, TextIO

from . import rospy
from .clocks.clock import NS, Clock, nanoseconds
from .clocks.ending import Ended
from .clocks.programs import Died, Killed, LastResort, run_on_the_wall, run_simulated
from .clocks.simulation import Simulation, Standstill
from .clocks.stacks import StackExit
from .clocks.threads import begin_main, end_main
from .clocks.watchdog import Stuck
from .frames import Place, node_frames
from .process import Node, NodeLike, Process, capture, load, print_error, run_at_exit
from .ticks import Message, Run, Tick
from .world import NotSimulated, World

__all__ = [
    *("PATIENCE", "Result", "TimeStandsStill", "duration", "explained", "messages_of", "new_world"),
    *("run_captured", "run_main", "run_node", "say_error", "simulate", "split_words", "ticks_of"),
]

# After Ctrl-C roslaunch waits 15 s, asks once more with SIGTERM, and kills after another 2 s.
PATIENCE = 17

# What a node may import beside its ROS and would not find.
_ROS_PACKAGES = {
    *("actionlib", "cv_bridge", "dynamic_reconfigure", "message_filters", "rosbag", "rosgraph", "roslaunch", "roslib"),
    *("rosnode", "rosparam", "rospkg", "rosservice", "rostopic", "tf", "tf2_ros", "tf_conversions"),
}


# A run may have a million ticks: a Tick from a tuple takes half as long as one from its fields.
_new_tick = partial(tuple.__new__, Tick)


class TimeStandsStill(RuntimeError):
    """The node keeps simulated time from going on. The message says where and how."""


def simulate(node: NodeLike, seconds: float, args: Sequence[str] = ()) -> Run:
    """Run a node for ``seconds`` of simulated time, which begins at 0 and takes almost no real time.

    ``node`` is the path of a node file, or a function; ``args`` are its command line, such as ``"__ns:=/mrp"``. What is
    due exactly at ``seconds`` still runs; then Ctrl-C is pressed. The run ends earlier if the node does. As on a real
    ROS, an exception in the node is printed and gives status 1.

    Raises OSError if the file cannot be read, SyntaxError if it is not Python, ValueError if ``seconds`` is negative,
    too large or not a number, :class:`TimeStandsStill` if the node never lets the time go on, and
    :class:`NotSimulated` if it needs a real ROS.
    """
    return run_captured(Simulation(), load(node), seconds, args)


def run_captured(clock: Clock, node: Node, seconds: float, args: Sequence[str], *streams: TextIO) -> Run:
    """Run a loaded node on a clock, in this process. What it prints also goes to ``streams``: stdout's and stderr's."""
    duration(seconds)  # run_node takes None as for ever
    with capture(*streams) as console:
        result = run_node(node, seconds, args, clock)
    runtime = "simulated" if isinstance(clock, Simulation) else "wall"
    messages = messages_of(result.world, round(result.start * NS))
    return Run(console.text(), result.ticks, result.status, runtime, seconds, result.start, messages)


class Result(NamedTuple):
    """How a run ended: its exit status, ticks (none if not recorded), start (s since the epoch) and world."""

    status: int
    ticks: tuple[Tick, ...]
    start: float
    world: World


def run_node(
    node: Node,
    seconds: float | None,
    args: Sequence[str],
    clock: Clock,
    record: bool = True,
    give_up: Callable[[Result], object] | None = None,
) -> Result:
    """Run a loaded node on a clock: if ``seconds`` is None, on the wall until Ctrl-C.

    Its console goes where ``sys.stdout`` and ``sys.stderr`` go; ``record`` keeps its ticks. With ``give_up`` this
    process is there only for the node: if nothing else ends the node, the process is killed, after a call with what
    the run gave so far (without one if code in C lets no thread run).
    """
    until = None if seconds is None else duration(seconds)
    with Process(node, args, rospy.MODULES, ros=1).inside():
        world = new_world(clock, record)
        start = 0 if isinstance(clock, Simulation) else clock.now()

        def result(status: int) -> Result:
            return Result(status, ticks_of(world, start), start / NS, world)

        last_resort = give_up and LastResort(
            lambda killed: give_up(result(_say_killed(node, seconds, killed))),
            lambda stacks: _killed(seconds) + _say_where(node, [each for each in stacks if _of_node(node, each[1])]),
        )
        with explained(node, world, clock, seconds):
            if isinstance(clock, Simulation):
                assert until is not None
                run_simulated(lambda: run_main(node, world), world, clock, until, PATIENCE * NS)
            else:
                run_on_the_wall(lambda: run_main(node, world), world, until, PATIENCE * NS, last_resort)
    assert world.exit_status is not None
    return result(world.exit_status)


def new_world(clock: Clock, record: bool) -> World:
    """The world of a node whose process the caller is in."""
    world = World(clock, sys.argv, record)
    world.at_exit.append((rospy.core.signal_shutdown, ("atexit",), {}))  # as rospy does when it is imported
    return world


@contextmanager
def explained(node: Node, world: World, clock: Clock, seconds: float | None) -> Iterator[None]:
    """Within this context a node runs. What ends it from outside becomes its exit status, or an error that says why."""
    try:
        yield
    except Killed as killed:
        world.exit_status = _say_killed(node, seconds, killed)
    except Died as died:
        world.exit_status = 128 + died.number
    except Standstill as error:
        raise _stands_still(node, error.places, error.place, clock, waits=False) from None
    except Ended:
        if world.failure is not None:
            raise world.failure from None
        if world.exit_status is None:
            raise
    except Stuck as error:
        place = clock.failed if isinstance(clock, Simulation) else ""
        raise _stands_still(node, error.places, place, clock, error.waits) from None


def run_main(node: Node, world: World) -> None:
    """Do with a node's code what the interpreter does with a program, and keep the exit status."""
    try:
        _run_main(node, world)
    finally:
        if os.getpid() != world.pid:  # a child that the node has forked ends here
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(world.exit_status or 0)


def _run_main(node: Node, world: World) -> None:
    status = 0
    begin_main(world)
    try:
        node.main()
    except SystemExit as error:
        if not isinstance(error.code, int) and error.code is not None:
            sys.stderr.write(f"{error.code}\n")
        status = error.code & 0xFF if isinstance(error.code, int) else int(error.code is not None)
    except (NotSimulated, Ended, StackExit, Died):
        raise
    except BaseException as error:
        if isinstance(error, ModuleNotFoundError) and _is_ros_package(error.name or ""):
            raise NotSimulated(error.name or "") from error
        status = 128 + signal.SIGINT if type(error) is KeyboardInterrupt else 1
        if sys.excepthook is sys.__excepthook__:
            print_error(world, error)
        else:
            world.note_error(error)
            try:
                sys.excepthook(type(error), error, error.__traceback__)
            except SystemExit as end:
                status = end.code & 0xFF if isinstance(end.code, int) else int(end.code is not None)
            except Exception as another:
                sys.stderr.write("Error in sys.excepthook:\n")
                print_error(world, another)
    world.note_main_status(status)
    try:
        end_main(world)
    except (NotSimulated, Ended, StackExit, Died):
        raise
    except BaseException as error:
        sys.stderr.write("Exception ignored in: <module 'threading'>\n")
        print_error(world, error)
    run_at_exit(world)
    world.exit_status = status


def _is_ros_package(name: str) -> bool:
    root, _, rest = name.partition(".")
    return (
        root in _ROS_PACKAGES
        or root.endswith(("_msgs", "_srvs"))
        or rest.startswith("srv")
        or (root == "rospy" and rest in rospy.NOT_SIMULATED)
    )


def ticks_of(world: World, start: int, since: int = 0) -> tuple[Tick, ...]:
    """What was recorded of a node's ticks, in a run that began at ``start`` (ns), from the tick ``since`` on."""
    return tuple(
        _new_tick(
            (
                source,
                number,
                (expected - start) / NS,
                (real - start) / NS,
                math.nan if duration is None else duration / NS,
            )
        )
        for source, number, expected, real, duration in (world.ticks or ())[since:]
    )


def messages_of(world: World, start: int, since: int = 0) -> tuple[Message, ...]:
    """What was recorded of the messages in a node's graph, likewise."""
    return tuple(
        Message(topic, node, (time - start) / NS, make())
        for topic, node, time, make in (world.graph.published or ())[since:]
    )


def duration(seconds: float) -> int:
    """The length of a run, or of a step, in ns. Raises ValueError if it cannot be one."""
    if not (isinstance(seconds, (int, float)) and math.isfinite(seconds) and seconds >= 0):
        raise ValueError(f"seconds must be a number of at least 0, not {seconds!r}")
    try:
        return nanoseconds(seconds)
    except OverflowError:
        raise ValueError(f"seconds must be less than {2**63 // NS} (292 years), not {seconds!r}") from None


# --- what is said of a run --------------------------------------------------------------------------------------------


def _killed(seconds: float | None) -> str:
    at = "" if seconds is None else f" at {seconds:.10g} s"
    return (
        f"rosspin: Ctrl-C{at} did not end the node; it was killed {PATIENCE} s later, as roslaunch does. "
        "Does its loop check rospy.is_shutdown()?\n"
    )


def _say_killed(node: Node, seconds: float | None, killed: Killed) -> int:
    sys.stderr.write(_killed(seconds) + _say_where(node, killed.waited))
    return 128 + signal.SIGKILL


def _say_where(node: Node, waited: Sequence[tuple[str, list[Place]]]) -> str:
    """Where the threads of a node were, a line for each."""
    lines = []
    for name, places in waited:
        place = _of_node(node, places)
        where = f"was at {_say_place(place)}" if place else "had done its work and waited for other threads"
        lines.append(f"rosspin: {name} {where}\n")
    return "".join(lines)


def _of_node(node: Node, places: Sequence[Place]) -> Place | None:
    """The innermost place in the node's file or its folder."""
    folder = node.folder + os.sep if node.folder else node.filename
    return next((place for place in places if place.filename.startswith((node.filename, folder))), None)


def _say_place(place: Place) -> str:
    return f"{place.filename}:{place.line}" + (f": {place.call}" if place.call else "")


def _stands_still(node: Node, places: Sequence[Place], fallback: str, clock: Clock, waits: bool) -> TimeStandsStill:
    now = f"simulated time stands still at {clock.now() / NS} s"
    place = _of_node(node, places)
    if waits:
        where = _say_place(place) if place else fallback
        why = (
            "because this waits in real time, which the simulation cannot see. "
            "Run the node on the wall clock, or remove what waits."
        )
    else:
        where = f"{place.filename}:{place.line}" if place else fallback
        why = (
            "because the node keeps running without sleeping. Sleep in every loop (rate.sleep(), rospy.sleep(0.1)), "
            "and give timers and rates a period above 0."
        )
    return TimeStandsStill(f"{where}{': ' if where else ''}{now}, {why}")


def say_error(error: Exception) -> str:
    """An error that ended a run or prevented it, in words, with the line of the node's file if it has one."""
    if isinstance(error, SyntaxError):
        return "".join(traceback.format_exception_only(error)).strip()
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, NotSimulated):
        trace = node_frames((error.__cause__ or error).__traceback__)
        places = [frame for frame in traceback.extract_tb(trace) if not frame.filename.startswith("<frozen")]
        return f"{places[-1].filename}:{places[-1].lineno}: {error}" if places else str(error)
    return str(error)


def split_words(words: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """Split a command line in two: rosspin's own words and, after ``--``, the node's."""
    at = words.index("--") if "--" in words else len(words)
    return words[:at], words[at + 1 :]
