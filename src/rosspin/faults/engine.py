"""Lets the faults of a run happen: the stand-ins ask about each connection and each call, the clock does the rest."""

from __future__ import annotations

import re
import signal
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from random import Random
from typing import Any, NamedTuple

from ..clocks.clock import NS, nanoseconds
from ..clocks.programs import end_run
from ..clocks.signals import Died
from ..clocks.simulation import Simulation
from ..clocks.stacks import whose
from ..world.graph import Graph, Recording
from ..world.tester import NAME as TESTER
from ..world.world import World
from . import ClockJump, Crash, Fault, Jitter, Late, Service, Slow, Topic, checked

__all__ = ["Engine", "Transport"]

_ANONYMOUS = re.compile(r"_\d+_\d+$")


class _Leg(NamedTuple):
    """What a fault does to messages on one way: how likely they are lost, and the least and the most delay (s)."""

    fault: Topic | Service
    drop: float
    delays: tuple[float, float]
    reorder: bool = False


def _leg(fault: Fault, name: str, sender: str, receiver: str, part: str) -> _Leg | None:
    """Return what a fault does to a topic's messages, or to requests or responses; None if it is about others."""
    if isinstance(fault, Topic) and not part and fault.topic == name and fault.to in ("", receiver):
        return _Leg(fault, fault.drop, _span(fault.delay), fault.reorder)
    if not (isinstance(fault, Service) and part and fault.service == name):
        return None
    if fault.client not in ("", sender if part == "request" else receiver):
        return None
    if part == "request":
        return _Leg(fault, fault.request_drop, _span(fault.request_delay))
    return _Leg(fault, fault.response_drop, _span(fault.response_delay))


def _span(delay: float | tuple[float, float]) -> tuple[float, float]:
    return delay if isinstance(delay, tuple) else (delay, delay)


