"""A run: processes on one clock. Whenever one of them continues, it finds its own modules, streams and environment."""

from __future__ import annotations

import math
import os
import signal
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import cached_property
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any, Protocol, TextIO

from ..clocks import signals, threads, virtual_time
from ..clocks.clock import NS, Clock, nanoseconds
from ..clocks.ctrl_c import ALONE, Ending
from ..clocks.ending import Ended
from ..clocks.explored import ExploredSimulation
from ..clocks.frames import Whereabouts
from ..clocks.patches import Patch, patched
from ..clocks.programs import Killed, LastResort, SimulatedProgram, begin_beside, run_on_the_wall
from ..clocks.real_time import FOREVER
from ..clocks.signals import Died
from ..clocks.simulation import Simulation, Standstill
from ..clocks.stacks import Program, telling_turns
from ..clocks.threads import list_threads, unlist_threads
from ..clocks.watchdog import Stuck
from ..results.ticks import Call, Message, Run, Tick, with_ticks
from ..world.graph import Graph, Recording, TickLog
from ..world.world import World
from .deadlock import explain_threads
from .explain import keep_those_of, say_killed, stands_still
from .kinds import ROS
from .process import PATCHES, Process, Slots
from .saved_state import SAVED, collect_rarely, one_at_a_time, state_of_names, state_of_node, state_of_process
from .source import Code

if TYPE_CHECKING:
    from ..faults import Fault
    from ..faults.engine import Engine

__all__ = ["Host", "Result", "Supervisor", "duration", "kept", "replaced"]

# The statuses of a process that has not failed: Ctrl-C may end it, too, as a signal of a shell or of a launcher.
_FINE = (None, 0, 128 + signal.SIGINT, -signal.SIGINT)

# How the names of modules begin that may belong to a real ROS.
_ROOTS = tuple(root for ros in ROS.values() for root in (*ros.roots, *ros.beside))

_chdir = os.chdir


class Supervisor(Protocol):
    """Starts the nodes of a run, waits for them and ends them. It is a program of its own, and gets the Ctrl-C."""

    def run(self) -> None:
        """Run the nodes to their end. The host calls this within the run."""

    @property
    def status(self) -> int:
        """The exit status of the run."""


