"""What the processes of one run share: a recording, and the topics of each ROS.

Only what every ROS has in common is here. Each ROS decides who is told of whom, when nodes connect, what a queue keeps.
"""

from __future__ import annotations

import gc
import math
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from itertools import chain, repeat
from typing import Any, Generic, Protocol, TypeVar
from weakref import WeakSet

from ..clocks.clock import NS, Clock
from ..clocks.frames import Trail
from ..results.ticks import Call, FaultEvent, Message, Tick
from .watcher import Watcher

__all__ = [
    "CallMade",
    "Counterpart",
    "Endpoint",
    "Faults",
    "Graph",
    "Published",
    "RecordedEndpoint",
    "Recording",
    "Records",
    "TickLog",
    "Transport",
    "unpacked",
]

Part = TypeVar("Part")


class Endpoint(Protocol):
    """A node's endpoint of a topic: a publication or a subscription."""

    @property
    def topic(self) -> str:
        """The topic's full name."""

    @property
    def type(self) -> str:
        """The type of its messages, as in std_msgs/String."""


class Counterpart(Protocol):
    """Has an endpoint of its own for each one that the nodes have: the node that a test plays."""

    def publication(self, subscription: Any) -> Any:
        """Return its endpoint for a subscription."""

    def subscription(self, publication: Any) -> Any:
        """Return its endpoint for a publication."""


class Transport(Protocol):
    """Carries the messages from one endpoint of a topic to another, on which a fault of the run acts.

    ``last`` is when (ns) the last of those that were sent arrives.
    """

    last: int

    def send(self, make: Callable[[], Any], arrive: Callable[[], object]) -> None:
        """Send a message now: it arrives by ``arrive()``, or never. ``make()`` makes a copy of it."""

    def follow(self, function: Callable[[], object]) -> None:
        """Call a function after all that is under way has arrived."""


class Faults(Protocol):
    """What should go wrong in a run."""

    @property
    def slows(self) -> bool:
        """Whether callbacks should be told before each call."""

    def call(self, node: str, callback: Any) -> None:
        """Let the time pass that a callback of a node takes longer. This is called in its place, just before it."""

    def discovery_delay(self, one: str, other: str) -> int:
        """Return how much (ns) later than usual two nodes of different processes find each other."""

    def transport(
        self, name: str, sender: str, receiver: str, world: Any, reliable: bool | None, part: str = ""
    ) -> Transport | None:
        """Return what carries messages from one node to another, whose world is given; None if nothing befalls them.

        They are for the topic ``name`` or, for a service, its "request" or "response", the ``part``. ``reliable``
        says it of a pair in ROS 2; None is TCP. The run ends with ValueError for what they cannot do.
        """


E = TypeVar("E", bound=Endpoint)

# A message as it is recorded: topic, node, time (ns), and a function that makes the message when someone asks for it.
Published = tuple[str, str, int, Callable[[], Any]]


_FIELDS = 5  # of a tick in a TickLog

# Ticks as a program has written them: of each, in 32 bytes, the number of its source, and its own (int32), when it was
# expected, when it came, and how long it took, -1 if it has not ended (int64). The names are the sources'.
Records = tuple[bytes, Sequence[str]]

_RECORD = 32  # bytes


class Ticking(Protocol):
    """A timer whose calls are recorded."""

    _rosspin_source: str

    def _rosspin_coming(self) -> list[tuple[str, int, int, int]]:
        """List the next calls, undelayed by anything new, up to one on time: source, number, expected, real (ns)."""


class Looping(Protocol):
    """A Rate whose passes are recorded."""

    def _rosspin_coming(self, trails: Mapping[int, Trail]) -> list[tuple[str, int, int, int]]:
        """List the pass that continues and the next ones, in the same form; none if the loop has ended.

        ``trails`` are where threads are, by their idents.
        """


