"""What can go wrong in a simulated run, on purpose: ``faults=[Topic("/scan", drop=0.1), Crash("/camera", at=2.0)]``.

A fault obeys the transport. What the real one cannot do is a ValueError, which says why and what to use instead. Names
are full ones; times and lengths of time are in seconds, and times count from the beginning of the run. Two runs with
the same faults go wrong in the same way; another ``seed`` draws other numbers. Each connection draws its own, so that
one more fault, or one more node, changes none of the others' draws.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from dataclasses import MISSING, dataclass, fields

__all__ = ["ClockJump", "Crash", "Fault", "Jitter", "Late", "Service", "Slow", "Topic", "checked", "read"]


# Names of what is no node.
_EXAMPLES = {"service": "reset", "topic": "scan"}


class Fault:
    """Base of the faults. Two that say the same are equal."""

    def __repr__(self) -> str:
        """As it is written, without what is left at its default."""
        words = []
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            if field.default is MISSING:
                words.append(repr(value) if field.name in ("topic", "service", "node") else f"{field.name}={value!r}")
            elif value != field.default:
                words.append(f"{field.name}={value!r}")
        return f"{type(self).__name__}({', '.join(words)})"

    def _refuse(self, reason: str) -> None:
        raise ValueError(f"{self!r}: {reason}")

    def _is_time(self, name: str, least: float = 0.0) -> None:
        value = getattr(self, name)
        if not (_is_number(value) and value >= least):
            self._refuse(f"{name} must be a number of at least {least:g}, in s")

    def _is_length(self, name: str = "by") -> None:
        value = getattr(self, name)
        if not (_is_number(value) and value > 0):
            self._refuse(f"{name} must be a number above 0, in s")

    def _is_chance(self, name: str) -> None:
        value = getattr(self, name)
        if not (_is_number(value) and 0 <= value <= 1):
            self._refuse(f"{name} is how likely a message is lost, from 0 to 1")

    def _is_span(self, name: str) -> tuple[float, float]:
        """Return the least and the most delay (s), and keep a list as a tuple, so that the fault has a hash."""
        value = getattr(self, name)
        pair = tuple(value) if isinstance(value, (tuple, list)) else (value, value)
        if not (len(pair) == 2 and all(map(_is_number, pair)) and 0 <= pair[0] <= pair[1]):
            self._refuse(f"{name} is a number of at least 0, in s, or the least and the most: (0.0, 0.05)")
        if isinstance(value, list):
            object.__setattr__(self, name, pair)
        return pair

    def _has_name(self, name: str) -> None:
        value = getattr(self, name)
        if not (isinstance(value, str) and value.strip("/")):
            self._refuse(f"{name} must be a name, such as '/{_EXAMPLES.get(name, 'robot')}'")
        object.__setattr__(self, name, value if value.startswith("/") else f"/{value}")


@dataclass(frozen=True, repr=False)
class Topic(Fault):
    """Messages of a topic come late, or never, on their way from one process to another.

    ``drop`` is how likely it is, from 0 to 1, that a message is lost. Only best effort loses messages: a connection of
    ROS 2 that is reliable on both sides, and every one of ROS 1, which is TCP, is a ValueError. ``delay`` is how long a
    message takes, or the least and the most, between which it is drawn; every transport delays. Messages keep their
    order, unless ``reorder``: then one may overtake another, and a best-effort reader throws away the one that comes
    too late (RTPS 8.4.12.1; Fast DDS, StatelessReader::change_received). For that, too, a connection must be best
    effort, and the ``delay`` must vary. ``to`` is the node whose connections are meant; without it, all are.

    ``duplicate`` is a ValueError: no transport of ROS hands a message over twice.

    What a process sends to itself does not leave it in ROS 2, and is left alone; in ROS 1 it goes over TCP, too. What a
    test publishes comes from another process, and what a node publishes reaches the test immediately.
    """

    topic: str
    drop: float = 0.0
    delay: float | tuple[float, float] = 0.0
    reorder: bool = False
    duplicate: float = 0.0
    to: str = ""
    seed: int = 0

    def __post_init__(self) -> None:
        self._has_name("topic")
        if self.to:
            self._has_name("to")
        self._is_chance("drop")
        pair = self._is_span("delay")
        if self.duplicate:
            self._refuse(
                "no transport of ROS hands a message over twice: TCP and the readers of DDS throw away what they have "
                "had. A topic carries a message twice if two nodes publish it: start its publisher twice"
            )
        if self.reorder and pair[0] == pair[1]:
            self._refuse("messages overtake each other only if some take longer: add delay=(0.0, 0.05)")
        if not (self.drop or pair[1]):
            self._refuse("this does nothing: say drop=0.1, or delay=0.05")


@dataclass(frozen=True, repr=False)
class Service(Fault):
    """Requests to a service, or its responses, come late, or never, on their way from one process to another.

    ``request_delay`` and ``response_delay`` are how long they take, or the least and the most, between which that is
    drawn; they keep their order. ``request_drop`` and ``response_drop`` are how likely they are lost, from 0 to 1. As
    of a :class:`Topic`, only best effort loses messages, and services are reliable unless a profile says otherwise on
    either side; a service whose process dies never answers, either: :class:`Crash`.
    ``client`` is the node whose calls are meant; without it, all are.

    An action of ROS 2 has services, too: ``/fibonacci/_action/send_goal``. A response reaches a test immediately.
    """

    service: str
    request_delay: float | tuple[float, float] = 0.0
    response_delay: float | tuple[float, float] = 0.0
    request_drop: float = 0.0
    response_drop: float = 0.0
    client: str = ""
    seed: int = 0

    def __post_init__(self) -> None:
        self._has_name("service")
        if self.client:
            self._has_name("client")
        spans = [self._is_span("request_delay"), self._is_span("response_delay")]
        self._is_chance("request_drop")
        self._is_chance("response_drop")
        if not (self.request_drop or self.response_drop or any(most for _, most in spans)):
            self._refuse("this does nothing: say request_delay=0.5, or response_delay=0.5")


@dataclass(frozen=True, repr=False)
class Crash(Fault):
    """The process of a node is killed with SIGKILL, after all that is due ``at`` that time.

    The others notice it as late as on a real ROS: in ROS 1 its connections break immediately; in ROS 2 no one is told,
    and its process is missed 20 s later. What restarts nodes that die, as ``respawn`` does, restarts this one.
    """

    node: str
    at: float

    def __post_init__(self) -> None:
        self._has_name("node")
        self._is_time("at")


@dataclass(frozen=True, repr=False)
class Late(Fault):
    """Each connection between a node and the nodes of other processes is made ``by`` so much later than it would be.

    What is published before is lost, or kept, as by any subscriber that comes late.
    """

    node: str
    by: float

    def __post_init__(self) -> None:
        self._has_name("node")
        self._is_length()


@dataclass(frozen=True, repr=False)
class ClockJump(Fault):
    """The clock of the computer is set, ``by`` so much forward or, if negative, back.

    So ``time.time()``, ``rospy.Time.now()`` and, in ROS 2, system time and ROS time jump, unless /clock tells the time.
    Steady clocks do not, and nor do the times in a run. Who sleeps sleeps on; a timer of rclpy on ROS time waits for
    its time to come again.
    """

    at: float
    by: float

    def __post_init__(self) -> None:
        self._is_time("at")
        if not (_is_number(self.by) and self.by):
            self._refuse("by is how far the clock is set, in s: 1.0, or -1.0 for back")


@dataclass(frozen=True, repr=False)
class Slow(Fault):
    """Each call of a node's callback takes longer ``by`` so much, as on a machine that has too much to do.

    The time passes before the callback's first line. ``callback`` is the name of the function of a subscription, a
    timer, a service or an event: ``on_scan``, or ``Robot.on_scan``.
    """

    node: str
    callback: str
    by: float

    def __post_init__(self) -> None:
        self._has_name("node")
        if not (isinstance(self.callback, str) and self.callback):
            self._refuse("callback is the name of a function, such as 'on_scan'")
        self._is_length()


@dataclass(frozen=True, repr=False)
class Jitter(Fault):
    """Threads that sleep, or wait with a limit, are late by up to ``by``, and callbacks begin late.

    Each time it is another number. Without it, two timers that fall due at one instant tick at that instant, which no
    robot sees.
    """

    by: float
    seed: int = 0

    def __post_init__(self) -> None:
        self._is_length()


KINDS: dict[str, type[Fault]] = {kind.__name__: kind for kind in (Topic, Crash, Late, ClockJump, Slow, Jitter, Service)}


def checked(faults: Iterable[Fault]) -> tuple[Fault, ...]:
    """Return the faults that were given. Raises TypeError for what is not a list of faults."""
    given = () if isinstance(faults, (str, Fault)) or not isinstance(faults, Iterable) else tuple(faults)
    if (not given and not isinstance(faults, (list, tuple))) or not all(isinstance(each, Fault) for each in given):
        raise TypeError(f"faults is a list of {', '.join(KINDS)} from rosspin.faults, not {faults!r}")
    return given


def read(text: str) -> Fault:
    """Make the fault that is written in ``text``, such as ``Topic("/scan", drop=0.1)``; nothing in it is run.

    Raises ValueError if it is none.
    """
    try:
        call = ast.parse(text.strip(), mode="eval").body
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name):
            raise ValueError
        args = [ast.literal_eval(each) for each in call.args]
        named = {each.arg or "**": ast.literal_eval(each.value) for each in call.keywords}
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        raise ValueError(f'{text}: a fault is written as in Python, as in Topic("/scan", drop=0.1)') from None
    if len(named) < len(call.keywords):
        raise ValueError(f"{text}: an argument is given twice")
    if call.func.id not in KINDS:
        raise ValueError(f"{text}: there is no fault {call.func.id}; there are {', '.join(KINDS)}")
    try:
        return KINDS[call.func.id](*args, **named)
    except TypeError as error:
        reason = str(error).replace(f"{call.func.id}.__init__() ", "")
        raise ValueError(f"{text}: {reason}") from None


# A run of 30 years (s); its nanoseconds are a number of 64 bits.
_MOST = 1e9


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= _MOST