class Host:
    """Runs processes on a clock, simulated or on the wall. :meth:`add` them before the run, or while it lasts.

    ``ticks`` is the log to record in; with None nothing is recorded. On a simulated clock the run may go in steps:
    :meth:`advance`, then :meth:`interrupt`. ``several`` processes need a ``supervisor``. Each of them has its own
    messages, random numbers and modules from its folder; they share all other modules. ``faults`` are what should go
    wrong, on a simulated clock only; it raises what ``simulate`` raises for them.
    """

    ending: Ending = ALONE  # of a process that no supervisor ends
    supervisor: Supervisor | None = None
    on_failure: Callable[[], None] | None = None  # called for each error that is printed, and for a status other than 0

    def __init__(
        self, clock: Clock, ticks: TickLog | None, several: bool = False, faults: Sequence[Fault] = ()
    ) -> None:
        self.clock = clock
        self.recording = Recording(clock, ticks, several, clock.now())
        self.processes: list[Process] = []
        self.faults = None if faults in ((), []) else self._faulty(faults)
        self.at_graph: list[Callable[[int, Graph], None]] = []  # called when a ROS is used for the first time
        self.waits = ""  # what waited forever when Ctrl-C came
        self._failed: list[BaseException] | None = None
        self._graphs: dict[int, Graph] = {}
        self._stand_ins: dict[str, Mapping[str, ModuleType]] = {}
        self._of: dict[Program, Process] = {}
        self._own = ("__main__", "random") if several else ("__main__",)
        self._differ = False  # whether the environments of processes may differ
        self._put_inside: Callable[[], None] = lambda: None
        self._put_names: Callable[[], None] = lambda: None  # puts in place the names that nodes have changed

    def _faulty(self, faults: Sequence[Fault]) -> Engine | None:
        from ..faults.engine import Engine  # most runs go without

        assert isinstance(self.clock, Simulation)
        engine = Engine(
            faults,
            self.clock,
            self.recording,
            lambda: [process.world for process in self.processes],
            lambda: self._graphs.values(),
        )
        return engine if faults else None

    # --- processes ---

    def add(
        self,
        node: Code,
        args: Sequence[str] = (),
        environment: Mapping[str, str] | None = None,
        folder: str = "",
        stdout: TextIO | None = None,
        stderr: TextIO | None = None,
    ) -> Process:
        """Make the process of a node; see :class:`Process`. To be called within :meth:`inside`."""
        here = self._current
        self._go_on(self._outside)
        number = len(self.processes) + 1 if self.recording.several else 0

        def make_world(argv: list[str]) -> World:
            return World(self.clock, argv, self.recording, self.graph, number)

        process = Process(node, args, make_world, self._stand_in, self._hide, environment, folder, stdout, stderr)
        self._make_way(process)
        self.processes.append(process)
        self._of[process.world] = process
        process.world.on_failure = lambda: self.on_failure and self.on_failure()
        self._differ = self._differ or bool(environment)
        process.world.at_end.append(lambda: self._of.__delitem__(process.world))
        process.world.at_bind.append(lambda: self._bound(process))
        for ros in [node.hint] if node.hint else ROS:  # before the node can change anything
            self._stand_in(ros)
        self._go_on(here if self.recording.several else process)
        return process

    @contextmanager
    def outside(self) -> Iterator[None]:
        """Within this context code finds what it would find outside of all processes. Time must not pass in it."""
        here = self._current
        self._go_on(self._outside)
        try:
            yield
        finally:
            self._go_on(here)

    def graph(self, ros: int) -> Graph:
        """Return the graph of the nodes of a ROS."""
        if ros not in self._graphs:
            graph = self._graphs[ros] = Graph()
            graph.faults = self.faults
            for function in self.at_graph:
                function(ros, graph)
        return self._graphs[ros]

    def _stand_in(self, ros: int, package: str = "") -> Mapping[str, ModuleType]:
        """Return the modules that stand in for a ROS, or for a package next to it, by their names."""
        home = ROS[ros].home(package)
        if home not in self._stand_ins:
            known = home in sys.modules
            self._stand_ins[home] = dict(import_module(home).MODULES)
            if not known:  # then its state was not noted with all the rest
                self._loaded.append(state_of_names())
        return self._stand_ins[home]

    def _bound(self, process: Process) -> None:
        """Give a process what belongs to the ROS that it has imported."""
        self._stand_in(process.world.ros)
        process.world.at_exit += ROS[process.world.ros].stand_in.AT_EXIT

    def begin(self, process: Process) -> None:
        """Start a process now, for the supervisor. If a signal kills it, its exit status is the negative number."""

        def live() -> None:
            try:
                process.run()
            except Died as died:
                process.world.exit_status = -died.number
            assert isinstance(self.clock, Simulation)
            self.clock.end(process.world)

        assert isinstance(self.clock, Simulation)
        begin_beside(live, process.world, self.clock)

    # --- turns ---

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Within this context the processes can run, and find all as they left it. Afterwards all is as before."""
        with one_at_a_time(), ExitStack() as stack:
            put_back = state_of_process()
            stack.callback(lambda: self._keep_names(put_back()))
            if isinstance(self.clock, Simulation):
                collect_rarely()
            self._loaded: list[Callable[[], Callable[[], None]]] = []
            stack.callback(lambda: [undo() for undo in self._loaded])
            stack.enter_context(patched([*PATCHES, *self._patches()]))
            self._outside = self._current = Slots()
            self._replaced: dict[str, ModuleType] = {}
            self._shared = {*sys.modules, *self._own}
            self._count = len(sys.modules)
            self._hide({name: sys.modules.pop(name) for name in list(sys.modules) if name.startswith(_ROOTS)})
            for process in self.processes:
                self._make_way(process)
            self._outside.modules = {name: sys.modules[name] for name in self._own if name in sys.modules}
            stack.callback(self._put_back)
            if self.supervisor:
                for process in self.processes:
                    list_threads(process.world)
                stack.callback(self._unlist_threads)
                stack.enter_context(telling_turns(self._turn))
            elif self.processes:
                self._go_on(self.processes[0])
            self._put_inside()
            self._put_names()
            try:
                yield
            finally:
                self._put_inside = state_of_node()

    def _unlist_threads(self) -> None:
        for process in self.processes:
            unlist_threads(process.world)

    def _keep_names(self, put: Callable[[], None]) -> None:
        self._put_names = put

    def _make_way(self, process: Process) -> None:
        """Hide modules that whoever runs the process has imported, and that it would find elsewhere."""
        names = process.namesakes()
        self._hide({name: sys.modules.pop(name) for name in list(sys.modules) if name.partition(".")[0] in names})
        self._hide(process.imports.hide())

    def _hide(self, modules: Mapping[str, ModuleType]) -> None:
        """Note modules that were taken out of ``sys.modules``, to put them back at the end."""
        self._replaced.update(modules)
        self._shared.difference_update(modules)
        self._count -= len(modules)

    def _put_back(self) -> None:
        self._go_on(self._outside)
        sys.modules.update(self._replaced)

    def _turn(self, program: Program) -> None:
        """Put the program's process in place. A program that is not a node runs with whatever is in place."""
        process = self._of.get(program)
        if process is not None and process is not self._current:
            self._go_on(process)

    def _go_on(self, process: Slots) -> None:
        before, self._current = self._current, process
        if before is process:
            return
        before.keep()
        modules = sys.modules
        own = before.modules
        if len(modules) != self._count:
            own = before.modules = self._own_modules(before)
        for name in own:
            own[name] = modules.pop(name, own[name])
        modules.update(process.modules)
        self._count = len(modules)
        process.put_in_place()
        if process.folder and process.folder != before.folder:
            _chdir(process.folder)
        if self._differ and process.environment != before.environment:
            _export(before.environment, process.environment)

    def _own_modules(self, process: Slots) -> dict[str, ModuleType]:
        """Return the modules that only this process has. What it has imported besides is shared from now on."""
        new = [name for name in sys.modules if name not in self._shared]
        own = {name for name in new if self._is_own(name, process)}
        if isinstance(process, Process):
            own |= process.with_its_ros(set(new) - own, own)
        self._shared.update(set(new) - own)
        return {name: sys.modules[name] for name in (*self._own, *own) if name in sys.modules}

    def _is_own(self, name: str, process: Slots) -> bool:
        package = name.partition(".")[0]
        return package in _ROOTS or (
            isinstance(process, Process) and (package in process.imports.packages or process.owns(sys.modules[name]))
        )

    def _patches(self) -> list[Patch]:
        def noted(real: Callable[[Any], None]) -> Callable[[Any], None]:
            def chdir(path: Any) -> None:
                real(path)
                self._current.folder = os.getcwd()

            return chdir

        def changing(real: Callable[..., None]) -> Callable[..., None]:
            def change(*words: Any) -> None:
                self._differ = True
                real(*words)

            return change

        return [
            *((os, name, noted) for name in ("chdir", "fchdir")),
            *((os, name, changing) for name in ("putenv", "unsetenv")),
        ]

    # --- the run ---

    @cached_property
    def _program(self) -> SimulatedProgram:
        assert isinstance(self.clock, Simulation)
        if self.supervisor:
            simulated = SimulatedProgram(self.supervisor.run, Program(), self.clock)
        else:
            simulated = SimulatedProgram(self.processes[0].run, self.processes[0].world, self.clock)
        simulated.before_ctrl_c = self._before_ctrl_c
        return simulated

    def _before_ctrl_c(self) -> None:
        """Note what has failed so far, and say what waits forever: threads, and callbacks."""
        self._failed = self._errors()
        clock = self.clock
        assert isinstance(clock, Simulation)
        if self.recording.log is not None:
            self.recording.log.look_ahead(lambda: {stack.ident: stack.trail for stack in clock.suspended()})
        said = explain_threads(clock, self.recording.watcher)
        for ros, graph in sorted(self._graphs.items()):
            said += ROS[ros].explain_waits(graph, self.recording.watcher)
        if said:
            self.waits = said
            sys.stderr.write(said)

    def _errors(self) -> list[BaseException]:
        return [error for process in self.processes for error in process.world.errors]

    @property
    def failed(self) -> list[BaseException]:
        """The uncaught exceptions of its processes' threads, in a simulated run those that came before Ctrl-C."""
        return self._errors() if self._failed is None else self._failed

    @property
    def _patience(self) -> int | None:
        return None if self.supervisor else nanoseconds(self.ending.patience)

    def run(self, until: int) -> None:
        """Let the time pass to ``until`` (ns after the clock's start), press Ctrl-C, and let the processes end.

        This does what :meth:`advance` and :meth:`interrupt` do. All three should be called within :meth:`inside`.
        """
        if self.faults:
            self.faults.fits(until)
        with self._explained(None if until == FOREVER else until / NS):
            self._program.run(self.recording.start + until, self._patience)
        self._tell_idle_faults()

    def advance(self, until: int) -> None:
        """Let the simulated time pass until all that is due by ``until`` (ns after its start) has run."""
        with self._explained(until / NS):
            self._program.advance(self.recording.start + until)

    def interrupt(self) -> None:
        """Press Ctrl-C, and let the processes end."""
        assert isinstance(self.clock, Simulation)
        with self._explained(self.clock.seconds()):
            self._program.end(self._patience)
        self._tell_idle_faults()

    def _tell_idle_faults(self) -> None:
        """Say which faults have done nothing. Raises ValueError for a name that nothing has, if no process failed."""
        idle = self.faults.idle() if self.faults else []
        if not idle:
            return
        ends = [process.world.exit_status for process in self.processes if not process.world.crashed]
        # In another order than the usual one, a name may not have been there yet.
        is_usual = not (isinstance(self.clock, ExploredSimulation) and self.clock.order.made)
        with self.outside():
            for words, is_wrong in idle:
                if is_wrong and is_usual and all(status in _FINE for status in ends):
                    raise ValueError(words)
                sys.stderr.write(f"rosspin: {words}\n")

    def run_on_the_wall(self, seconds: float | None, give_up: Callable[[Result], object] | None) -> None:
        """Run the only process on the wall clock, until Ctrl-C if ``seconds`` is None. Call it within :meth:`inside`.

        With ``give_up`` this process is there only for the node: if nothing else ends the node, the process is killed.
        Before that, ``give_up`` is called with the result so far, unless code in C lets no thread run.
        """
        (process,) = self.processes
        node = process.node

        def give(killed: Killed) -> None:
            assert give_up
            self._killed(process, seconds, killed)
            give_up(self.result())

        def last_words(stacks: list[Whereabouts]) -> str:
            killed = Killed(keep_those_of(node, stacks), ignores=False)
            return say_killed(node, self.ros, seconds, self.ending.patience, killed)

        last_resort = give_up and LastResort(give, last_words)
        until = None if seconds is None else duration(seconds)
        with self._explained(seconds):
            run_on_the_wall(process.run, process.world, until, self.ending.patience, last_resort)

    @contextmanager
    def _explained(self, seconds: float | None) -> Iterator[None]:
        """Within this context processes run. What ends one from outside becomes its status, or an error in words."""
        first = self.processes[0] if self.processes else None
        try:
            yield
        except Killed as killed:
            assert first
            self._killed(first, seconds, killed)
        except Died as died:
            assert first
            first.world.exit_status = 128 + died.number
        except Ended:
            failures = [process.world.failure for process in self.processes if process.world.failure]
            failures += [self.faults.failure] if self.faults and self.faults.failure else []
            if failures:
                raise failures[0] from None
            if self.supervisor or not first or first.world.exit_status is None:
                raise
        except (Standstill, Stuck) as error:
            assert isinstance(self.clock, Simulation)
            nodes = [process.node for process in self.processes]
            raise stands_still(nodes, self.ros, error, self.clock) from None
        for process in self.processes:
            process.end_if_forked()

    def _killed(self, process: Process, seconds: float | None, killed: Killed) -> None:
        process.world.waited = killed.waited
        sys.stderr.write(say_killed(process.node, self.ros, seconds, self.ending.patience, killed))
        if killed.blocks:
            sys.stderr.write(
                "rosspin: the main thread blocks SIGINT (signal.pthread_sigmask): Ctrl-C does not reach it\n"
            )
        process.world.exit_status = 128 + signal.SIGKILL

    # --- its result ---

    @property
    def ros(self) -> int:
        """The ROS of the first process: 1 or 2. As long as it has used none and names none, it is 1."""
        return next((process.world.ros or process.node.hint for process in self.processes), 0) or 1

    def result(self) -> Result:
        """Return how the run ended."""
        status = self.supervisor.status if self.supervisor else self.processes[0].world.exit_status
        assert status is not None
        return Result(status, self.recording.start / NS, self)


