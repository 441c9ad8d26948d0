"""End code that refuses to end, because it catches every exception and goes on."""

from __future__ import annotations

import ctypes
import gc
import sys
from _thread import get_ident
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

__all__ = ["Ended", "end_thread", "ending_here", "spare_me"]

# Modules whose frames are left to come to their own end: they put in order what others rely on. What the garbage
# collector or a weak reference calls may come at any time, and Python prints what is raised in it.
_SPARED = (__name__.partition(".")[0], "threading", "concurrent", "contextlib", "weakref", "_weakrefset")

# Threads in which code is being ended.
_ending: set[int] = set()


class Ended(BaseException):
    """Raised in code that is to end now. If it is caught there, it is raised again on the next line.

    For that the thread is traced from the moment in which the exception is made. A trace function that raises is
    dropped by Python, so a caught exception sets it once more when it goes. In a web page, where the frames of other
    stacks cannot be touched, nothing is traced: there the watchdog raises it anew.
    """

    def __init__(self) -> None:
        super().__init__()
        _ending.add(get_ident())
        _trace()

    def __del__(self) -> None:
        if get_ident() in _ending:
            _trace()


def _trace() -> None:
    if sys.platform == "emscripten":
        return
    sys.settrace(_raise)
    frame: FrameType | None = sys._getframe()
    while frame:
        if not _is_spared(frame):
            frame.f_trace = _raise
        frame = frame.f_back


def _raise(frame: FrameType, event: str, arg: Any) -> Any:
    if event in ("call", "line") and not _is_spared(frame) and get_ident() in _ending:
        raise Ended
    return _raise


def _is_spared(frame: FrameType) -> bool:
    return str(frame.f_globals.get("__name__", "")).partition(".")[0] in _SPARED or frame.f_code in [
        getattr(callback, "__code__", None) for callback in gc.callbacks
    ]


@contextmanager
def ending_here() -> Iterator[None]:
    """Where this context ends, an :class:`Ended` that leaves it has done its work: its thread goes on as before."""
    trace = sys.gettrace()
    try:
        yield
    finally:
        if get_ident() in _ending:
            _ending.discard(get_ident())
            sys.settrace(trace)


def end_thread(ident: int) -> None:
    """Raise :class:`Ended` in another thread, as soon as it is not in a call that blocks."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(Ended))


class _Nothing(BaseException):
    pass


def spare_me() -> None:
    """Take that back, if it was for the calling thread and has not been raised yet."""
    try:
        with ending_here():
            # To set none would leave CPython 3.11 looking for one at every step.
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(get_ident()), ctypes.py_object(_Nothing))
            while True:
                pass  # it comes at once
    except (_Nothing, Ended):
        pass
