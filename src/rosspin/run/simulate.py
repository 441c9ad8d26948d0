"""Run nodes on a clock, simulated or on the wall, and collect their consoles, ticks and messages."""

from __future__ import annotations

import gc
import math
import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from types import ModuleType
from typing import NamedTuple, TextIO

from .. import rospy
from ..clocks.clock import NS, Clock, nanoseconds
from ..clocks.ending import Ended
from ..clocks.frames import Place, Whereabouts, is_installed, node_frames
from ..clocks.programs import Died, Killed, LastResort, SimulatedProgram, run_on_the_wall, run_simulated
from ..clocks.simulation import Simulation, Standstill
from ..clocks.stacks import Program, StackExit
from ..clocks.threads import begin_main, end_main
from ..clocks.watchdog import Stuck
from ..results.ticks import Message, Run, Tick
from ..world.graph import Graph
from ..world.world import NotSimulated, World, not_simulated
from .process import Node, NodeLike, Process, capture, in_the_way, load, print_error, refuse_text, run_at_exit
from .roslaunch import launch
from .roslaunch.monitor import Member, Monitor

__all__ = [
    *("PATIENCE", "Result", "Results", "TimeStandsStill", "duration", "explained", "messages_of", "new_world"),
    *("run_captured", "run_main", "run_node", "run_nodes", "say_error", "simulate", "split_words", "ticks_of"),
    "warn_of_files",
]

# After Ctrl-C roslaunch waits 15 s, asks once more with SIGTERM, and kills after another 2 s.
PATIENCE = 17

# By the ROS of a node: who kills it if it does not end, what its loops should ask, what else is
# a thread, and how loops may sleep.
_KILLS = {1: ", as roslaunch does", 2: ""}
_GOES_ON = {1: "rospy.is_shutdown()", 2: "rclpy.ok()"}
_ALSO_THREADS = {1: " (a rospy.Timer is one, too)", 2: ""}
_SLEEP = {1: "rospy.sleep(0.1)", 2: "time.sleep(0.1)"}

# A run may have a million ticks: a Tick from a tuple takes half as long as one from its fields.
_new_tick = partial(tuple.__new__, Tick)


class TimeStandsStill(RuntimeError):
    """The node keeps simulated time from going on. The message says where and how."""


def simulate(
    node: NodeLike | Sequence[NodeLike | launch.Node], seconds: float, args: Sequence[str] = (), skip_cpp: bool = False
) -> Run:
    """Run a node for ``seconds`` of simulated time, which begins at 0 and takes almost no real time.

    ``node`` is the path of a node file, or a function; what it imports says for which ROS it is. ``args`` are its
    command line, such as ``"__ns:=/mrp"``, or ``"--ros-args", "-r", "__ns:=/mrp"`` in ROS 2. What is due exactly at
    ``seconds`` still runs; then Ctrl-C is pressed, which does what it does in that ROS: rospy ends with status 0, rclpy
    raises KeyboardInterrupt, with status 130 if nothing catches it. The run ends earlier if the node does. As on a real
    ROS, an exception in the node is printed and gives status 1.

    What the node changes in modules or in the process is gone afterwards. Its numbers from ``random`` are the ones that
    the caller would have drawn, and still will: runs without a seed between them draw the same.

    Several nodes of ROS 1 run together if ``node`` is a list of them, or the path of a launch file, whose own arguments
    are then the ``args``. They run as under roslaunch: they are started in this order, all at time 0, and each is a
    process to itself. In a list, :class:`Node` gives one a command line of its own. What roslaunch says of nodes that
    end is on the console, the status is 0 whatever becomes of them, and the sources of ticks begin with the nodes'
    names. With ``skip_cpp``, the nodes of a launch file that are not in Python are left out.

    Raises OSError if the file cannot be read, SyntaxError if it is not Python, ValueError if ``seconds`` is negative,
    too large or not a number, :class:`TimeStandsStill` if the node never lets the time go on, and
    :class:`NotSimulated` if it needs a real ROS.
    """
    refuse_text(args)
    if isinstance(node, (str, os.PathLike)) and os.fspath(node).endswith(".launch"):
        launched = launch.read_launch(node, args, skip_cpp)
    elif callable(node) or isinstance(node, (str, os.PathLike)) or not isinstance(node, Iterable):
        return run_captured(Simulation(), load(node), seconds, args)
    elif args:
        raise ValueError("give each of several nodes its own command line: rosspin.Node(node, args)")
    else:
        launched = launch.Launch([each if isinstance(each, launch.Node) else launch.Node(each) for each in node])
    duration(seconds)
    with capture() as console:
        result = run_nodes(launched, seconds, Simulation())
    return Run(console.text(), result.ticks, result.status, "simulated", seconds, 0.0, messages_of(result.graph, 0))