class TickLog:
    """The ticks of a run, in the order in which they were recorded. Times are in ns; a tick is known by its place.

    All fields of all ticks are in one list. An object for each tick would cost more than the tick: memory that is no
    longer in the processor's cache when it is needed again, and that the garbage collector goes through. For the same
    reason, what a program has written is put there only when someone asks for it.
    """

    watcher: Watcher | None = None  # if the run should be gone through step by step

    def __init__(self) -> None:
        self._fields: list[Any] = []  # source, number, expected, real, duration, source, number, ...
        self._records: list[Records] = []  # the ticks after those, and how many these are
        self._packed = 0
        self.timers: WeakSet[Ticking] = WeakSet()  # those that may continue when the run ends
        self.rates: WeakSet[Looping] = WeakSet()
        self.periods: dict[str, int] = {}  # ns, of each source; 0: its grid was moved
        self.coming: list[tuple[str, int, int, int]] = []  # source, number, expected, real: see results.ticks.Run
        self.is_over = False  # then C++ nodes add what comes next of theirs
        self._ended = 0  # how many ticks there were then

    def look_ahead(self, find_trails: Callable[[], Mapping[int, Trail]]) -> None:
        """Note which calls of timers and passes of loops would come next. For the trails see :class:`Looping`."""
        self.is_over, self._ended = True, len(self)
        timers = sorted(self.timers, key=lambda each: each._rosspin_source)
        self.coming = [call for timer in timers for call in timer._rosspin_coming()]
        if self.rates:
            trails = find_trails()
            self.coming += sorted(call for rate in self.rates for call in rate._rosspin_coming(trails))

    def __len__(self) -> int:
        return len(self._fields) // _FIELDS + self._packed

    def add(self, source: str, number: int, expected: int, real: int, duration: int | None = None) -> int:
        """Record a tick (ns) and return its place. If it has no duration yet, ``end`` gives it one."""
        if self._records:
            self._unpack()
        fields = self._fields
        at = len(fields)
        fields += (source, number, expected, real, duration)  # in one go, whatever other threads and signals do
        if len(fields) != at + _FIELDS:  # they came in between
            at = len(fields) - _FIELDS
            while fields[at + 1] != number or fields[at] != source:
                at -= _FIELDS
        return at // _FIELDS

    def extend(self, data: bytes, names: Sequence[str]) -> int:
        """Record the ticks that a program has written, and return the place of the first: see :data:`Records`."""
        place = len(self)
        self._records.append((data, names))
        self._packed += len(data) // _RECORD
        return place

    def _unpack(self) -> None:
        records, self._records, self._packed = self._records, [], 0
        for each in records:
            columns = unpacked(each)
            fields: list[Any] = [None] * (_FIELDS * len(columns[0]))
            for field, column in enumerate(columns):
                fields[field::_FIELDS] = column
            self._fields += fields

    def end(self, place: int, duration: int) -> None:
        """Record how long a tick took, in ns, now that it has ended."""
        if self._records:
            self._unpack()
        self._fields[place * _FIELDS + 4] = duration

    def source(self, place: int) -> str:
        """Return what has ticked."""
        self._unpack()
        found: str = self._fields[place * _FIELDS]
        return found

    def is_running(self, place: int) -> bool:
        """Whether a tick has not ended."""
        self._unpack()
        return self._fields[place * _FIELDS + 4] is None

    def columns(self, since: int = 0, until: int | None = None) -> tuple[list[Any], ...]:
        """Sources, numbers, when expected, when real, durations (None while it runs), from the tick ``since`` on."""
        self._unpack()
        end = until if until is None else until * _FIELDS
        return tuple(self._fields[since * _FIELDS + field : end : _FIELDS] for field in range(_FIELDS))

    def last_numbers(self) -> dict[str, int]:
        """Return the number of the last tick of each source that has ticked since the run was over."""
        since = self._ended * _FIELDS
        last = dict(zip(self._fields[since::_FIELDS], self._fields[since + 1 :: _FIELDS]))
        left = len(self) - self._ended
        for data, names in reversed(self._records):
            if left <= 0:
                break
            sources, numbers, *_ = unpacked((data, names))
            last = {**dict(zip(sources, numbers)), **last}
            left -= len(sources)
        return last


def unpacked(records: Records) -> tuple[list[Any], ...]:
    """Return the same as ``columns`` of ticks that a program has written."""
    data, names = records
    halves, wholes = memoryview(data).cast("i"), memoryview(data).cast("q")
    durations: list[int | None] = [*wholes[3::4].tolist()]
    if -1 in durations:
        durations = [None if each == -1 else each for each in durations]
    sources = [names[number] for number in halves[0::8].tolist()]
    return sources, halves[1::8].tolist(), wholes[1::4].tolist(), wholes[2::4].tolist(), durations


class _Endpoints(Generic[E]):
    """Publications, or subscriptions, by topic; in the order in which they were made."""

    def __init__(self) -> None:
        self._of: dict[str, list[E]] = {}

    def add(self, endpoint: E) -> None:
        self._of.setdefault(endpoint.topic, []).append(endpoint)

    def remove(self, endpoint: E) -> None:
        with suppress(ValueError):
            self._of.get(endpoint.topic, []).remove(endpoint)

    def of(self, topic: str) -> list[E]:
        return list(self._of.get(topic, ()))

    def all(self) -> list[E]:
        return list(chain.from_iterable(self._of.values()))

    def types(self) -> list[tuple[str, str]]:
        return [(topic, endpoints[0].type) for topic, endpoints in self._of.items() if endpoints]

    def names(self) -> list[str]:
        return list(self._of)


