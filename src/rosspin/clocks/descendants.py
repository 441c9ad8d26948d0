"""The processes that this one has started, and those that they have: on Linux they can be found and ended."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
from collections.abc import Set
from contextlib import suppress
from pathlib import Path

__all__ = ["adopt_orphans", "descendants", "kill_descendants"]

_PR_SET_CHILD_SUBREAPER = 36

# One that starts others all the time is stopped before they are looked for; so often is looked.
_LOOKS = 100


def adopt_orphans() -> None:
    """From now on, what a descendant of this process leaves behind becomes its child, whatever session it is in."""
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def kill_descendants(ancestor: int | None = None, but: Set[int] = frozenset()) -> None:
    """Kill all descendants of a process (default: this one) but some; elsewhere than on Linux none is found."""
    for number in (signal.SIGSTOP, signal.SIGKILL):
        known: set[int] = set()
        for _ in range(_LOOKS):
            found = descendants(ancestor or os.getpid()) - {os.getpid()} - but - known
            if not found:
                break
            known |= found
            for pid in found:
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(pid, number)


def descendants(ancestor: int) -> set[int]:
    """The processes that a process has started, and those that these have, as far as they can be found."""
    children: dict[int, list[int]] = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            fields = path.read_text(errors="replace").rpartition(")")[2].split()
            if fields[0] != "Z":
                children.setdefault(int(fields[1]), []).append(int(path.parent.name))
    found: set[int] = set()
    waiting = [ancestor]
    while waiting:
        new = children.get(waiting.pop(), [])
        found.update(new)
        waiting += new
    return found