def run_captured(clock: Clock, node: Node, seconds: float, args: Sequence[str], *streams: TextIO) -> Run:
    """Run a loaded node on a clock, in this process. What it prints also goes to ``streams``: stdout's and stderr's."""
    duration(seconds)  # run_node takes None as for ever
    with capture(*streams) as console:
        result = run_node(node, seconds, args, clock)
    runtime = "simulated" if isinstance(clock, Simulation) else "wall"
    messages = messages_of(result.world.graph, round(result.start * NS))
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
    warn_of_files([node])
    with Process(node, args, stand_in(node.ros).MODULES, node.ros).inside():
        world = new_world(node, clock, record)
        start = 0 if isinstance(clock, Simulation) else clock.now()

        def result(status: int) -> Result:
            return Result(status, ticks_of(world.graph, start), start / NS, world)

        last_resort = give_up and LastResort(
            lambda killed: give_up(result(_say_killed(node, seconds, killed))),
            lambda stacks: _killed(node, seconds, [each for each in stacks if _of_nodes([node], each.places)]),
        )
        with explained(node, world, clock, seconds):
            if isinstance(clock, Simulation):
                assert until is not None
                run_simulated(lambda: run_main(node, world), world, clock, until, PATIENCE * NS)
            else:
                run_on_the_wall(lambda: run_main(node, world), world, until, PATIENCE * NS, last_resort)
    assert world.exit_status is not None
    return result(world.exit_status)


def warn_of_files(nodes: Sequence[Node]) -> None:
    """Say on ``sys.stderr`` which files beside nodes are in the way of modules on a real ROS."""
    for line in dict.fromkeys(line for node in nodes for line in in_the_way(node)):
        sys.stderr.write(f"rosspin: {line}\n")


class Results(NamedTuple):
    """How a run of several nodes ended: its exit status, ticks (none if not recorded), and what they shared."""

    status: int
    ticks: tuple[Tick, ...]
    graph: Graph


def run_nodes(nodes: launch.Launch, seconds: float, clock: Simulation, record: bool = True) -> Results:
    """Run several nodes on one simulated clock. Their console goes where ``sys.stdout`` and ``sys.stderr`` go."""
    until = duration(seconds)
    graph = Graph(clock, record, several=True)
    master = graph.part(rospy.state.Master)
    for name, value in nodes.parameters:
        master.set_param(name, value)
    for line in nodes.left_out:
        sys.stderr.write(f"rosspin: {line}\n")
    members = [Member(node, load(node.node), number) for number, node in enumerate(nodes.nodes, 1)]
    codes = [member.code for member in members]
    warn_of_files(codes)
    if any(code.ros != 1 for code in codes):
        raise ValueError("several nodes in one run are nodes of ROS 1; in ROS 2 one process can hold several nodes")
    with Monitor(members, clock, graph, _run_beside_others, _say_where, rospy.MODULES, ros=1) as monitor:
        try:
            program = SimulatedProgram(monitor.run, Program(), clock)
            program.advance(until)
            program.end(None)
        except (Standstill, Stuck) as error:
            raise _stands_still(codes, error, clock) from None
        except Ended:
            failures = [member.world.failure for member in members if member.world.failure]
            if not failures:
                raise
            raise failures[0] from None
    return Results(0, ticks_of(graph, 0), graph)