class Engine:
    """The faults of one run. ``worlds()`` are its processes' so far, ``graphs()`` the graphs of its ROSes.

    Raises TypeError for what is no list of faults, ValueError for a time on a clock that begins too late for it.
    """

    failure: Exception | None = None  # what has ended the run

    def __init__(
        self,
        faults: Sequence[Fault],
        clock: Simulation,
        recording: Recording,
        worlds: Callable[[], Iterable[World]],
        graphs: Callable[[], Iterable[Graph]],
    ) -> None:
        self.clock = clock
        self.recording = recording
        self._faults = checked(faults)
        self._worlds, self._graphs = worlds, graphs
        self._happened: set[int] = set()  # the identities of those that have done something
        self._carried: Counter[int] = Counter()  # messages that a topic's faults could befall, by their identities
        self._transports: Counter[tuple[str, str, str]] = Counter()
        self._late: set[tuple[int, frozenset[str]]] = set()  # which pairs of nodes a fault has made late
        self._called: dict[str, dict[str, None]] = {}  # by node: the callbacks that were called
        self._rows: dict[tuple[int, int], Random] = {}  # by fault and process
        for fault in self._of(Jitter):
            clock.be_late(partial(self._draw, fault))
        ahead = 0
        for fault in sorted(self._of(ClockJump), key=lambda fault: fault.at):
            ahead += nanoseconds(fault.by)
            if recording.start + nanoseconds(fault.at) + ahead < 0:
                raise ValueError(f"{fault!r}: the clock would tell a time before 0; begin later, with start=1.7e9")
        for fault in self._faults:
            if isinstance(fault, (Crash, ClockJump)):
                clock.at(recording.start + nanoseconds(fault.at), partial(self._act, fault))

    def _of(self, kind: type[Any]) -> list[Any]:
        return [fault for fault in self._faults if isinstance(fault, kind)]

    def note(self, fault: Fault, *words: Any, **more: Any) -> None:
        """Record what a fault does."""
        self._happened.add(id(fault))
        self.recording.add_fault_event(*words, **more)

    def fits(self, until: int) -> None:
        """Raise ValueError for what should happen after the end of the run, ``until`` (ns after its start)."""
        for fault in self._faults:
            if isinstance(fault, (Crash, ClockJump)) and nanoseconds(fault.at) > until:
                raise ValueError(f"{fault!r}: the run ends before, at {until / NS:g} s")

    # --- topics -------------------------------------------------------------------------------------------------------

    def transport(
        self, name: str, sender: str, receiver: str, world: World, reliable: bool | None, part: str = ""
    ) -> Transport | None:
        """Return what carries messages from one node to another, whose world is given; None if nothing befalls them.

        They are for the topic ``name`` or, for a service, its "request" or "response", the ``part``. ``reliable``
        says it of a pair in ROS 2; None is TCP. The run ends with ValueError for what they cannot do.
        """
        found = [leg for fault in self._faults if (leg := _leg(fault, name, sender, receiver, part))]
        if not found or TESTER == receiver:
            return None
        for leg in found:
            if (leg.drop or leg.reorder) and reliable is not False:
                self._fail(ValueError(f"{leg.fault!r}: {_why_not(leg, sender, receiver, reliable, part)}"))
            self._carried[id(leg.fault)] += 0
        # The name of an anonymous node of ROS 1 is another one in each run.
        key = f"{name} {part}".rstrip(), _ANONYMOUS.sub("", sender), _ANONYMOUS.sub("", receiver)
        self._transports[key] += 1
        return Transport(self, found, (name, part, sender, receiver), repr((*key, self._transports[key])), world)

    def carry(self, fault: Fault) -> None:
        """Count a message that a fault could befall."""
        self._carried[id(fault)] += 1

    def _fail(self, error: Exception) -> None:
        self.failure = self.failure or error
        end_run()

    # --- nodes --------------------------------------------------------------------------------------------------------

    def discovery_delay(self, one: str, other: str) -> int:
        """Return how much (ns) later than usual two nodes of different processes find each other."""
        delay = 0
        for fault in self._of(Late):
            if fault.node in (one, other) and TESTER not in (one, other):
                delay += nanoseconds(fault.by)
                pair = id(fault), frozenset((one, other))
                if pair not in self._late:
                    self._late.add(pair)
                    which = f"{fault.node} to {one if other == fault.node else other}"
                    self.note(fault, "late", which, nanoseconds(fault.by))
        return delay

    @property
    def slows(self) -> bool:
        """Whether callbacks should be told before each call."""
        return bool(self._of(Slow) or self._of(Jitter))

    def _draw(self, fault: Jitter) -> int:
        """Draw how late (ns) the caller continues. Each process has a row of its own."""
        number = getattr(whose(), "number", -1)
        if (id(fault), number) not in self._rows:
            self._happened.add(id(fault))
            self._rows[id(fault), number] = Random(f"{fault.seed} {number}")
        return self._rows[id(fault), number].randint(1, max(nanoseconds(fault.by), 1))

    def call(self, node: str, callback: Any) -> None:
        """Let the time pass that a callback of a node takes longer. This is called in its place, just before it."""
        if self._of(Jitter):
            self.clock.sleep(1)  # which ends late
        callback = getattr(callback, "func", callback)  # of a functools.partial
        if str(getattr(callback, "__module__", "")).startswith("rosspin."):  # an action's, say, is no node's own
            return
        names = [getattr(callback, name, type(callback).__name__) for name in ("__name__", "__qualname__")]
        self._called.setdefault(node, {})[names[0]] = None
        for fault in self._of(Slow):
            if fault.node == node and fault.callback in names:
                by = nanoseconds(fault.by)
                self.note(fault, "slowed", f"{node} {names[0]}", by)
                self.clock.sleep(by)

    def _act(self, fault: Crash | ClockJump) -> None:
        if isinstance(fault, Crash):
            self._crash(fault)
        else:
            self._jump(fault)

    def _crash(self, fault: Crash) -> None:
        world = next((each for each in self._worlds() if fault.node in each.nodes and not each.over), None)
        if world is None or world.exit_status is not None:
            return
        world.crashed = True
        self.note(fault, "killed", fault.node)
        if world.main is self.clock.main:
            raise Died(signal.SIGKILL)
        world.exit_status = -signal.SIGKILL
        self.clock.end(world)

    def _jump(self, fault: ClockJump) -> None:
        by = nanoseconds(fault.by)
        self.clock.ahead += by
        self.note(fault, "set", "the clock", by)
        for world in self._worlds():
            if not world.over:
                with world.acting():
                    for function in world.at_jump:
                        function()

    # --- in the end ---------------------------------------------------------------------------------------------------

    def idle(self) -> list[tuple[str, bool]]:
        """Say why each idle fault has done nothing, and whether that is because nothing has the name that it gives."""
        return [(f"{fault!r}: {words}", is_wrong) for fault in self._faults for words, is_wrong in self._idle(fault)]

    def _idle(self, fault: Fault) -> list[tuple[str, bool]]:
        if id(fault) in self._happened:
            return []
        if isinstance(fault, Topic):
            return [self._idle_topic(fault)]
        if isinstance(fault, Service):
            if id(fault) not in self._carried:
                return [(f"no node of another process has called {fault.service}", False)]
            return [(f"it befell none of {self._carried[id(fault)]} requests and responses", False)]
        node = getattr(fault, "node", "")
        nodes = [name for world in self._worlds() for name in world.nodes]
        if node and node not in nodes:
            return [(f"there was no node {node}; there were {_list(nodes)}", True)]
        if isinstance(fault, Slow):
            return [
                (
                    f"{node} called no {fault.callback}; it called {_list(self._called.get(node, ()))}",
                    node in self._called,
                )
            ]
        if isinstance(fault, Late):
            return [(f"{node} met no node of another process", False)]
        return [("the node, or the run, had ended before", False)]

    def _idle_topic(self, fault: Topic) -> tuple[str, bool]:
        if id(fault) in self._carried:
            return f"it befell none of {self._carried[id(fault)]} messages", False
        known = dict.fromkeys(name for graph in self._graphs() for name in graph.names())
        if fault.topic not in known:
            return f"no node had the topic {fault.topic}; there were {_list(known)}", True
        if fault.to and fault.to not in [name for world in self._worlds() for name in world.nodes]:
            return f"there was no node {fault.to}", True
        return "no message of it went from one process to another", False


