"""What a run of an answer shows, as plain data: it is written down in one Python and judged in another."""

from __future__ import annotations

import re
import signal
from collections.abc import Collection
from typing import NamedTuple

from ..vehicle.drives import Drive

__all__ = ["Called", "Error", "Kept", "ObservedEndpoint", "ObservedRun", "ObservedTimer", "Printed", "Sent", "Value"]


class Printed(NamedTuple):
    """A printed line: when (s), its text, and the number of the timer whose call printed it, or 0.

    If the callback of a subscription printed it, ``heard`` is the field ``data`` of the message that it was given.
    """

    time: float
    text: str
    timer: int = 0
    heard: str = ""


class ObservedTimer(NamedTuple):
    """A timer: its number, when it was called (s), its ``state`` when Ctrl-C came, its period (s), in ROS 2 its node.

    The state is "running"; "stopped", as by ``shutdown()`` or ``cancel()``, or after the call of a one-shot timer;
    "blocked" in a call that began more than a second before; "gone" if its thread had ended in some other way.
    """

    number: int
    calls: tuple[float, ...]
    state: str
    period: float
    node: str

    @property
    def is_endless(self) -> bool:
        """Whether it is called without a pause: rclpy makes such a call every 100 us."""
        return self.period < 1e-5 and self.state == "running" and len(self.calls) > 1


class ObservedEndpoint(NamedTuple):
    """A publisher or a subscription: its topic, whether it ``publishes``, when it was made (s), and its QoS in words.

    ``joined`` is with how many other endpoints it was connected, ``refused`` how many did not match it. In ROS 1 there
    is no QoS, and what has the same topic in a node is one endpoint.
    """

    topic: str
    publishes: bool
    made: float
    qos: str
    joined: int
    refused: int


class Error(NamedTuple):
    """An exception whose traceback was printed.

    ``said`` is the traceback's last line, ``line`` the line of the answer that raised it, or 0. ``whose`` is what it
    ended: "node", "thread", "timer" or "shutdown hook". ``ending`` says whether Ctrl-C may end a node of this ROS with
    it. ``hint`` says how to continue; it is empty if nothing is known.
    """

    type: str
    said: str
    line: int
    whose: str
    ending: bool
    hint: str


class Sent(NamedTuple):
    """A published message: its topic, when (s), its type, and its field ``data`` as a text."""

    topic: str
    time: float
    type: str
    data: str


class Called(NamedTuple):
    """A call of a service: the service's full name, when it was asked (s), and when it answered, or None."""

    service: str
    asked: float
    answered: float | None


class Kept(NamedTuple):
    """Where a node was when it had to be killed: the line of the answer, and the call there that had not returned."""

    line: int
    call: str


class Value(NamedTuple):
    """A variable's last value: its type, with a ``text`` for a text or a number, and ``numbers`` for a list."""

    type: str
    text: str = ""
    numbers: tuple[float, ...] | None = None

    @property
    def is_open(self) -> bool:
        """Whether the answer is still open: ``...`` or None."""
        return self.type in ("ellipsis", "NoneType")


class ObservedRun(NamedTuple):
    """What an answer did in one run of ``seconds``.

    ``printed`` are the lines that it printed, even after Ctrl-C; ``timers`` are those that it had started by then.
    ``loops`` are the lines of the answer in which something other than a timer's callback slept again and again,
    ``naps`` those in which such callbacks did, ``aside`` the lines in which another thread than the first slept so.
    ``endpoints`` are its publishers and subscriptions, ``parameters`` those that it had declared in ROS 2, or asked for
    in ROS 1, ``sent`` the messages that it published, ``calls`` the requests to its services. ``status`` is its exit
    status, ``errors`` are the exceptions whose tracebacks were printed, and ``interrupted`` says whether it ran until
    Ctrl-C. If it had to be killed, ``kept_at`` is where it was, and ``kept_by_rate`` says that it waited for a Rate of
    ROS 2 and nothing else. ``variables`` are the names and values of those requested variables that it has. If a
    vehicle ran with it, ``drive`` is what that did. ``language`` is the answer's, as Pygments has it.
    """

    seconds: float
    printed: tuple[Printed, ...]
    timers: tuple[ObservedTimer, ...]
    loops: tuple[int, ...]
    naps: tuple[int, ...]
    endpoints: tuple[ObservedEndpoint, ...]
    parameters: tuple[str, ...]
    sent: tuple[Sent, ...]
    calls: tuple[Called, ...]
    status: int
    errors: tuple[Error, ...]
    interrupted: bool
    kept_at: Kept | None
    kept_by_rate: bool
    variables: tuple[tuple[str, Value], ...]
    drive: Drive = Drive((), ())
    language: str = "python"
    aside: tuple[int, ...] = ()

    @property
    def killed(self) -> bool:
        """Whether Ctrl-C did not end it."""
        return self.status == 128 + signal.SIGKILL

    def values(self, tag: str, name: str) -> list[Printed]:
        """Return the lines ``[tag] name = value``, however they were printed, each with its value as the text."""
        sign = re.compile(rf"(?:^|: )\[{tag}\]\s+{name}\s*=\s*(.*)")
        found = [(line, sign.search(line.text)) for line in self.printed]
        return [line._replace(text=match[1].strip()) for line, match in found if match]

    @property
    def tag(self) -> str:
        """What the spinner nodes print before their counter."""
        return "SPINNER CPP NODE" if self.language == "cpp" else "SPINNER PY NODE"

    def counters(self, tag: str = "") -> list[Printed]:
        """Return the lines ``[tag] counter = 1`` and so on, up to Ctrl-C. The tag is the spinner nodes'."""
        return [line for line in self.values(tag or self.tag, "counter") if line.time <= self.seconds]

    def endpoints_of(self, topic: str, publishes: bool) -> list[ObservedEndpoint]:
        """Return its publishers, or its subscriptions, of a topic."""
        return [endpoint for endpoint in self.endpoints if (endpoint.topic, endpoint.publishes) == (topic, publishes)]

    def printers(self, lines: Collection[Printed]) -> tuple[list[ObservedTimer], list[Printed]]:
        """Return the timers whose calls printed these lines, and the lines that no timer printed."""
        known, found = {timer.number for timer in self.timers}, {line.timer for line in lines}
        return [timer for timer in self.timers if timer.number in found], [
            line for line in lines if line.timer not in known
        ]
