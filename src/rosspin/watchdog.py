"""Ends a simulated run whose node never sleeps: no time passes there, so nothing else could end it."""

from __future__ import annotations

import ctypes
import signal
import sys
import threading
import traceback
from collections.abc import Callable
from types import FrameType
from typing import Any

__all__ = ["Stuck", "Watchdog", "watch"]

# Looked at so often (s), so many times: under 5 s in all. A machine that stands still itself counts as one look.
_INTERVAL = 0.4
_LOOKS = 9


class Stuck(BaseException):
    """Raised in the node's code when it has been found stuck."""


class Watchdog:
    """Raises :class:`Stuck` in the code within its ``with`` when ``sign_of_life()`` has not changed for some seconds.

    Code that is importing something is left alone. ``stack`` is then where it was stuck, outermost frame first.
    """

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        self._sign_of_life = sign_of_life
        self._previous: Any = None
        self._last = -1
        self._looks = 0
        self.stack: traceback.StackSummary | None = None

    def __enter__(self) -> Watchdog:
        raise NotImplementedError

    def __exit__(self, *error: object) -> None:
        raise NotImplementedError

    def _is_stuck(self, frame: FrameType | None) -> bool:
        """Look at the code, which is at ``frame``: whether it has been without a sign of life for too many looks."""
        seen, self._last = self._last, self._sign_of_life()
        self._looks = 0 if self._last != seen or _is_importing(frame) else self._looks + 1
        if self._looks < _LOOKS:
            return False
        self.stack = traceback.extract_stack(frame)
        return True


class _FromAThread(Watchdog):
    """Looks at the thread that made it from another one."""

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        super().__init__(sign_of_life)
        self._thread = threading.current_thread()
        self._done = threading.Event()
        self._watcher = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Watchdog:
        if self._thread is threading.main_thread():
            # Only a signal also ends calls that block, such as threading.Event().wait().
            self._previous = signal.signal(signal.SIGINT, self._on_signal)
        self._watcher.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._done.set()
        self._watcher.join()
        if self._thread is threading.main_thread():
            signal.signal(signal.SIGINT, self._previous)

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        if self._done.is_set():
            return
        if self.stack is not None:
            raise Stuck
        if callable(self._previous):
            self._previous(number, frame)

    def _watch(self) -> None:
        ident = self._thread.ident
        assert ident is not None
        while not self._done.wait(_INTERVAL):
            if self._is_stuck(sys._current_frames().get(ident)):
                if self._thread is threading.main_thread():
                    signal.pthread_kill(ident, signal.SIGINT)
                else:
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(Stuck))


class _FromInterrupts(Watchdog):
    """Looks when it is interrupted; a web page has no threads, there ``web/worker.js`` interrupts every 0.4 s."""

    def __enter__(self) -> Watchdog:
        self._previous = signal.signal(signal.SIGINT, self._on_interrupt)
        return self

    def __exit__(self, *error: object) -> None:
        signal.signal(signal.SIGINT, self._previous)

    def _on_interrupt(self, number: int, frame: FrameType | None) -> None:
        if self._is_stuck(frame):
            raise Stuck


def watch(sign_of_life: Callable[[], int]) -> Watchdog:
    """The :class:`Watchdog` for where this runs."""
    return _FromInterrupts(sign_of_life) if sys.platform == "emscripten" else _FromAThread(sign_of_life)


def _is_importing(frame: FrameType | None) -> bool:
    while frame:
        if frame.f_code.co_filename == "<frozen importlib._bootstrap>":
            return True
        frame = frame.f_back
    return False
