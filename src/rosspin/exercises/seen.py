"""What a run of an answer shows, and what has to be known of a ROS to see it."""

from __future__ import annotations

import re
import signal
from collections.abc import Collection, Sequence
from types import CodeType, FrameType
from typing import Any, NamedTuple, Protocol

from ..frames import Place
from ..ticks import Message, Tick
from ..world import World

__all__ = ["Printed", "Ros", "Seen", "SeenTimer"]


class Printed(NamedTuple):
    """A line that was printed: when (s), its text, and the timer in whose call, if it was in one."""

    time: float
    text: str
    timer: Any = None


class SeenTimer(NamedTuple):
    """What a timer did: the timer itself, its calls, and how it was when Ctrl-C came.

    ``state`` is "running"; "stopped", as by ``shutdown()`` or ``cancel()``, or after the call of a one-shot timer;
    "blocked" if a call had not ended for a second; "gone" if its thread had ended in some other way.
    """

    timer: Any
    calls: tuple[Tick, ...]
    state: str


class Ros(Protocol):
    """What there is to know of a ROS.

    ``NAME`` is its module in Python; ``GOES_ON`` is what a loop asks, ``SPINS`` what the main part of a node comes to;
    ``ENDINGS`` are the exceptions that Ctrl-C may end a node with; ``WAITING`` is the code that waits for its end.
    """

    NAME: str
    GOES_ON: str
    SPINS: str
    ENDINGS: tuple[type[BaseException], ...]
    WAITING: Collection[CodeType]

    def timer_of(self, frame: FrameType) -> Any:
        """The timer that calls back in a frame; None if the frame is another."""

    def timers(self, world: World, printed: Sequence[Printed]) -> list[tuple[Any, str, bool, bool]]:
        """The timers that were started, each with its source, whether it has ended, and whether it was asked to."""

    def whose(self, codes: Collection[CodeType]) -> str:
        """What of a node an exception has ended, by the code that it came through; empty if it is nothing of ROS's."""

    def hint(self, error: BaseException, whose: str) -> str:
        """A hint for whom an exception met; empty if there is none."""


class Seen:
    """What an answer did in one run of ``seconds``.

    ``printed`` are the lines that it printed, also after Ctrl-C; ``timers`` are those that it had started by then;
    ``loops`` are the lines of the answer in which something other than a timer's callback slept again and again;
    ``messages`` are what it published. ``status`` is how it ended, ``errors`` are the exceptions whose tracebacks were
    printed, and ``interrupted`` says whether it ran until Ctrl-C. Of one that had to be killed, ``kept_at`` is what
    kept it from its end, and ``kept_by_rate`` says that nothing but a Rate of ROS 2 did.
    """

    def __init__(
        self,
        seconds: float,
        printed: Sequence[Printed],
        timers: Sequence[SeenTimer],
        loops: Sequence[int],
        messages: Sequence[Message],
        status: int,
        errors: Sequence[BaseException],
        interrupted: bool,
        kept_at: Place | None,
        kept_by_rate: bool,
    ) -> None:
        self.seconds = seconds
        self.printed = tuple(printed)
        self.timers = tuple(timers)
        self.loops = tuple(loops)
        self.messages = tuple(messages)
        self.status = status
        self.errors = tuple(errors)
        self.interrupted = interrupted
        self.kept_at = kept_at
        self.kept_by_rate = kept_by_rate

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
        known = [timer.timer for timer in self.timers]
        timers = [timer for timer in self.timers if any(line.timer is timer.timer for line in lines)]
        return timers, [line for line in lines if not any(line.timer is timer for timer in known)]