class Result:
    """How a run ended: its exit ``status``, its ticks (none if not recorded) and its ``start`` (s since the epoch)."""

    def __init__(self, status: int, start: float, host: Host) -> None:
        self.status = status
        self.start = start
        self.host = host
        self._make_ticks = host.recording.ticks_later()

    @cached_property
    def ticks(self) -> tuple[Tick, ...]:
        """What has ticked."""
        return self._make_ticks()

    @property
    def world(self) -> World:
        """The world of its first process."""
        return self.host.processes[0].world

    def run(self, console: str, runtime: str, seconds: float) -> Run:
        """Return the run, whose console and whose runtime these are, and which should continue for ``seconds``."""
        recording = self.host.recording
        run = Run(
            console,
            (),
            self.status,
            runtime,
            seconds,
            self.start,
            self.messages(),
            self.calls(),
            recording.fault_events(),
            recording.coming(),
        )
        return with_ticks(run, self._make_ticks)

    def messages(self) -> tuple[Message, ...]:
        """Return what was published (nothing if not recorded)."""
        return self.host.recording.messages()

    def calls(self) -> tuple[Call, ...]:
        """Return what services were asked (nothing if not recorded)."""
        return self.host.recording.calls()


def _export(before: Mapping[bytes, bytes], after: Mapping[bytes, bytes]) -> None:
    """Tell the system of an environment: programs that are started from here take it from there."""
    for name in before.keys() - after.keys():
        os.unsetenv(name)
    for name, value in after.items():
        if before.get(name) != value:
            os.putenv(name, value)


def replaced() -> list[Patch]:
    """List what is replaced in modules while processes run; all code but theirs still gets the real thing."""
    return [*threads.PATCHES, *virtual_time.PATCHES, *signals.PATCHES, *PATCHES, *Host(Simulation(), None)._patches()]


def kept() -> list[str]:
    """List what is put back at the end of a run."""
    names = "names in rospy, rclpy, message classes and the standard library's modules"
    return [*(each.what for each in SAVED), "running loop and policy of asyncio", names]


def duration(seconds: float, name: str = "seconds") -> int:
    """Convert the length of a run, or of a step, to ns. Raises ValueError, with its ``name``, if it cannot be one."""
    if not (isinstance(seconds, (int, float)) and math.isfinite(seconds) and seconds >= 0):
        raise ValueError(f"{name} must be a number of at least 0, not {seconds!r}")
    try:
        return nanoseconds(seconds)
    except OverflowError:
        raise ValueError(f"{name} must be less than {2**63 // NS} (292 years), not {seconds!r}") from None
