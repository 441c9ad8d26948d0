"""Run a node in steps of simulated time and play its counterpart: for tests that publish, wait, and look."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import NoneType, TracebackType
from typing import TYPE_CHECKING, Any

from ..clocks.clock import NS
from ..clocks.explored import ExploredSimulation, Order
from ..clocks.frames import is_statement, node_frames
from ..clocks.programs import end_run
from ..clocks.simulation import Simulation
from ..results.ticks import Message, Run
from ..world.graph import Graph, Recording, TickLog
from ..world.world import World
from .host import Host, duration
from .kinds import ROS
from .process import Process
from .ros2launch.launch_file import LaunchFile
from .roslaunch.launch import Node
from .simulate import prepare, supervisor, with_jitter
from .source import NodeLike, refuse_text, warn_of_files
from .streams import Capture

if TYPE_CHECKING:
    from ..faults import Fault

__all__ = ["NodeFailed", "StartedNode", "start", "start_in_order"]

# How many lines of a failed node's console, the last ones, are shown.
_LINES = 10


class NodeFailed(RuntimeError):
    """A started node has ended with a status other than 0, or not at all. The message says how, and what it printed."""


def start(
    node: NodeLike | Sequence[NodeLike | Node],
    args: Sequence[str] = (),
    parameters: Mapping[str, Any] | None = None,
    *,
    faults: Sequence[Fault] = (),
    jitter: float = 0.0,
) -> StartedNode:
    """Start a node, or several, in simulated time, to be run in steps.

    ``node`` and ``args`` are as for :func:`simulate`; ``parameters`` are set before a node runs, as by a launch file:
    in ROS 1 private ones by names such as ``"~rate"``, in ROS 2 those that it declares. What is due at 0 s has run when
    this returns; the time then waits for :meth:`StartedNode.advance`. ``faults`` and ``jitter`` are as for
    :func:`simulate`; a node that a fault kills has not failed. Raises what :func:`simulate` and ``advance`` raise,
    TypeError for a value that no parameter can have, and ValueError for parameters of several nodes: give each of them
    its own, with :class:`Node`.
    """
    __tracebackhide__ = True  # pytest shows the lines of the test and of the node, not these
    return start_in_order(None, node, args, parameters, with_jitter(faults, jitter))


def start_in_order(
    order: Order | None,
    node: NodeLike | Sequence[NodeLike | Node],
    args: Sequence[str],
    parameters: Mapping[str, Any] | None,
    faults: Sequence[Fault] = (),
) -> StartedNode:
    """Do what :func:`start` does, in an order of events that may be another than the usual one."""
    __tracebackhide__ = True
    refuse_text(args)
    if not isinstance(parameters, (Mapping, NoneType)):
        raise TypeError(f"parameters are given by name, as in {{'rate': 10.0}}, not as {parameters!r}")
    return StartedNode(node, args, parameters or {}, faults, order)


class StartedNode:
    """A node that :func:`start` has started. Use it as a context: at the end it presses Ctrl-C, see :meth:`close`.

    The node runs, and time passes, only within the methods below. The node has its own command line, environment,
    working directory, modules and loggers, none of which can be seen outside of these methods.

    A second node in the graph, ``/tester``, is connected to every topic of the node as soon as the node has it, and
    publishes what the test publishes. If several nodes were started, "the node" below means each of them, and ``name``
    is their names.
    """

    def __init__(
        self,
        node: NodeLike | Sequence[NodeLike | Node],
        args: Sequence[str],
        parameters: Mapping[str, Any],
        faults: Sequence[Fault] = (),
        order: Order | None = None,
    ) -> None:
        __tracebackhide__ = True
        launched, codes, *_ = prepare(node, args, skip_cpp=False, shaken=order is not None and order.deep)
        if launched and parameters:
            raise ValueError("give each of several nodes its own parameters: rosspin.Node(node, parameters=...)")
        if isinstance(launched, LaunchFile):
            names = [launched.path]
        else:
            names = [code.argv0 for code in codes]
        self.name = ", ".join(Path(name).name for name in names)  # of files, or of functions
        self._capture = Capture()
        self._order = order
        self._clock = ExploredSimulation(order) if order else Simulation()
        self._host = Host(self._clock, TickLog(), launched is not None, faults)
        self._host.on_failure = self._clock.pause
        self._host.at_graph.append(self._take_part)
        self._testers: dict[int, Any] = {}
        self._now = 0
        self._messages: list[Message] = []  # all of the run
        self._fault_events = 0  # how many were told
        self._closed = False
        self._raised: set[int] = set()  # the identities of the nodes' errors that were raised
        self._status_raised = False
        self._trace: TracebackType | None = None  # the lines of the test in which it failed
        with self._inside():
            if launched:
                self._host.supervisor = supervisor(launched, self._host, codes)
            else:
                warn_of_files(codes)
                self._host.add(codes[0], args).give_parameters(parameters)
        try:
            self.advance(0)
        except BaseException:
            self._abandon()
            raise
        if isinstance(self._clock, ExploredSimulation):
            self._clock.in_steps = True

    def _take_part(self, ros: int, graph: Graph) -> None:
        """Join the graph of a ROS, as another node, when a node has used it for the first time."""
        world = World(self._clock, [], Recording(self._clock, None), lambda ros: graph)
        world.bind(ros)
        graph.tester = self._testers[ros] = ROS[ros].tester.Tester(world, _Messages(self._host, ros), self._fail)

    def _fail(self, error: Exception) -> None:
        """End the run with an error that is the test's, not the node's."""
        self._host.processes[0].world.failure = error
        self._trace = node_frames(error.__traceback__)
        end_run()

    def __enter__(self) -> StartedNode:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        __tracebackhide__ = True
        if error is None:
            self.close()
        else:
            self._abandon()  # the first error is the one to report

    @property
    def time(self) -> float:
        """The simulated time, in seconds since the start."""
        return self._now / NS

    @property
    def status(self) -> int | None:
        """The node's exit status; None while it runs. Of several: the first that is not 0, else None while one runs."""
        self._note_look()
        return self._status()

    def _status(self) -> int | None:
        statuses = [self._status_of(process) for process in self._host.processes]
        return next(filter(None, statuses), None if None in statuses else 0)

    def _failed(self, process: Process) -> bool:
        """Whether a process has ended with a status that means failure."""
        return process.fails_with(self._status_of(process) or 0, self._closed)

    def _status_of(self, process: Process) -> int | None:
        world = process.world
        status = world.main_status or None if world.exit_status is None else world.exit_status
        return status if status is None or status >= 0 else 128 - status

    @property
    def run(self) -> Run:
        """All that the node has done so far. While it runs, ``run.status`` is 0 and ``run.seconds`` is the time."""
        self._note_look()
        return self._run_since(0, 0, 0, 0, 0, 0)

    def advance(self, seconds: float) -> Run:
        """Let ``seconds`` of simulated time pass. Returns what the node has done meanwhile.

        What is due exactly at the end has run. If the node ends with status 0, the time passes without it.

        An exception that the node does not catch, in its main program, a callback, a timer or another thread, is raised
        here, and the time stops at that instant. As on a real ROS, the node continues unless it was its main program.

        Also raises :class:`NodeFailed` if the node ends with another status, ValueError if ``seconds`` is negative, too
        large or not a number, RuntimeError after :meth:`close` or in another thread than before, and
        :class:`TimeStandsStill` and :class:`NotSimulated` as :func:`simulate` does.
        """
        __tracebackhide__ = True
        if self._closed:
            raise RuntimeError(f"the node was closed at {self.time} s")
        until = self._now + duration(seconds)
        if self._order:
            self._order.begin_step(is_looked_at=not is_statement(sys._getframe(1)))
        return self._step(until, lambda: self._host.advance(until))

    def close(self) -> None:
        """Press Ctrl-C, let the node end, and check that it does so with status 0. Another call does nothing.

        In ROS 2, the status may also be 130: the node did not catch the KeyboardInterrupt. A fault that
        names what the run does not have is a ValueError now.

        Raises :class:`NodeFailed` if the status is another one, or if the node has not ended 17 s later, and what the
        node raises meanwhile.
        """
        __tracebackhide__ = True
        if not self._closed:
            self._closed = True
            self._host.on_failure = None
            self._step(self._now, self._host.interrupt)

    def _abandon(self) -> None:
        try:
            self.close()
        except Exception:
            pass

    def publish(self, topic: str, /, *args: Any, **fields: Any) -> None:
        """Publish a message to the node, which receives it without delay: at the present time, in the next ``advance``.

        Give it as to ``rospy.Publisher.publish``: as a whole message, as all its fields, or as some of them by name.
        Its class is the class of the node's subscriber. By name, a dict is a nested message, and a number of seconds
        for a time: ``node.publish("/range", range=0.5, header={"stamp": node.time})``. In ROS 2 the whole message may
        be such a dict, too.

        Raises LookupError if the node does not subscribe to the topic. For unknown fields or wrong values, raises what
        ``rospy.Publisher.publish`` or, in ROS 2, the message's class raises.
        """
        self._act(lambda tester: tester.publish(topic, args, fields))

    def message(self, type: str, /, **fields: Any) -> Any:
        """Make a message of a type that a node can import, as in ``node.message("std_msgs/UInt32", data=1)``.

        Raises LookupError if there is no such type, and what the class raises for wrong fields.
        """
        return self._tester(lambda tester: tester.message(type, fields))

    def messages(self, topic: str) -> list[Message]:
        """Return all messages that were published on a topic so far, without the test's.

        Raises LookupError if the node does not publish on it.
        """
        self._note_look()
        name = self._tester(lambda tester: tester.published(topic))
        return [message for message in self._messages if message.topic == name]

    def call(self, service: str, /, *args: Any, **fields: Any) -> None:
        """Call a service of the node, which receives the request without delay, in the next ``advance``.

        Give the request as a message to :meth:`publish`: ``node.call("/drive", data=True)``. The ``calls`` of the run
        have it, and the response as soon as that was sent: in the step's, and in ``node.run``. So does a
        call for the parameters of a node of ROS 2: ``node.call("/spinner/get_parameters", names=["frequency"])``.

        Raises LookupError if no node offers the service, and for wrong requests what ``publish`` raises.
        """
        self._act(lambda tester: tester.call(service, args, fields))

    def send_goal(self, action: str, /, **fields: Any) -> None:
        """Send a goal to an action of a node of ROS 2, and ask for the result as soon as it is accepted.

        The run's ``calls`` have both, of ``<action>/_action/send_goal`` and of ``<action>/_action/get_result``;
        ``node.messages("<action>/_action/feedback")`` has the feedback. Raises what :meth:`call` raises.
        """
        self._act(lambda tester: tester.send_goal(action, fields))

    def serve(self, service: str, type: str, handler: Callable[[Any], Mapping[str, Any] | None]) -> None:
        """Offer a service to the node: ``node.serve("/drive", "std_srvs/SetBool", lambda request: {"success": True})``.

        ``handler(request)`` returns the fields of the response. It is called in a thread of its own for each request,
        and may sleep there, in simulated time. If it returns None, there is no response: in ROS 1 the call fails, in
        ROS 2 it waits forever. ``advance`` raises what it raises, and ends the run.

        Raises LookupError if there is no such type.
        """
        self._tester(lambda tester: tester.serve(service, type, handler))

    def _note_look(self) -> None:
        if self._order:
            self._order.note_look()

    def _act(self, act: Callable[[Any], None]) -> None:
        if self._order:
            self._order.note_act()
        self._tester(act)

    def _tester(self, ask: Callable[[Any], Any]) -> Any:
        """Ask the testers, one for each ROS, until one can answer. LookupError if none can."""
        if not self._testers:  # the node has used no ROS
            with self._inside():
                self._host.graph(self._host.ros)
        for number, tester in enumerate(self._testers.values(), 1):
            try:
                return ask(tester)
            except LookupError:
                if number == len(self._testers):
                    raise

    @contextmanager
    def _inside(self) -> Iterator[None]:
        with self._capture.redirected(), self._host.inside():
            yield

    def _step(self, until: int, go_on: Callable[[], None]) -> Run:
        __tracebackhide__ = True
        recording = self._host.recording
        before = len(self._capture), len(recording.log or ()), len(self._messages), len(recording)
        fault_events, time = self._fault_events, self._now
        try:
            with self._inside():
                go_on()
        except Exception as failure:
            raise failure.with_traceback(self._trace or failure.__traceback__)
        self._messages += recording.messages(len(self._messages))
        self._fault_events = recording.fault_event_count
        failed = [(process, error) for process in self._host.processes for error in process.world.errors]
        failed = [each for each in failed if id(each[1]) not in self._raised]
        self._raised |= {id(error) for _, error in failed}  # unique: the worlds keep these errors
        if self._closed:
            failed = [each for each in failed if not self._is_end(*each)]
        deaths = list(filter(self._failed, self._host.processes))
        died = bool(deaths) and not self._status_raised
        if not self._closed:  # else it stays the time of Ctrl-C
            self._now = self._clock.now() if failed or died else until
        self._status_raised = bool(deaths)
        errors = [error for _, error in failed]
        name = next((Path(each.node.argv0).name for each in (*(each for each, _ in failed), *deaths)), self.name)
        if errors and isinstance(errors[0], Exception):
            error, *others = errors
            error.add_note(f"raised in {name} at {self.time} s")
            for other in others:
                error.add_note(f"then there was {other!r}")
            raise error.with_traceback(node_frames(error.__traceback__))
        if errors or died:
            how = f"ended with status {self._status_of(deaths[0])}" if died else f"raised {errors[0]!r}"
            when = f"after Ctrl-C at {self.time} s" if self._closed else f"at {self.time} s"
            lines = self._capture.text().splitlines()[-_LINES:]
            raise NodeFailed("\n".join([f"{name} {how} {when}", *lines])) from (errors[0] if errors else None)
        return self._run_since(*before, fault_events, time)

    def _is_end(self, process: Process, error: BaseException) -> bool:
        """Whether an error is how a node of ROS 2 ends at Ctrl-C."""
        return isinstance(error, KeyboardInterrupt) and process.raises_at_ctrl_c and not self._failed(process)

    def _run_since(self, piece: int, tick: int, message: int, call: int, fault_event: int, time: int) -> Run:
        """Return what the node has done since ``time`` (ns): its ticks, messages and so on, from these numbers on."""
        return Run(
            self._capture.text(piece),
            self._host.recording.ticks(tick),
            self._status() or 0,
            "simulated",
            (self._now - time) / NS,
            0.0,
            tuple(self._messages[message:]),
            self._host.recording.calls(call),
            self._host.recording.fault_events(fault_event),
            self._host.recording.coming(),
        )


class _Messages:
    """The classes of messages and services that any of the nodes can import, as a finder's ``messages`` has them."""

    def __init__(self, host: Host, ros: int) -> None:
        self._host = host
        self._ros = ros

    def __getitem__(self, name: str) -> Any:
        return self._find(lambda messages: messages[name])

    def whole(self, folder: str, name: str) -> Any:
        return self._find(lambda messages: messages.whole(folder, name))

    def _find(self, look: Callable[[Any], Any]) -> Any:
        for process in self._host.processes:
            if process.world.ros in (0, self._ros):
                with suppress(KeyError):
                    return look(process.messages)
        raise KeyError