def _run_beside_others(node: Node, world: World) -> None:
    _at_the_end(node, world)
    run_main(node, world)


def stand_in(ros: int) -> ModuleType:
    """The stand-in for ROS 1 or 2."""
    if ros == 2:
        from .. import rclpy  # it is large, and loaded only for nodes that need it

        return rclpy
    return rospy


def new_world(node: Node, clock: Clock, record: bool) -> World:
    """The world of a node whose process the caller is in."""
    world = World(clock, sys.argv, record)
    _at_the_end(node, world)
    return world


def _at_the_end(node: Node, world: World) -> None:
    if node.ros == 1:
        world.at_exit.append((rospy.core.signal_shutdown, ("atexit",), {}))  # as rospy does when it is imported


@contextmanager
def explained(node: Node, world: World, clock: Clock, seconds: float | None) -> Iterator[None]:
    """Within this context a node runs. What ends it from outside becomes its exit status, or an error that says why."""
    try:
        yield
    except Killed as killed:
        world.waited = killed.waited
        world.exit_status = _say_killed(node, seconds, killed)
    except Died as died:
        world.exit_status = 128 + died.number
    except Ended:
        if world.failure is not None:
            raise world.failure from None
        if world.exit_status is None:
            raise
    except (Standstill, Stuck) as error:
        assert isinstance(clock, Simulation)
        raise _stands_still([node], error, clock) from None
    _end_if_forked(world)


def run_main(node: Node, world: World) -> None:
    """Do with a node's code what the interpreter does with a program, and keep the exit status."""
    try:
        _run_main(node, world)
    finally:
        _end_if_forked(world)


def _end_if_forked(world: World) -> None:
    """End this process if it is a child that the node has forked: what comes now is its parent's."""
    if os.getpid() != world.pid:
        for stream in filter(None, (sys.stdout, sys.stderr)):
            stream.flush()
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
        if lacking := not_simulated(error):
            raise lacking from error
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


def ticks_of(graph: Graph, start: int, since: int = 0) -> tuple[Tick, ...]:
    """What was recorded of ticks, in a run that began at ``start`` (ns), from the tick ``since`` on."""
    if graph.ticks is None:
        return ()
    sources, numbers, expected, real, durations = graph.ticks.columns(since)
    with _no_collections():
        return tuple(
            map(
                _new_tick,
                zip(
                    sources,
                    numbers,
                    [(time - start) / NS for time in expected],
                    [(time - start) / NS for time in real],
                    [math.nan if duration is None else duration / NS for duration in durations],
                ),
            )
        )


