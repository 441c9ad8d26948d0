"""What a thread waits at, for another one or for a signal."""

from __future__ import annotations

import threading
from typing import Any

from ..world.world import current

__all__ = ["Event"]


class Event:
    """Lets one thread wait until another, or a signal handler, sets it, and is no longer set then."""

    def __init__(self) -> None:
        self._lock: Any = threading.Lock()
        self._lock.acquire()

    def set(self) -> None:
        """Let the thread that waits, or the next one that will, continue."""
        try:
            self._lock.release()
        except RuntimeError:
            pass  # it is set

    def wait(self, ns: int | None = None) -> bool:
        """Wait until it is set, for at most ``ns`` nanoseconds, and clear it. Return whether it was set."""
        if ns is not None and ns <= 0:
            return bool(self._lock.acquire(False))
        if hasattr(self._lock, "wait") and self._lock.locked():
            self._lock.holder = None  # whoever made it, or waited last, does not keep others from continuing
            return bool(self._lock.wait(current(), ns))  # exactly, and at a lower cost than by way of seconds
        return bool(self._lock.acquire(True, -1 if ns is None else min(ns / 1e9, threading.TIMEOUT_MAX)))