class CallMade:
    """A call of a service while it is recorded. ``make_request()`` makes the request when someone asks for it."""

    def __init__(self, service: str, client: str, asked: int, make_request: Callable[[], Any]) -> None:
        self._asked = service, client, asked, make_request
        self._answered: tuple[str, int, Callable[[], Any]] | None = None

    def answer(self, server: str, when: int, make_response: Callable[[], Any]) -> None:
        """Record that the node ``server`` answers at ``when`` (ns). Of several answers the first counts."""
        self._answered = self._answered or (server, when, make_response)

    def since(self, start: int) -> Call:
        """Return the call, in seconds since ``start`` (ns)."""
        service, client, asked, request = self._asked
        asked_at = (asked - start) / NS
        if self._answered is None:
            return Call(service, client, asked_at, request(), "", math.nan, None)
        server, answered, response = self._answered
        return Call(service, client, asked_at, request(), server, (answered - start) / NS, response())


class RecordedEndpoint:
    """An endpoint of a topic as it is recorded: made at ``made`` (s), with a ``qos`` in ROS 2.

    ``joined`` is with how many other endpoints it was connected, ``refused`` how many did not match it.
    """

    def __init__(self, topic: str, publishes: bool, made: float, qos: Any) -> None:
        self.topic = topic
        self.publishes = publishes
        self.made = made
        self.qos = qos
        self.joined = 0
        self.refused = 0


