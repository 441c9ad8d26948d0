"""Find and end the processes that descend from this one. Only Linux shows them."""

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

# A process may keep starting others, so all are stopped before any is killed; each takes at most this many looks.
_LOOKS = 100


def adopt_orphans() -> None:
    """Make this process the parent of whatever its descendants leave behind, in any session (Linux only)."""
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def kill_descendants(ancestor: int | None = None, but: Set[int] = frozenset()) -> None:
    """Kill all descendants of a process (default: this one) except ``but``. Does nothing elsewhere than on Linux."""
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
    """Find all processes that descend from a process, as far as ``/proc`` shows them."""
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
