"""Start nodes side by side, as in terminals of their own, and press Ctrl-C in all of them."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from functools import partial

from ..clocks.clock import NS, nanoseconds
from ..clocks.programs import Killed, ignores_ctrl_c, press_ctrl_c, where_it_waits
from ..clocks.simulation import Simulation
from .explain import say_killed
from .host import Host
from .kinds import ROS
from .process import Process
from .roslaunch.launch import Node
from .source import Code
from .streams import nowhere

__all__ = ["Together", "give_names"]


class Together:
    """Runs ``nodes``, whose code is ``codes``, in a host. Raises ValueError for attributes that need roslaunch.

    The status is from the first node that fails, or 0. In ROS 2, ending with 130 after Ctrl-C is no failure.
    """

    def __init__(self, host: Host, nodes: Sequence[Node], codes: Sequence[Code]) -> None:
        for node in nodes:
            if node.required or node.respawn:
                raise ValueError("required and respawn are for nodes of ROS 1 only, which run as under roslaunch")
        assert isinstance(host.clock, Simulation)
        self.status = 0
        self._host = host
        self._clock = host.clock
        self._nodes = list(zip(nodes, codes, strict=True))
        self._stderr = sys.stderr
        self._interrupted = False

    def run(self) -> None:
        """Start the nodes, and continue with them."""
        self.go_on([self._start(node, code) for node, code in self._nodes])

    def go_on(self, processes: Sequence[Process]) -> None:
        """Wait until Ctrl-C comes or the processes of the nodes have ended, and end those that are left."""
        self._ended = threading.Event()
        for process in processes:
            if process.world.over:
                self._note_end(process)
            else:
                process.world.at_end.append(partial(self._note_end, process))
        with suppress(KeyboardInterrupt):
            self._wait(processes)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # for this program only: its Ctrl-C may still come
        self._interrupted = True
        for process in processes:
            if not process.world.over:
                press_ctrl_c(process.world)
        self._wait(processes, nanoseconds(self._host.ending.patience))
        for process in processes:
            if not process.world.over:
                self._kill(process)

    def _start(self, node: Node, code: Code) -> Process:
        stdout = None if node.output == "screen" else nowhere()
        process = self._host.add(code, node.args, node.env, node.cwd, stdout)
        process.world.at_bind.append(lambda: give_names(process, node))
        process.give_parameters(node.parameters)
        self._host.begin(process)
        return process

    def _note_end(self, process: Process) -> None:
        status = process.world.exit_status or 0
        if process.fails_with(status, self._interrupted):
            status = 128 - status if status < 0 else status
            self._stderr.write(f"rosspin: {process.node.name} ended with status {status}\n")
            self.status = self.status or status
        self._ended.set()

    def _wait(self, processes: Sequence[Process], patience: int | None = None) -> None:
        clock = self._clock
        until = None if patience is None else clock.now() + patience
        while any(not process.world.over for process in processes) and (until is None or clock.now() < until):
            self._ended.clear()
            self._ended.wait(None if until is None else (until - clock.now()) / NS)

    def _kill(self, process: Process) -> None:
        world = process.world
        killed = Killed(where_it_waits(world), ignores_ctrl_c(world))
        self._stderr.write(say_killed(process.node, world.ros or 1, None, self._host.ending.patience, killed))
        world.exit_status = 128 + signal.SIGKILL
        self.status = self.status or world.exit_status
        self._clock.end(world)


def give_names(process: Process, node: Node) -> None:
    """Add the node's name and namespace to its command line, as its ROS takes them there."""
    ros = ROS[process.world.ros]
    names = {ros.name_key: node.name, "__ns": node.namespace.rstrip("/")}
    if given := [f"{key}:={value}" for key, value in names.items() if value]:
        process.world.argv += ros.settings("-r", given)
