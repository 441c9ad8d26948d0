"""Run a node in steps of simulated time and play its counterpart: for tests that publish, wait, and look."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import NoneType, TracebackType
from typing import Any

from ..clocks.clock import NS
from ..clocks.frames import node_frames
from ..clocks.programs import SimulatedProgram
from ..clocks.simulation import Simulation
from ..clocks.stacks import acting_for
from ..results.ticks import Message, Run
from ..rospy import tester as rospy_tester
from ..world.world import World
from .process import Capture, NodeLike, Process, load, refuse_text
from .simulate import PATIENCE, duration, explained, messages_of, new_world, run_main, stand_in, ticks_of, warn_of_files

__all__ = ["NodeFailed", "StartedNode", "start"]

_INTERRUPTED = 128 + signal.SIGINT

# So many lines of its console, the last ones, are shown of a node that failed.
_LINES = 10


class NodeFailed(RuntimeError):
    """A started node has ended with a status other than 0, or not at all. The message says how, and what it printed."""


def start(node: NodeLike, args: Sequence[str] = (), parameters: Mapping[str, Any] | None = None) -> StartedNode:
    """Start a node in simulated time, to be run in steps.

    ``node`` and ``args`` are as for :func:`simulate`; ``parameters`` are set before the node runs, as by a launch file:
    in ROS 1 private ones by names such as ``"~rate"``, in ROS 2 those that it declares. What is due at 0 s has run when
    this returns; the time then waits for :meth:`StartedNode.advance`. Raises what :func:`simulate` does, what
    ``advance`` does, and TypeError for a value that no parameter can have.
    """
    __tracebackhide__ = True  # pytest shows the lines of the test and of the node, not these
    refuse_text(args)
    if not isinstance(parameters, (Mapping, NoneType)):
        raise TypeError(f"parameters are given by name, as in {{'rate': 10.0}}, not as {parameters!r}")
    return StartedNode(node, args, parameters or {})


class StartedNode:
    """A node that :func:`start` has started. Use it as a context: at the end it presses Ctrl-C, see :meth:`close`.

    Nothing of the node runs, and no time passes, but in its methods. The node has its own command line, environment,
    working directory, modules and loggers; outside of these methods nothing of them is to be seen.

    In the graph there is a second node, ``/tester``, which is connected to every topic of the node as soon as the node
    has it, and which publishes what the test publishes.
    """

    def __init__(self, node: NodeLike, args: Sequence[str], parameters: Mapping[str, Any]) -> None:
        __tracebackhide__ = True
        self._node = load(node)
        self.name = Path(self._node.argv0).name  # of the file, or of the function
        ros = stand_in(self._node.ros)
        tester = _tester(self._node.ros)
        self._process = Process(self._node, args, ros.MODULES, self._node.ros)
        self._capture = Capture()
        self._clock = Simulation()
        self._now = 0
        self._messages: list[Message] = []  # all of the run
        self._closed = False
        self._raised = 0  # of the node's errors so many were raised
        self._status_raised = False
        with self._inside():
            warn_of_files([self._node])
            self._world = world = new_world(self._node, self._clock, record=True)
            world.on_failure = self._clock.pause
            own_world = World(self._clock, [], False, world.graph)
            world.graph.tester = self._tester = tester.Tester(own_world, self._process.messages)
            with acting_for(world):
                tester.give_parameters(world, parameters)
            self._program = SimulatedProgram(lambda: run_main(self._node, world), world, self._clock)
        try:
            self.advance(0)
        except BaseException:
            self._abandon()
            raise

    def __enter__(self) -> StartedNode:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        __tracebackhide__ = True
        if error is None:
            self.close()
        else:
            self._abandon()  # what has gone wrong first is what there is to be said

    @property
    def time(self) -> float:
        """The simulated time, in seconds since the start."""
        return self._now / NS

    @property
    def status(self) -> int | None:
        """The node's exit status; None while it runs."""
        world = self._world
        return world.main_status or None if world.exit_status is None else world.exit_status

    @property
    def run(self) -> Run:
        """All that the node has done so far. While it runs, ``run.status`` is 0 and ``run.seconds`` is the time."""
        return self._run_since(0, 0, 0, 0)

    def advance(self, seconds: float) -> Run:
        """Let ``seconds`` of simulated time pass; what the node has done meanwhile.

        What is due exactly at the end has run. If the node ends with status 0, the time passes without it.

        An exception that the node does not catch, in its main program, a callback, a timer or another thread, is raised
        here, and the time stops at that instant. As on a real ROS, the node goes on unless it was its main program.

        Also raises :class:`NodeFailed` if the node ends with another status, ValueError if ``seconds`` is negative, too
        large or not a number, RuntimeError after :meth:`close` or in another thread than before, and
        :class:`TimeStandsStill` and :class:`NotSimulated` as :func:`simulate` does.
        """
        __tracebackhide__ = True
        if self._closed:
            raise RuntimeError(f"the node was closed at {self.time} s")
        until = self._now + duration(seconds)
        return self._step(until, lambda: self._program.advance(until))

    def close(self) -> None:
        """Press Ctrl-C, let the node end, and check that it does so with status 0. Another call does nothing.

        In ROS 2, the status may also be 130: that of a node that does not catch the KeyboardInterrupt.

        Raises :class:`NodeFailed` if the status is another one, or if the node has not ended 17 s later, and what the
        node raises meanwhile.
        """
        __tracebackhide__ = True
        if not self._closed:
            self._closed = True
            self._world.on_failure = None
            self._step(self._now, lambda: self._program.end(PATIENCE * NS))

    def _abandon(self) -> None:
        try:
            self.close()
        except Exception:
            pass

    def publish(self, topic: str, /, *args: Any, **fields: Any) -> None:
        """Publish a message to the node, which receives it at once: at the present time, in the next ``advance``.

        As with ``rospy.Publisher.publish`` it is given whole, by all its fields, or by some of them by name; its class
        is that of the node's subscriber. By name a dict stands for a nested message, and a number for a time, in
        seconds: ``node.publish("/range", range=0.5, header={"stamp": node.time})``. In ROS 2 the whole message may be
        such a dict, too.

        Raises LookupError if the node does not subscribe to the topic, and what ``rospy.Publisher.publish`` or, in
        ROS 2, the message's class does if it has no such fields or they cannot have these values.
        """
        self._tester.publish(topic, args, fields)

    def message(self, type: str, /, **fields: Any) -> Any:
        """A message of any type that the node can import: ``node.message("geometry_msgs/Twist", linear={"x": 0.5})``.

        Raises LookupError if there is none, and what the class does for wrong fields.
        """
        return self._tester.message(type, fields)

    def messages(self, topic: str) -> list[Message]:
        """All messages that were published on a topic so far, without those of the test.

        Raises LookupError if the node does not publish on it.
        """
        name = self._tester.published(topic)
        return [message for message in self._messages if message.topic == name]

    @contextmanager
    def _inside(self) -> Iterator[None]:
        with self._capture.redirected(), self._process.inside():
            yield

    def _step(self, until: int, go_on: Callable[[], None]) -> Run:
        __tracebackhide__ = True
        world = self._world
        before = len(self._capture), len(world.graph.ticks or ()), len(self._messages), self._now
        with self._inside(), explained(self._node, world, self._clock, self.time):
            go_on()
        self._messages += messages_of(world.graph, 0, len(self._messages))
        status = self.status or 0
        errors = world.errors[self._raised :]
        if self._closed and self._node.ros == 2 and status == _INTERRUPTED:
            # In ROS 2 this is how most nodes end at Ctrl-C.
            status, errors = 0, [error for error in errors if not isinstance(error, KeyboardInterrupt)]
        died = bool(status) and not self._status_raised
        if not self._closed:  # else it stays the time of Ctrl-C
            self._now = self._clock.now() if errors or died else until
        self._raised, self._status_raised = len(world.errors), bool(status)
        if errors and isinstance(errors[0], Exception):
            error, *others = errors
            error.add_note(f"raised in {self.name} at {self.time} s")
            for other in others:
                error.add_note(f"then there was {other!r}")
            raise error.with_traceback(node_frames(error.__traceback__))
        if errors or died:
            how = f"ended with status {status}" if died else f"raised {errors[0]!r}"
            when = f"after Ctrl-C at {self.time} s" if self._closed else f"at {self.time} s"
            lines = self._capture.text().splitlines()[-_LINES:]
            raise NodeFailed("\n".join([f"{self.name} {how} {when}", *lines])) from (errors[0] if errors else None)
        return self._run_since(*before)

    def _run_since(self, piece: int, tick: int, message: int, time: int) -> Run:
        """What the node has done from these pieces of its console, ticks and messages on, since the time ``time``."""
        return Run(
            self._capture.text(piece),
            ticks_of(self._world.graph, 0, tick),
            self.status or 0,
            "simulated",
            (self._now - time) / NS,
            0.0,
            tuple(self._messages[message:]),
        )


def _tester(ros: int) -> Any:
    """The module with the test's node in a ROS."""
    if ros == 2:
        from ..rclpy import tester  # loaded, as all of rclpy, only for nodes that need it

        return tester
    return rospy_tester
