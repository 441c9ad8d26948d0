"""What keeps the simulated lane simulated: no real pause, and no process but Python, node and what makes the site."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

# Programs that a test of the simulated lane may start: Python and node, what the author of a page types, and commands
# in launch files.
PROGRAMS = (*("python", "node"), *("make", "git", "sh"), *("false", "yes", "rosspin-nowhere"))

_watched = False
_seen: list[str] = []


class OutOfLane(Exception):
    """A test of the simulated lane does something that belongs into tests/real."""


@contextmanager
def simulated_only() -> Iterator[None]:
    """Within this context whatever needs a real clock, or a foreign process, is an error (OutOfLane).

    It is raised where that is asked for, and once more at the end, for there it may have been caught.
    """
    global _watched
    _seen.clear()
    _watched = True
    try:
        yield
    finally:
        _watched = False
    if _seen:
        raise OutOfLane("; ".join(_seen))


def _look(event: str, args: tuple[Any, ...]) -> None:
    if not _watched or event not in ("time.sleep", "subprocess.Popen"):
        return
    if event == "time.sleep":
        if args[0] <= 0:
            return
        text = f"it sleeps for {args[0]} s in real time"
    else:
        program = Path(os.fspath(args[0])).name
        if program.startswith(PROGRAMS):
            return
        text = f"it starts {program}"
    _seen.append(f"{text}: such a test belongs into tests/real")
    raise OutOfLane(_seen[-1])


sys.addaudithook(_look)
