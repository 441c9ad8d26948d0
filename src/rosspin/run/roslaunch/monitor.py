"""Start the nodes of one simulated run, watch over them, restart them and end them, as roslaunch does.

The rules are from roslaunch's pmon.py and nodeprocess.py, for a master that is running before roslaunch starts.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections import deque
from collections.abc import Sequence
from functools import partial

from ...clocks.clock import NS, nanoseconds
from ...clocks.ctrl_c import ROSLAUNCH
from ...clocks.programs import press_ctrl_c, where_it_waits
from ...clocks.signals import send
from ...clocks.simulation import Simulation
from ...clocks.threads import unlist_threads
from ...rospy.state import Master
from ...world.world import World
from ..explain import say_where
from ..host import Host
from ..kinds import ROS
from ..process import Process
from ..source import Code
from ..streams import nowhere
from ..together import Together, give_names
from .launch import Launch, Node

__all__ = ["Monitor"]

# How far apart (ns) its looks at its processes are.
_LOOK = NS // 10

# How many processes are ended at a time.
_WORKERS = 10

_RULE = "=" * 80


class _Member:
    """One of the nodes, with its process; a restart gives it a new one."""

    def __init__(self, node: Node, code: Code, number: int) -> None:
        self.node = node
        self.code = code
        self.name = f"{node.namespace.strip('/')}/{node.name or code.name}-{number}".removeprefix("/")
        self.args = [*node.args, *([f"__name:={node.name}"] if node.name else [])]
        self.process: Process  # the one that is running, or was
        self.respawns_at: int | None = None  # when (ns) it should be started again

    @property
    def world(self) -> World:
        return self.process.world

    def exit_code(self) -> int:
        """Return the exit code as roslaunch has it: negative for a signal."""
        return self.world.exit_status or 0


class Monitor:
    """Runs the nodes of a launch file, whose code is ``codes``, in a host.

    Most nodes whose code does not name their ROS import it at time 0. If its nodes run in terminals, :class:`Together`
    continues.
    """

    status = 0  # whatever becomes of the nodes of ROS 1

    def __init__(self, host: Host, launch: Launch, codes: Sequence[Code]) -> None:
        self._host = host
        assert isinstance(host.clock, Simulation)
        self._clock = host.clock
        self._parameters = launch.parameters
        self._members = [_Member(*each, number) for number, each in enumerate(zip(launch.nodes, codes), 1)]
        self._watched = list(self._members)
        self._stdout, self._stderr = sys.stdout, sys.stderr

    def run(self) -> None:
        """Set the parameters, start the nodes, watch over them until Ctrl-C comes, and end those that are left."""
        master = self._host.graph(1).part(Master)
        for name, value in self._parameters:
            master.set_param(name, value)
        if not self._members:
            self._say("No processes to monitor")
            return
        try:
            for member in self._members:
                self._start(member)
            if not all(member.code.hint for member in self._members):
                self._clock.sleep(0)
                if any(_in_terminals(member.world) for member in self._members):
                    self._hand_over()
                    return
                self._clock.sleep(_LOOK)  # its first look comes before the nodes do anything
            while self._watch():
                self._clock.sleep(_LOOK)
        except KeyboardInterrupt:
            pass
        self._end_all()

    def _hand_over(self) -> None:
        together = Together(self._host, [each.node for each in self._members], [each.code for each in self._members])
        together.go_on([member.process for member in self._members])
        self.status = together.status

    def _start(self, member: _Member) -> None:
        node = member.node
        namespace = node.namespace.rstrip("/")
        environment = {**node.env, **({"ROS_NAMESPACE": namespace} if namespace else {})}
        stdout = None if node.output == "screen" else nowhere()
        process = member.process = self._host.add(member.code, member.args, environment, node.cwd, stdout)
        process.world.at_bind.append(lambda: _rename(process, node))
        process.give_parameters(node.parameters)
        self._host.begin(process)

    def _watch(self) -> bool:
        """Look at the processes, and return whether anything is left to watch."""
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

    def _death(self, member: _Member) -> str:
        code = member.exit_code()
        if not code:
            return "process has finished cleanly"
        return f"process has died [exit code {code}, cmd {' '.join([member.code.argv0, *member.args])}]."

    def _end_all(self) -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # for this program only: its Ctrl-C may still come
        waiting = deque(reversed(self._watched))
        errors: list[str] = []
        workers = [threading.Thread(target=self._end_some, args=(waiting, errors)) for _ in range(_WORKERS)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        if errors:
            self._complain("\n".join(["Shutdown errors:", *errors]))

    def _end_some(self, waiting: deque[_Member], errors: list[str]) -> None:
        while waiting:
            member = waiting.popleft()
            self._say(f"[{member.name}] killing on exit")
            if ROSLAUNCH.carry_out(partial(self._send, member), partial(self._ends_within, member)) == signal.SIGKILL:
                errors.append(f" * process[{member.name}]: required SIGKILL. May still be running.")

    def _send(self, member: _Member, number: signal.Signals) -> None:
        world = member.world
        if number != signal.SIGINT:
            self._complain(f"[{member.name}] escalating to {number.name}")
        if number == signal.SIGKILL:
            self._stderr.write(say_where(member.code, where_it_waits(world)))
            self._clock.end(world)
        elif number == signal.SIGTERM:
            send(world, number)
        elif not world.over:
            press_ctrl_c(world)

    def _ends_within(self, member: _Member, seconds: float) -> bool:
        until = self._clock.now() + nanoseconds(seconds)
        while not member.world.over and self._clock.now() < until:
            self._clock.sleep(_LOOK)
        return member.world.over

    def _say(self, text: str) -> None:
        self._stdout.write(text + "\n")

    def _complain(self, text: str) -> None:
        self._stderr.write(f"\033[31m{text}\033[0m\n" if self._stderr.isatty() else text + "\n")


def _in_terminals(world: World) -> bool:
    return world.ros != 0 and ROS[world.ros].in_terminals


def _rename(process: Process, node: Node) -> None:
    """Give a process its names in the words of its ROS, if that is not roslaunch's."""
    if _in_terminals(process.world):
        process.world.argv[1:] = node.args
        give_names(process, node)
