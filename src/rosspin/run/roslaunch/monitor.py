"""Start the nodes of one simulated run, watch over them, start them anew and end them, as roslaunch does.

The rules are those of roslaunch's pmon.py and nodeprocess.py, where a master is running before roslaunch starts.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from types import ModuleType

from ...clocks.clock import NS, nanoseconds
from ...clocks.frames import Whereabouts
from ...clocks.programs import Died, begin_beside, press_ctrl_c, send, where_it_waits
from ...clocks.simulation import Simulation
from ...clocks.threads import unlist_threads
from ...world.graph import Graph
from ...world.world import World
from ..process import Node as Code
from ..processes import Processes
from .launch import Node

__all__ = ["Member", "Monitor"]

# So often (ns) it looks at its processes.
_LOOK = NS // 10

# So long (s) does it wait for a process that was sent SIGINT, and then SIGTERM.
_PATIENCE = 15
_LAST_PATIENCE = 2

# So many processes are ended at a time.
_WORKERS = 10

_RULE = "=" * 80


class Member:
    """One of the nodes: its process, and then the one that takes its place."""

    def __init__(self, node: Node, code: Code, number: int) -> None:
        self.node = node
        self.code = code
        self.name = f"{node.namespace.strip('/')}/{node.name or _name(code)}-{number}".removeprefix("/")
        self.args = [*node.args, *([f"__name:={node.name}"] if node.name else [])]
        self.world: World  # that of the process that is running, or was
        self.respawns_at: int | None = None  # when (ns) it is to live again

    def exit_code(self) -> int:
        """As roslaunch has it: negative for a signal."""
        return self.world.exit_status or 0


class Monitor:
    """Runs nodes on a simulated clock, as a program of its own there.

    ``run_main(code, world)`` is to do with a node's code what the interpreter does with a program. ``stand_ins`` are
    the modules that the nodes are given, and ``ros`` is which ROS they import messages of.
    ``describe(code, waited)`` puts into words where the threads of a process were that had to be killed.
    """

    def __init__(
        self,
        members: Sequence[Member],
        clock: Simulation,
        graph: Graph,
        run_main: Callable[[Code, World], None],
        describe: Callable[[Code, list[Whereabouts]], str],
        stand_ins: Mapping[str, ModuleType],
        ros: int,
    ) -> None:
        self.members = members
        self._clock = clock
        self._graph = graph
        self._run_main = run_main
        self._describe = describe
        self._ros = ros
        self._processes = Processes([member.code for member in members], stand_ins)
        self._watched = list(members)
        self._started = 0
        self._stdout, self._stderr = sys.stdout, sys.stderr

    def __enter__(self) -> Monitor:
        self._processes.__enter__()
        return self

    def __exit__(self, *error: object) -> None:
        for member in self.members[: self._started]:
            unlist_threads(member.world)
        self._processes.__exit__(*error)

    def run(self) -> None:
        """Start the nodes, watch over them until Ctrl-C comes or they have ended, and end those that are left."""
        if not self.members:
            self._say("No processes to monitor")
            return
        try:
            for member in self.members:
                self._start(member)
            while self._watch():
                self._clock.sleep(_LOOK)
        except KeyboardInterrupt:
            pass
        self._end_all()

    def _start(self, member: Member) -> None:
        self._started += 1
        node = member.node
        namespace = node.namespace.rstrip("/")
        environment = {**node.env, **({"ROS_NAMESPACE": namespace} if namespace else {})}
        argv = [member.code.argv0, *member.args]
        world = member.world = World(self._clock, argv, self._graph.ticks is not None, self._graph, self._started)
        world.at_end.append(lambda: self._processes.remove(world))
        self._processes.add(world, member.code, argv, self._ros, environment, node.cwd, node.output != "screen")
        begin_beside(lambda: self._live(member, world), world, self._clock)

    def _live(self, member: Member, world: World) -> None:
        """What the main stack of a process does."""
        try:
            self._run_main(member.code, world)
        except Died as died:
            world.exit_status = -died.number
        self._clock.end(world)

    def _watch(self) -> bool:
        """Look at the processes; whether there is anything left to do."""
        for member in list(self._watched):
            if member.respawns_at is None and member.world.over:
                unlist_threads(member.world)
                if member.node.required:
                    text = f"REQUIRED process [{member.name}] has died!\n{self._death(member)}\nInitiating shutdown!\n"
                    self._complain(f"{_RULE}{text}{_RULE}")
                    return False
                (self._complain if member.exit_code() else self._say)(f"[{member.name}] {self._death(member)}")
                if member.node.respawn:
                    member.respawns_at = self._clock.now() + nanoseconds(member.node.respawn_delay)
                else:
                    self._watched.remove(member)
        if not self._watched:
            self._say("all processes on machine have died, roslaunch will exit")
        for member in self._watched:
            if member.respawns_at is not None and member.respawns_at <= self._clock.now():
                member.respawns_at = None
                self._say(f"[{member.name}] restarting process")
                self._start(member)
        return bool(self._watched)

    def _death(self, member: Member) -> str:
        code = member.exit_code()
        if not code:
            return "process has finished cleanly"
        return f"process has died [exit code {code}, cmd {' '.join([member.code.argv0, *member.args])}]."

    def _end_all(self) -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # this program's own: Ctrl-C may come only now
        waiting = deque(reversed(self._watched))
        errors: list[str] = []
        workers = [threading.Thread(target=self._end_some, args=(waiting, errors)) for _ in range(_WORKERS)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        if errors:
            self._complain("\n".join(["Shutdown errors:", *errors]))

    def _end_some(self, waiting: deque[Member], errors: list[str]) -> None:
        while waiting:
            member = waiting.popleft()
            self._say(f"[{member.name}] killing on exit")
            if self._end(member):
                errors.append(f" * process[{member.name}]: required SIGKILL. May still be running.")

    def _end(self, member: Member) -> bool:
        """End a process; whether it had to be killed."""
        world = member.world
        if not world.over:
            press_ctrl_c(world)
        if self._ends_within(world, _PATIENCE):
            return False
        self._complain(f"[{member.name}] escalating to SIGTERM")
        send(world, signal.SIGTERM)
        if self._ends_within(world, _LAST_PATIENCE):
            return False
        self._complain(f"[{member.name}] escalating to SIGKILL")
        self._stderr.write(self._describe(member.code, where_it_waits(world)))
        self._clock.end(world)
        return True

    def _ends_within(self, world: World, seconds: int) -> bool:
        until = self._clock.now() + seconds * NS
        while not world.over and self._clock.now() < until:
            self._clock.sleep(_LOOK)
        return world.over

    def _say(self, text: str) -> None:
        self._stdout.write(text + "\n")

    def _complain(self, text: str) -> None:
        self._stderr.write(f"\033[31m{text}\033[0m\n" if self._stderr.isatty() else text + "\n")


def _name(code: Code) -> str:
    """What a node without a name is called on the console."""
    return os.path.basename(code.argv0).removesuffix(".py")
