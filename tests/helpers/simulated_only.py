"""What keeps the simulated lane simulated: no real pause, and no process but Python and node."""

from __future__ import annotations

import os
import platform
import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn
from unittest import mock

from rosspin.clocks.clock import WallClock

# Programs that a test of the simulated lane may start: Python and node, and commands in launch files.
PROGRAMS = re.compile(r"python[\d.]*|node|sh|false|yes|rosspin-nowhere")

_real_sleep = time.sleep
_watched = False
_seen: list[str] = []


class OutOfLane(Exception):
    """A test of the simulated lane does something that belongs into tests/real."""


@contextmanager
def simulated_only() -> Iterator[None]:
    """Within this context whatever needs a real clock, or a foreign process, is an error (OutOfLane).

    It is raised where that is asked for, and once more at the end, for there it may have been caught.
    """
    global _watched, _seen
    before, (_watched, _seen) = (_watched, _seen), (True, [])
    try:
        with mock.patch.object(WallClock, "now", _refuse_the_wall_clock), mock.patch.object(time, "sleep", sleep):
            yield
        if _seen:
            raise OutOfLane("; ".join(_seen))
    finally:
        _watched, _seen = before


def _refuse(text: str) -> NoReturn:
    _seen.append(f"{text}: such a test belongs into tests/real")
    raise OutOfLane(_seen[-1])


def _refuse_the_wall_clock(clock: WallClock) -> NoReturn:
    _refuse("it runs a node on the wall clock")


def sleep(seconds: float) -> None:
    """In place of time.sleep, whose name threads may have."""
    # Who waits for another process looks for it again and again.
    if seconds > 0 and sys._getframe(1).f_globals["__name__"] != "subprocess":
        _refuse(f"it sleeps for {seconds} s in real time")
    _real_sleep(seconds)


def _look(event: str, args: tuple[Any, ...]) -> None:
    if not _watched or event != "subprocess.Popen":
        return
    program = Path(os.fspath(args[0])).name
    if not PROGRAMS.fullmatch(program):
        _refuse(f"it starts {program}")
    if "rosspin.run.wall" in str(args[1]):
        _refuse("it runs a node on the wall clock")


# Python asks uname once in a process, for a traceback of Sphinx's, say.
platform.platform()
sys.addaudithook(_look)
