"""A node in C++, as judging sees it: what its program tells the host, whichever ROS it is of."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from types import CodeType, FrameType
from typing import Any

from ..clocks.clock import NS
from ..programs import Running
from ..world.world import World
from .judging import plain
from .observed import Error, ObservedTimer, Printed
from .watched import Watched

__all__ = ["InCpp", "errors", "that_stopped"]

# What else than a timer ticks: see runtime/roscpp.cpp and rclcpp.cpp.
_RATE = re.compile(r"(Wall)?Rate( \d+)?$")

_LOGGER = re.compile(r"\[\w+\] \[[\d.]+\] \[([\w.]+)\]: ")

# The exit status of a program that was ended by SIGABRT, as by an exception that nothing catches.
_ABORTED = 128 + 6

_UNCAUGHT = "What threw this says in its own words what was wrong, and nothing in the node has caught it."

# What to say where a program was ended by a signal: by SIGFPE, and by SIGSEGV.
_TRAPPED = {
    128 + 8: "A whole number cannot be divided by 0: what has the divisor been set to by then?",
    128 + 11: "Something that the node uses there was not made yet, or has ended: what holds it, and for how long?",
}


class InCpp:
    """Knows what :class:`~.running.Ros` asks for. ``ros`` knows it of Python, and what both languages share."""

    ENDINGS: tuple[type[BaseException], ...] = ()
    WAITING: Collection[CodeType] = ()

    def __init__(self, ros: Any) -> None:
        self.parameters = ros.parameters
        self.in_words = ros.in_words

    def timer_of(self, frame: FrameType) -> Any:
        """Return the source of the timer whose call lasts while a program prints, or None."""
        return frame.f_locals["self"].calling or None if frame.f_code is Running._note.__code__ else None

    def heard_in(self, frame: FrameType) -> Any:
        """Return the message that a program was given at the moment at which it prints, or None."""
        if frame.f_code is not Running._note.__code__ or frame.f_locals["self"].calling:
            return None
        return frame.f_locals["self"].heard

    def timers(self, world: World, printers: Iterable[Any]) -> list[Watched]:
        """Return the timers that were started. Which of them have stopped is told at the end."""
        log = world.recording.log  # empty as long as nothing has ticked
        periods = {} if log is None else log.periods
        return [
            Watched(source, source, False, False, period / NS)
            for source, period in periods.items()
            if not _RATE.match(source)
        ]

    def whose(self, codes: Collection[CodeType]) -> str:
        """Return nothing: there is no exception of Python."""
        return ""

    def hint(self, error: BaseException, whose: str) -> str:
        """Return nothing, likewise."""
        return ""


def that_stopped(
    timers: Iterable[ObservedTimer], numbers: dict[Any, int], printed: Sequence[Printed], world: World
) -> tuple[ObservedTimer, ...]:
    """Return timers as they are at the end: a program that Ctrl-C has ended has told which calls would come next.

    ``numbers`` are theirs, by their sources. The name of its logger says which node a timer is of.
    """
    log = world.recording.log
    left = {numbers[source] for source, *_ in log.coming if source in numbers} if log is not None else set()
    known = world.interrupted and not world.exit_status
    loggers = {line.timer: found[1] for line in reversed(printed) if line.timer and (found := _LOGGER.match(line.text))}
    usual = next(iter(loggers.values()), "")  # of those that print in another way
    return tuple(
        timer._replace(
            state="stopped" if known and not timer.is_endless and timer.number not in left else timer.state,
            node="/" + loggers.get(timer.number, usual).replace(".", "/"),
        )
        for timer in timers
    )


def errors(world: World, printed: Sequence[Printed], path: str) -> tuple[Error, ...]:
    """Return what has ended a program from outside, by what was printed then."""
    lines = [line.text.strip() for line in printed]
    if world.exit_status == _ABORTED:
        start = next((n for n, line in enumerate(lines) if line.startswith("terminate called")), len(lines))
        said = " ".join(lines[start : start + 2]) or "abort()"
        hint = "A period cannot be negative." if "period cannot be negative" in said else _UNCAUGHT
        return (Error("exception", plain(said), 0, "node", False, hint),)
    if world.exit_status not in _TRAPPED:
        return ()
    trap = re.compile(rf"rosspin: {re.escape(path)}:(?:(\d+):)? (.*)")
    found = next(filter(None, map(trap.fullmatch, reversed(lines))), None)
    if not found:  # it has ended with this status by itself
        return ()
    return (Error("exception", plain(found[2]), int(found[1] or 0), "node", False, _TRAPPED[world.exit_status]),)
