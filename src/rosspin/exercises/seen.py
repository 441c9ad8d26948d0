"""What a run of an answer shows: plain data, which can be written down in one Python and judged in another."""

from __future__ import annotations

import re
import signal
from collections.abc import Collection
from typing import NamedTuple

__all__ = ["Error", "Kept", "Printed", "Seen", "SeenTimer", "Sent", "Value"]


class Printed(NamedTuple):
    """A line that was printed: when (s), its text, and the number of the timer in whose call; 0 if it was in none."""

    time: float
    text: str
    timer: int = 0


class SeenTimer(NamedTuple):
    """What a timer did: its number, when it was called (s), and how it was when Ctrl-C came.

    ``state`` is "running"; "stopped", as by ``shutdown()`` or ``cancel()``, or after the call of a one-shot timer;
    "blocked" if a call had not ended for a second; "gone" if its thread had ended in some other way.
    """

    number: int
    calls: tuple[float, ...]
    state: str


class Error(NamedTuple):
    """An exception whose traceback was printed.

    ``said`` is its last line, and ``line`` the answer's that it came from, or 0. ``whose`` is what it ended: "node",
    "thread", "timer", "shutdown hook". ``ending`` says whether Ctrl-C may end a node of this ROS so; ``hint`` is how to
    go on, empty if nothing is known.
    """

    type: str
    said: str
    line: int
    whose: str
    ending: bool
    hint: str


class Sent(NamedTuple):
    """A message that was published: on which topic, when (s), its type, and its field ``data`` as a text."""

    topic: str
    time: float
    type: str
    data: str


class Kept(NamedTuple):
    """Where a node was when it had to be killed: the line of the answer, and the call there that had not returned."""

    line: int
    call: str


class Value(NamedTuple):
    """What a variable was in the end: its type; a text, or one number, as a ``text``; ``numbers``, if it is a list."""

    type: str
    text: str = ""
    numbers: tuple[float, ...] | None = None

    @property
    def is_open(self) -> bool:
        """Whether nothing was answered yet: ``...`` or None."""
        return self.type in ("ellipsis", "NoneType")


class Seen(NamedTuple):
    """What an answer did in one run of ``seconds``.

    ``printed`` are the lines that it printed, also after Ctrl-C; ``timers`` are those that it had started by then;
    ``loops`` are the lines of the answer in which something other than a timer's callback slept again and again;
    ``sent`` is what it published. ``status`` is its exit status, ``errors`` are the exceptions whose tracebacks were
    printed, and ``interrupted`` says whether it ran until Ctrl-C. If it had to be killed, ``kept_at`` is where it was
    then, and ``kept_by_rate`` says that all it waited for was a Rate of ROS 2. ``variables`` are the variables that
    were asked for and that it has, with their names.
    """

    seconds: float
    printed: tuple[Printed, ...]
    timers: tuple[SeenTimer, ...]
    loops: tuple[int, ...]
    sent: tuple[Sent, ...]
    status: int
    errors: tuple[Error, ...]
    interrupted: bool
    kept_at: Kept | None
    kept_by_rate: bool
    variables: tuple[tuple[str, Value], ...]

    @property
    def killed(self) -> bool:
        """Whether Ctrl-C did not end it."""
        return self.status == 128 + signal.SIGKILL

    def values(self, tag: str, name: str) -> list[Printed]:
        """The lines ``[tag] name = value``, however they were printed, each with its value as the text."""
        sign = re.compile(rf"(?:^|: )\[{tag}\] {name} = (.*)")
        found = [(line, sign.search(line.text)) for line in self.printed]
        return [line._replace(text=match[1].strip()) for line, match in found if match]

    def counters(self, tag: str = "SPINNER PY NODE") -> list[Printed]:
        """The lines ``[tag] counter = 1`` and so on, up to Ctrl-C."""
        return [line for line in self.values(tag, "counter") if line.time <= self.seconds]

    def printers(self, lines: Collection[Printed]) -> tuple[list[SeenTimer], list[Printed]]:
        """The timers in whose calls lines were printed, and the lines that none of them printed."""
        known, found = {timer.number for timer in self.timers}, {line.timer for line in lines}
        return [timer for timer in self.timers if timer.number in found], [
            line for line in lines if line.timer not in known
        ]