@contextmanager
def _no_collections() -> Iterator[None]:
    """Within this context the garbage collector does not go through what is made, again and again as it grows."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def messages_of(graph: Graph, start: int, since: int = 0) -> tuple[Message, ...]:
    """What was recorded of messages, likewise."""
    return tuple(
        Message(topic, node, (time - start) / NS, make()) for topic, node, time, make in (graph.published or ())[since:]
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


def _killed(node: Node, seconds: float | None, waited: Sequence[Whereabouts]) -> str:
    at = "" if seconds is None else f" at {seconds:.10g} s"
    why = f"Does its loop check {_GOES_ON[node.ros]}?"
    if waits_for_a_rate(node, waited):
        why = (
            "After Ctrl-C nothing wakes a Rate any more, and Python waits for the thread that is asleep in it. "
            "Use a Rate only in a daemon thread."
        )
    said = f"rosspin: Ctrl-C{at} did not end the node; it was killed {PATIENCE} s later{_KILLS[node.ros]}. {why}\n"
    return said + _say_where(node, waited)


def _say_killed(node: Node, seconds: float | None, killed: Killed) -> int:
    sys.stderr.write(_killed(node, seconds, killed.waited))
    if killed.blocks:
        sys.stderr.write("rosspin: the main thread blocks SIGINT (signal.pthread_sigmask): Ctrl-C does not reach it\n")
    return 128 + signal.SIGKILL


def _say_where(node: Node, waited: Sequence[Whereabouts]) -> str:
    """Where the threads of a node were, a line for each."""
    lines = []
    for thread, places, _ in waited:
        place = _of_nodes([node], places)
        where = f"was at {_say_place(place)}" if place else "had done its work and waited for other threads"
        lines.append(f"rosspin: {thread} {where}\n")
    return "".join(lines)


def waits_for_a_rate(node: Node, waited: Sequence[Whereabouts]) -> bool:
    """Whether what keeps a node from its end are threads that sleep on a Rate of ROS 2, and nothing else.

    In ROS 1 a Rate looks at the clock by itself.
    """
    kept = _keeping(node, waited)
    return node.ros == 2 and bool(kept) and all(map(stand_in(2).timer.is_asleep_on_a_rate, kept))


def where_it_was_kept(node: Node, waited: Sequence[Whereabouts]) -> Place | None:
    """The place in a node's code that kept it from its end, or the first of them."""
    return next((_of_nodes([node], places) for places in _keeping(node, waited)), None)


def _keeping(node: Node, waited: Sequence[Whereabouts]) -> list[list[Place]]:
    """The places of the threads that Python waits for, and that do not wait for others themselves."""
    return [places for _, places, daemon in waited if not daemon and _of_nodes([node], places)]


def _of_nodes(nodes: Sequence[Node], places: Sequence[Place]) -> Place | None:
    """The innermost place in a node's file or its folder."""
    folders = tuple(name for node in nodes for name in (node.filename, f"{node.folder or node.filename}{os.sep}"))
    return next((place for place in places if place.filename.startswith(folders)), None)


def _say_place(place: Place) -> str:
    return f"{place.filename}:{place.line}" + (f": {place.call}" if place.call else "")


def _stands_still(nodes: Sequence[Node], error: Standstill | Stuck, clock: Simulation) -> TimeStandsStill:
    now = f"simulated time stands still at {clock.now() / NS} s"
    fallback = clock.failed if isinstance(error, Stuck) else error.place
    place = _of_nodes(nodes, error.places) or (None if fallback else _of_nodes(nodes, clock.left))
    where = f"{place.filename}:{place.line}" if place else fallback
    if isinstance(error, Stuck) and (error.waits or error.computed):
        where = _say_place(place) if place else fallback
        why = (
            f"because this has computed for {error.computed:.0f} s and let nothing else run meanwhile. "
            "Compute less at a time, or run the node on the wall clock."
            if error.computed
            else "because this waits in real time, which the simulation cannot see. "
            "Run the node on the wall clock, or remove what waits."
        )
    elif isinstance(error, Standstill) and error.threads:
        why = (
            f"because {error.threads:,} threads have not ended, as many as a run may have; this would have been one "
            f"more{_ALSO_THREADS[nodes[0].ros]}. Start them outside of loops and callbacks, or let them end."
        )
    else:
        why = (
            "because the node keeps running without sleeping. "
            f"Sleep in every loop (rate.sleep(), {_SLEEP[nodes[0].ros]}), and give timers and rates a period above 0."
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
        lines = [each for each in traceback.walk_tb(trace) if not each[0].f_code.co_filename.startswith("<frozen")]
        lines = [each for each in lines if not is_installed(each[0])] or lines
        return f"{lines[-1][0].f_code.co_filename}:{lines[-1][1]}: {error}" if lines else str(error)
    return str(error)


def split_words(words: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """Split a command line in two: rosspin's own words and, after ``--``, the node's."""
    at = words.index("--") if "--" in words else len(words)
    return words[:at], words[at + 1 :]