@contextmanager
def _no_collections() -> Iterator[None]:
    """Within this context the garbage collector is off: it would go through a growing result again and again.

    Around a whole function, it stays off until the function's own lists are gone, too.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


class Recording:
    """The ticks, messages and calls of a run that began at ``start`` (ns). If ``log`` is None, nothing is recorded.

    ``several`` says whether there is more than one process.
    """

    def __init__(self, clock: Clock, log: TickLog | None, several: bool = False, start: int = 0) -> None:
        self.several = several
        self.log = log
        self.watcher = None if log is None else log.watcher
        self.published: list[Published] | None = None if log is None else []
        self.start = start
        self.endpoints: list[RecordedEndpoint] = []  # of topics, in the order in which they were made
        self._clock = clock
        self._calls: list[CallMade] = []
        self._fault_events: list[tuple[int, str, str, int, Published | None]] = []

    def add_message(self, topic: str, node: str, make: Callable[[], Any]) -> None:
        """Record that ``node`` publishes, now, the message that ``make()`` returns."""
        if self.published is not None:
            self.published.append((topic, node, self._clock.now(), make))

    def add_endpoint(self, topic: str, publishes: bool, qos: Any = None) -> RecordedEndpoint:
        """Record that an endpoint of a topic is made, now. Return it: whom it meets is noted there."""
        endpoint = RecordedEndpoint(topic, publishes, (self._clock.now() - self.start) / NS, qos)
        if self.log is not None:
            self.endpoints.append(endpoint)
        return endpoint

    def coming(self) -> tuple[Tick, ...]:
        """Return the calls of timers and the passes of loops that would have come next."""
        if not self.log or not self.log.coming:
            return ()
        start = self.start
        last = self.log.last_numbers()  # some come even after Ctrl-C
        return tuple(
            Tick(name, number, (due - start) / NS, (real - start) / NS, math.nan)
            for name, number, due, real in self.log.coming
            if number > last.get(name, 0)
        )

    def periods(self) -> dict[str, float]:
        """Return the period (s) of each timer and each Rate that has kept to one grid, by its source."""
        return {name: period / NS for name, period in self.log.periods.items() if period > 0} if self.log else {}

    def ticks(self, since: int = 0) -> tuple[Tick, ...]:
        """Return the recorded ticks, from the tick ``since`` on."""
        return self.ticks_later(since)()

    def ticks_later(self, since: int = 0) -> Callable[[], tuple[Tick, ...]]:
        """Return a function that makes what ``ticks`` returns, as it is now if it is called when the run is over."""
        return tuple if self.log is None else partial(_ticks, self.log, self.start, since, len(self.log))

    @_no_collections()
    def messages(self, since: int = 0) -> tuple[Message, ...]:
        """Return the recorded messages, from the message ``since`` on."""
        published = self.published or ()
        return tuple(map(self._message, published[since:]))

    def _message(self, published: Published) -> Message:
        topic, node, time, make = published
        return tuple.__new__(Message, (topic, node, (time - self.start) / NS, make()))  # as quick as in ``ticks``

    def add_fault_event(self, what: str, which: str, by: int = 0, message: Published | None = None) -> None:
        """Record what a fault does, now; ``by`` is in ns."""
        self._fault_events.append((self._clock.now(), what, which, by, message))

    @property
    def fault_event_count(self) -> int:
        """How many fault events are recorded."""
        return len(self._fault_events)

    def fault_events(self, since: int = 0) -> tuple[FaultEvent, ...]:
        """Return what faults did, from the event ``since`` on."""
        return tuple(
            FaultEvent((time - self.start) / NS, what, which, by / NS, message and self._message(message))
            for time, what, which, by, message in self._fault_events[since:]
        )

    def add_call(self, service: str, client: str, make_request: Callable[[], Any]) -> CallMade:
        """Record that the node ``client`` asks a service, now. Return the call, to which the answer is added."""
        call = CallMade(service, client, self._clock.now(), make_request)
        if self.log is not None:
            self._calls.append(call)
        return call

    def calls(self, since: int = 0) -> tuple[Call, ...]:
        """Return the recorded calls, from the call ``since`` on."""
        return tuple(call.since(self.start) for call in self._calls[since:])

    def __len__(self) -> int:
        return len(self._calls)


@_no_collections()
def _ticks(log: TickLog, start: int, since: int, until: int) -> tuple[Tick, ...]:
    sources, numbers, expected, real, durations = log.columns(since, until)
    fields = zip(
        sources,
        numbers,
        [(time - start) / NS for time in expected],
        [(time - start) / NS for time in real],
        [math.nan if duration is None else duration / NS for duration in durations],
    )
    # A run may have a million ticks: from its fields, a Tick takes twice as long.
    return tuple(map(tuple.__new__, repeat(Tick), fields))


class Graph:
    """The topics that the nodes of one ROS share in a run."""

    def __init__(self) -> None:
        self.tester: Counterpart | None = None
        self.faults: Faults | None = None
        self._parts: dict[type, Any] = {}
        self._lock = threading.Lock()
        self._publications: _Endpoints[Any] = _Endpoints()
        self._subscriptions: _Endpoints[Any] = _Endpoints()

    def part(self, kind: type[Part]) -> Part:
        """Return what one ROS keeps for all its nodes of this run: ``kind()``, made when it is first asked for."""
        if kind not in self._parts:
            self._parts[kind] = kind()
        return self._parts[kind]  # type: ignore[no-any-return]

    def advertise(self, publication: Endpoint) -> list[Any]:
        """Add a publication. Returns the subscriptions that are there already."""
        found = self._add(publication, self._publications, self._subscriptions)
        return [*found, self.tester.subscription(publication)] if self.tester else found

    def subscribe(self, subscription: Endpoint) -> list[Any]:
        """Add a subscription. Returns the publications that are there already."""
        found = self._add(subscription, self._subscriptions, self._publications)
        return [*found, self.tester.publication(subscription)] if self.tester else found

    def _add(self, endpoint: Endpoint, same: _Endpoints[Any], other: _Endpoints[Any]) -> list[Any]:
        # In one go: of two endpoints that are made at the same time, exactly one finds the other.
        with self._lock:
            same.add(endpoint)
            return other.of(endpoint.topic)

    def remove(self, endpoint: Endpoint) -> None:
        """Take an endpoint away; one that is not there is no error."""
        # Without the lock: the collector may call this while it is taken. Each removal is in one go.
        self._publications.remove(endpoint)
        self._subscriptions.remove(endpoint)

    def topics(self) -> list[tuple[str, str]]:
        """Return the topics that someone publishes, and their types."""
        with self._lock:
            return self._publications.types()

    def endpoints(self) -> tuple[list[Any], list[Any]]:
        """Return all publications and all subscriptions, topic by topic."""
        with self._lock:
            return self._publications.all(), self._subscriptions.all()

    def names(self) -> list[str]:
        """Return the topics that someone has, or has had."""
        with self._lock:
            return list(dict.fromkeys(self._publications.names() + self._subscriptions.names()))

    def subscribed(self) -> list[tuple[str, str]]:
        """Return the topics to which someone subscribes, and their types."""
        with self._lock:
            return self._subscriptions.types()