class Transport:
    """Carries messages of a topic from one node to another, late or not at all, as ``faults`` say."""

    def __init__(
        self, engine: Engine, legs: Sequence[_Leg], names: tuple[str, str, str, str], key: str, world: World
    ) -> None:
        self._engine = engine
        self._topic, part, self._sender, receiver = names
        self._which = f"{f'the {part} of ' if part else ''}{self._topic} from {self._sender} to {receiver}"
        self._world = world
        # Each fault draws from a row of its own, and as often whatever the others do.
        rows = [[Random(f"{leg.fault.seed} {key} {what}") for what in ("drop", "delay")] for leg in legs]
        self._legs = [(leg, drops, times) for leg, (drops, times) in zip(legs, rows, strict=True)]
        self._reorders = any(leg.reorder for leg in legs)
        self._sent = self._newest = 0  # how many messages were sent, and which of them has arrived
        self._under_way = 0
        self.last = 0  # when (ns) the last of those under way arrives

    def send(self, make: Callable[[], Any], arrive: Callable[[], object]) -> None:
        """Send a message now: it arrives by ``arrive()``, or never. ``make()`` makes a copy of it."""
        engine, clock = self._engine, self._engine.clock
        now = clock.now()
        message = self._topic, self._sender, now, make
        self._sent += 1
        arrival, lost, late = now, None, None
        for leg, drops, times in self._legs:
            engine.carry(leg.fault)
            if leg.drop and drops.random() < leg.drop:
                lost = lost or leg.fault
            if leg.delays[1]:
                arrival += nanoseconds(times.uniform(*leg.delays))
                late = leg.fault
        if lost:
            engine.note(lost, "dropped", self._which, message=message)
            return
        if not self._reorders:
            arrival = max(arrival, self.last)
        self.last = max(arrival, self.last)
        if late and arrival > now:
            engine.note(late, "delayed", self._which, arrival - now, message)
        self._at(arrival, partial(self._arrive, self._sent, message, arrive))

    def follow(self, function: Callable[[], object]) -> None:
        """Call a function after all that is under way has arrived."""
        self._at(self.last, function)

    def _at(self, when: int, function: Callable[[], object]) -> None:
        clock = self._engine.clock
        if when <= clock.now() and not self._under_way:
            function()
            return
        self._under_way += 1

        def call() -> None:
            self._under_way -= 1
            if not self._world.over:
                with self._world.acting():
                    function()

        clock.at(max(when, clock.now()), call)

    def _arrive(self, number: int, message: Any, arrive: Callable[[], object]) -> None:
        if number < self._newest:
            fault = next(leg.fault for leg, *_ in self._legs if leg.reorder)
            self._engine.note(fault, "overtaken", self._which, message=message)
            return
        self._newest = number
        arrive()


def _why_not(leg: _Leg, sender: str, receiver: str, reliable: bool | None, part: str) -> str:
    loses = f"Use {f'{part}_' if part else ''}delay=" if leg.drop else "Leave out reorder="
    if reliable is None:
        said = f"{sender} sends to {receiver} over TCP, as all of ROS 1 does, which loses nothing and keeps the order. "
        if part:
            return (
                f"{said}{loses}, or crash the service: Crash({(receiver if part == 'request' else sender)!r}, at=...)"
            )
        return (
            f"{said}{loses}; rospy loses messages only where they come faster than a callback takes them and "
            f"queue_size is small: Slow({receiver!r}, callback=..., by=...)"
        )
    best_effort = (
        "the client and the service best effort, as with qos_profile_sensor_data"
        if part
        else "the subscription best effort, as with qos_profile_sensor_data"
    )
    return (
        f"the connection from {sender} to {receiver} is reliable: what is lost on its way is sent again, comes late, "
        f"and in order. {loses}, or make {best_effort}"
    )


def _list(names: Iterable[str]) -> str:
    return ", ".join(names) or "none"
