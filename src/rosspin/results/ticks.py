"""The result of a run: its console, its ticks, messages, calls and status. Pure data, below all else."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

__all__ = ["Call", "Message", "FaultEvent", "Run", "Tick", "with_ticks"]


class Tick(NamedTuple):
    """One call of a timer's callback, or one pass of a loop. Times are in seconds since the run began.

    ``source`` names the timer or the loop, ``number`` counts from 1, ``expected`` is when the tick should have begun,
    ``real`` is when it did, and ``duration`` is how long it took (NaN if it had not ended when the run did).
    """

    source: str
    number: int
    expected: float
    real: float
    duration: float

    @property
    def lateness(self) -> float:
        """real - expected, in seconds."""
        return self.real - self.expected


class Message(NamedTuple):
    """One message as it was published: the full name of the ``topic`` and of the ``node``, when, and a copy of it.

    ``time`` is in seconds since the run began. Whether anyone received it is another question.
    """

    topic: str
    node: str
    time: float
    message: Any


class Call(NamedTuple):
    """One call of a service: its full name, and the names of the nodes that ask and answer.

    ``asked`` and ``answered`` are in seconds since the run began; ``request`` and ``response`` are copies. If no answer
    was sent, ``answered`` is NaN, ``server`` empty and ``response`` None. After an error only ``response`` is None.
    """

    service: str
    client: str
    asked: float
    request: Any
    server: str
    answered: float
    response: Any


class FaultEvent(NamedTuple):
    """What a fault of ``faults=`` did: when (s since the run began), what, to which connection, node or callback.

    ``what`` is "dropped", "delayed" or "overtaken" (by a later message, and so thrown away) of a ``message``; "killed"
    or "late" of a node, "slowed" of a callback, and "set" of the clock. ``by`` is the delay, the lateness, or how far
    the clock was set, in s; 0 where there is none.
    """

    time: float
    what: str
    which: str
    by: float = 0.0
    message: Message | None = None


@dataclass(frozen=True)
class Run:
    """What a node did in one run.

    ``console`` is what it printed to stdout and stderr, in order; ``ticks`` are in the order in which they began;
    ``status`` is its exit status; ``runtime`` says where it ran ("simulated", "wall", "ros1", "ros2"); ``seconds`` is
    the time after which Ctrl-C was pressed; ``start`` is when the run began, in seconds since the epoch (0.0 if
    simulated); ``messages`` are what its topics were given, in the order of publishing, and ``calls`` what its services
    were asked, in the order of asking (none of both if it ran on a real ROS); ``faults`` are what ``faults=`` did.

    ``coming`` are calls that the timers of a simulated run would have made next, had nothing more delayed them: of each
    timer that continued, the one that was overdue at the end, if one was, and those after it, until one is on time. Of
    a loop that still continued, they are the pass that had not ended, and the next ones, had it ended then. What was
    due in between is lost.
    """

    console: str = field(repr=False)
    ticks: Sequence[Tick] = field(repr=False)
    status: int
    runtime: str
    seconds: float
    start: float = 0.0
    messages: Sequence[Message] = field(default=(), repr=False)
    calls: Sequence[Call] = field(default=(), repr=False)
    faults: Sequence[FaultEvent] = field(default=(), repr=False)
    coming: Sequence[Tick] = field(default=(), repr=False)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Make the ticks, when they are asked for first."""
            own = vars(self)
            if name == "ticks" and (make := own.get("_make_ticks")):
                own.setdefault(name, make())  # another thread may ask for them, too
                own.pop("_make_ticks", None)
            if name in own:
                return own[name]
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}", name=name, obj=self)

    def __getstate__(self) -> dict[str, Any]:
        """Return what is pickled, or copied."""
        self.ticks  # noqa: B018 - they are made
        return vars(self)


def with_ticks(run: Run, make: Callable[[], Sequence[Tick]]) -> Run:
    """Return a run with ticks that ``make()`` makes when someone asks for them: it may have a million."""
    own = vars(run)
    del own["ticks"]
    own["_make_ticks"] = make
    return run
