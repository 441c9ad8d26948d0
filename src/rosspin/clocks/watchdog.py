"""End a simulated run whose node does not let the time go on; nothing else could end it."""

from __future__ import annotations

import signal
import sys
import threading
import time
from _thread import get_ident
from collections.abc import Callable
from time import perf_counter
from types import FrameType
from typing import Any

from ..frames import Place, places, trail
from .ending import Ended, end_thread

__all__ = ["Stuck", "Watchdog", "watch"]

# Looked at so often (s), so many times: under 5 s in all. A machine that stands still itself counts as one look.
_INTERVAL = 0.4
_LOOKS = 9

# An import may take so many times as long: a large library on a slow machine does.
_PATIENT = 10

# A thread that has a processor, or wants one, for less than this share of the time waits for something else.
_BUSY = 0.2


class Stuck(Exception):
    """A run was found stuck at ``places``, innermost first; ``waits``: it did not work there, but wait."""

    def __init__(self, places: list[Place], waits: bool) -> None:
        super().__init__()
        self.places = places
        self.waits = waits


class Watchdog:
    """Ends the code within its ``with`` when ``sign_of_life()`` has not changed for some seconds, and raises Stuck.

    Code that is importing something is given more time.
    """

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        self._sign_of_life = sign_of_life
        self._previous: Any = None
        self._last = -1
        self._looks = 0
        self._worked = self._busy_until_now()
        self._stuck: Stuck | None = None
        self._interrupted = False  # by somebody's Ctrl-C

    def __enter__(self) -> None:
        raise NotImplementedError

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, Ended):
            if self._stuck:
                raise self._stuck from None
            if self._interrupted:
                raise KeyboardInterrupt from None

    def _busy_until_now(self) -> float:
        """For how long (s) the thread that is watched has had a processor or wanted one. In a page it always has."""
        return perf_counter()

    def _is_stuck(self, frame: FrameType | None) -> bool:
        """Look at the code, which is at ``frame``: whether it has been without a sign of life for too many looks."""
        seen, self._last = self._last, self._sign_of_life()
        if self._last != seen:
            self._looks = 0
            self._worked = self._busy_until_now()
            return False
        self._looks += 1
        if self._looks < _LOOKS * (_PATIENT if _is_importing(frame) else 1):
            return False
        if self._stuck is None:
            worked = self._busy_until_now() - self._worked
            self._stuck = Stuck(places(trail(frame)), waits=worked < _BUSY * self._looks * _INTERVAL)
        return True


class _FromAThread(Watchdog):
    """Looks at the thread that made it from another one."""

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        self._ident = get_ident()
        self._is_main = threading.current_thread() is threading.main_thread()
        self._clock = time.pthread_getcpuclockid(self._ident) if hasattr(time, "pthread_getcpuclockid") else None
        self._scheduled = f"/proc/self/task/{threading.get_native_id()}/schedstat"
        super().__init__(sign_of_life)
        self._done = threading.Event()
        self._watcher = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> None:
        if self._is_main:
            # Only a signal also ends calls that block.
            self._previous = signal.signal(signal.SIGINT, self._on_signal)
        self._watcher.start()

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        self._done.set()
        self._watcher.join()
        if self._is_main:
            signal.signal(signal.SIGINT, self._previous)
        super().__exit__(kind, error, trace)

    def _busy_until_now(self) -> float:
        try:
            with open(self._scheduled) as file:  # Linux also tells for how long it stood in the queue, in ns
                worked, queued, _ = map(int, file.read().split())
            return (worked + queued) / 1e9
        except OSError:
            return time.process_time() if self._clock is None else time.clock_gettime(self._clock)

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        if self._done.is_set():
            return
        self._interrupted = self._stuck is None
        raise Ended

    def _watch(self) -> None:
        while not self._done.wait(_INTERVAL):
            if self._is_stuck(sys._current_frames().get(self._ident)):
                if self._is_main:
                    signal.pthread_kill(self._ident, signal.SIGINT)
                else:
                    end_thread(self._ident)


class _FromInterrupts(Watchdog):
    """Looks when it is interrupted; a web page has no threads, there ``web/worker.js`` interrupts every 0.4 s."""

    def __enter__(self) -> None:
        self._previous = signal.signal(signal.SIGINT, self._on_interrupt)

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        signal.signal(signal.SIGINT, self._previous)
        super().__exit__(kind, error, trace)

    def _on_interrupt(self, number: int, frame: FrameType | None) -> None:
        from .jspi import can_raise  # which only a page can import

        if self._is_stuck(frame) and can_raise(frame):
            raise Ended


def watch(sign_of_life: Callable[[], int]) -> Watchdog:
    """The :class:`Watchdog` for where this runs."""
    return _FromInterrupts(sign_of_life) if sys.platform == "emscripten" else _FromAThread(sign_of_life)


def _is_importing(frame: FrameType | None) -> bool:
    while frame:
        if frame.f_code.co_filename == "<frozen importlib._bootstrap>":
            return True
        frame = frame.f_back
    return False
