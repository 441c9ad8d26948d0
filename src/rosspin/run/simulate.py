"""Run nodes on a clock, simulated or on the wall, and collect their consoles, ticks and messages."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TextIO

from ..clocks.clock import Clock, nanoseconds
from ..clocks.ctrl_c import Ending
from ..clocks.explored import ExploredSimulation, Order
from ..clocks.real_time import FOREVER, RealTime
from ..clocks.simulation import Simulation
from ..results.ticks import Run
from ..world.graph import TickLog
from .explain import say_uncalled
from .host import Host, Result, Supervisor, duration
from .kinds import ROS
from .ros2launch.launch_file import LaunchFile
from .roslaunch import launch
from .roslaunch.monitor import Monitor
from .shaking import shaken as shake
from .source import Code, NodeLike, is_launch_of_ros2, load, refuse_text, warn_of_files
from .streams import capture
from .together import Together

if TYPE_CHECKING:
    from ..faults import Fault

__all__ = [
    *("Launched", "Prepared", "prepare", "run_captured", "run_in_order", "run_node", "run_nodes"),
    *("run_prepared", "several", "simulate", "supervisor", "tell_uncalled", "with_jitter"),
]

Launched = launch.Launch | LaunchFile


def simulate(
    node: NodeLike | Sequence[NodeLike | launch.Node],
    seconds: float,
    args: Sequence[str] = (),
    skip_cpp: bool = False,
    *,
    start: float = 0.0,
    faults: Sequence[Fault] = (),
    jitter: float = 0.0,
    schedule: str = "",
) -> Run:
    """Run a node for ``seconds`` of simulated time, which begins at 0 and takes almost no real time.

    ``start`` is what the node's clocks tell at first, in s: 0, or with 1.7e9 a time as on a real computer. What the run
    gives counts from there.

    ``node`` is the path of a node file, a function, or the name of one, as in ``"package.module:main"``. Whichever of
    ``rospy`` and ``rclpy`` it imports first decides its ROS, in C++ what it includes. ``args`` are its command line,
    such as ``"__ns:=/mrp"``, or ``"--ros-args", "-r", "__ns:=/mrp"`` in ROS 2. What is due exactly at ``seconds`` still
    runs; then Ctrl-C is pressed. Then, as on a real ROS, rospy ends with status 0, and rclpy raises KeyboardInterrupt,
    with status 130 if nothing catches it. The run ends earlier if the node does. As on a real ROS, an exception in the
    node is printed and gives status 1.

    What the node changes in modules or in the process is undone afterwards. Modules that lie next to its file, or hold
    something of ROS, such as a class of messages, are imported again in the next run. From ``random`` it draws the
    numbers that the caller would have drawn next, and still will: two runs in a row draw the same unless you set a seed
    in between.

    Several nodes run together if ``node`` is a list of them, or the path of a launch file, which is then given the
    ``args``. They are started in this order, all at time 0, each as a process of its own. In a list, :class:`Node`
    gives one a command line of its own. The sources of ticks begin with the nodes' names. Nodes of ROS 1 run as under
    roslaunch: what it says of nodes that end is on the console, and the status is 0 whatever becomes of them. If there
    are nodes of ROS 2, all run as in terminals of their own: each gets the Ctrl-C, and the status is from the first
    that has failed. Nodes of a launch file of ROS 2 (``.launch.py``, ``.launch.xml`` or ``.launch.yaml``) run as under
    ``ros2 launch``. Nodes of ROS 1 and ROS 2 do not hear each other. With ``skip_cpp``, the nodes of a launch file that
    are not in Python are left out.

    ``faults`` are what should go wrong, from :mod:`rosspin.faults`; ``run.faults`` says what they did. A line on the
    console names each that did nothing. ``jitter`` is short for one of them, ``Jitter(jitter)``: threads and callbacks
    are late by up to so many seconds, as on a real computer, drawn in the same way in each run.

    Raises OSError if the file cannot be read, SyntaxError if it is not Python, ValueError if C++ does not compile, if
    ``seconds`` or ``start`` is negative, too large or not a number, or if the ``schedule`` is none of this node,
    :class:`TimeStandsStill` if the node never lets the time pass, and :class:`NotSimulated` if it needs a real ROS.
    Raises TypeError for ``faults`` that are none, and ValueError for one that asks a transport for what it cannot do,
    that names what the run does not have, or that comes after its end.
    """
    shaken = bool(schedule) and Order.of(schedule).deep
    prepared = prepare(node, args, skip_cpp, shaken, with_jitter(faults, jitter))
    with capture() as console:
        if schedule:
            result = run_in_order(prepared, seconds, schedule, start, TickLog())
        else:
            result = run_prepared(prepared, seconds, Simulation(duration(start, "start")), TickLog())
    return result.run(console.text(), "simulated", seconds)


def with_jitter(faults: Sequence[Fault], jitter: float) -> Sequence[Fault]:
    """Return the faults, and one of up to ``jitter`` s. Raises TypeError and ValueError for wrong ones."""
    if jitter == 0:
        return faults
    from ..faults import Jitter, checked  # most runs go without

    return (*checked(faults), Jitter(jitter))


class Prepared(NamedTuple):
    """What should run, loaded: several nodes, or a launch file, or one node, whose command line is ``args``."""

    launched: Launched | None
    codes: list[Code]
    args: Sequence[str]
    faults: Sequence[Fault] = ()


def prepare(
    node: NodeLike | Sequence[NodeLike | launch.Node],
    args: Sequence[str],
    skip_cpp: bool,
    shaken: bool,
    faults: Sequence[Fault] = (),
) -> Prepared:
    """Load what should run, once for many runs. Raises what :func:`simulate` raises for it.

    Nodes that should be ``shaken`` raise ValueError if all are functions, or if they are of a launch file of ROS 2.
    """
    refuse_text(args)
    launched = several(node, args, skip_cpp)
    if isinstance(launched, LaunchFile):
        if shaken:
            raise ValueError(f"{launched.path}: deep is for node files, one or several")
        return Prepared(launched, [], args, faults)
    nodes: list[Any] = [node] if launched is None else [each.node for each in launched.nodes]
    codes = [load(each) for each in nodes]
    if shaken:
        only_functions = all(code.source is None for code in codes)
        codes = [shake(code) if only_functions or code.source is not None else code for code in codes]
    return Prepared(launched, codes, args, faults)


def run_prepared(prepared: Prepared, seconds: float, clock: Simulation, ticks: TickLog | None) -> Result:
    """Run what was prepared, as :func:`run_node` and :func:`run_nodes` do."""
    duration(seconds)
    launched, codes, args, faults = prepared
    if launched is None:
        return run_node(codes[0], seconds, args, clock, ticks, faults=faults)
    return run_nodes(launched, seconds, clock, ticks, codes, faults)


def run_in_order(prepared: Prepared, seconds: float, schedule: str, start: float, ticks: TickLog | None) -> Result:
    """Run what was prepared in the order of a token. Raises ValueError if that is none, or none of this node."""
    order = Order.of(schedule)
    result = run_prepared(prepared, seconds, ExploredSimulation(order, duration(start, "start")), ticks)
    order.has_to_fit()
    return result


def several(
    node: NodeLike | Sequence[NodeLike | launch.Node], args: Sequence[str] = (), skip_cpp: bool = False
) -> Launched | None:
    """Read a launch file, or a list of nodes; None for anything else. Raises what :func:`simulate` raises for these.

    A launch file of ROS 2 is read only when it runs.
    """
    path = os.fspath(node) if isinstance(node, (str, os.PathLike)) else ""
    if path.endswith(".launch"):
        return launch.read_launch(path, args, skip_cpp)
    if is_launch_of_ros2(path):
        with open(path, "rb"):
            return LaunchFile(path, args, skip_cpp)
    if callable(node) or isinstance(node, (str, bytes, os.PathLike)) or not isinstance(node, Iterable):
        return None
    if args:
        raise ValueError(
            "give each of several nodes its own command line: in Python, rosspin.Node(node, args), or in a launch file"
        )
    return launch.Launch([each if isinstance(each, launch.Node) else launch.Node(each) for each in node])


def run_captured(
    clock: Clock, node: Code, seconds: float, args: Sequence[str], *streams: TextIO, faults: Sequence[Fault] = ()
) -> Run:
    """Run a loaded node on a clock, in this process. What it prints also goes to ``streams``: stdout's and stderr's."""
    duration(seconds)  # run_node takes None as forever
    with capture(*streams) as console:
        result = run_node(node, seconds, args, clock, TickLog(), faults=faults)
    tell_uncalled(result, seconds, *streams[1:])
    is_simulated = isinstance(clock, Simulation) and not isinstance(clock, RealTime)
    runtime = "simulated" if is_simulated else "wall"
    return result.run(console.text(), runtime, seconds)


def tell_uncalled(result: Result, seconds: float, *streams: TextIO) -> None:
    """Tell a reader why callbacks were never called, if this was in simulated time."""
    clock, start = result.host.clock, result.host.recording.start
    if isinstance(clock, Simulation):
        for said in say_uncalled(result.host.processes, clock.now() - start < duration(seconds)):
            for stream in streams:
                stream.write(f"rosspin: {said}\n")


def run_node(
    node: Code,
    seconds: float | None,
    args: Sequence[str],
    clock: Clock,
    ticks: TickLog | None = None,
    give_up: Callable[[Result], object] | None = None,
    faults: Sequence[Fault] = (),
    ending: Ending | None = None,
) -> Result:
    """Run a loaded node on a clock: if ``seconds`` is None, on the wall until Ctrl-C.

    Its console goes where ``sys.stdout`` and ``sys.stderr`` go; ticks and messages are recorded if ``ticks`` is given.
    ``give_up`` is for the wall: see :meth:`Host.run_on_the_wall`; ``faults`` are for simulated time. ``ending`` says
    how it is ended, if not as usual.
    """
    until = None if seconds is None else duration(seconds)
    host = Host(clock, ticks, faults=faults)
    host.ending = ending or host.ending
    warn_of_files([node])
    with host.inside():
        host.add(node, args)
        if isinstance(clock, RealTime):
            clock.patience = nanoseconds(host.ending.patience)
            host.run(FOREVER if until is None else until)
        elif isinstance(clock, Simulation):
            assert until is not None
            host.run(until)
        else:
            host.run_on_the_wall(seconds, give_up)
    return host.result()


def run_nodes(
    nodes: Launched,
    seconds: float,
    clock: Simulation,
    ticks: TickLog | None = None,
    codes: Sequence[Code] | None = None,
    faults: Sequence[Fault] = (),
) -> Result:
    """Run several nodes on one simulated clock; otherwise as :func:`run_node`.

    ``codes`` is their code, if it is loaded already.
    """
    until = duration(seconds)
    host = Host(clock, ticks, True, faults)
    host.supervisor = supervisor(nodes, host, codes)
    with host.inside():
        host.run(until)
    return host.result()


def supervisor(nodes: Launched, host: Host, codes: Sequence[Code] | None = None) -> Supervisor:
    """Make the supervisor of nodes: roslaunch, ros2 launch, or one that treats nodes as in terminals."""
    if isinstance(nodes, LaunchFile):
        from .ros2launch.service import LaunchService  # only needed where there is such a file

        return LaunchService(host, nodes)
    codes = codes or [load(node.node) for node in nodes.nodes]
    for line in nodes.left_out:
        sys.stderr.write(f"rosspin: {line}\n")
    warn_of_files(codes)
    if any(code.hint and ROS[code.hint].in_terminals for code in codes):
        return Together(host, nodes.nodes, codes)
    return Monitor(host, nodes, codes)
