"""End code that refuses to end, because it catches every exception and continues."""

from __future__ import annotations

import ctypes
import gc
import inspect
import sys
from _thread import get_ident
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

__all__ = ["Ended", "end_at", "end_thread", "ending_here", "heed", "spare_me"]

# Frames of these modules run to their own end, because other code relies on what they tidy up: the import system, on
# locks of the whole process. So do callbacks of the garbage collector and of weak references: they may run at any time,
# and Python only prints what is raised in them.
_IMPORTING = ("importlib", "_frozen_importlib", "_frozen_importlib_external")
_SPARED = (__name__.partition(".")[0], "threading", "concurrent", "contextlib", "weakref", "_weakrefset", *_IMPORTING)

_CAN_BE_CLOSED = inspect.CO_GENERATOR | inspect.CO_COROUTINE | inspect.CO_ASYNC_GENERATOR

# Threads in which code is being ended.
_ending: set[int] = set()


class Ended(BaseException):
    """Raised in code that should end now. If the code catches it, it is raised again on the next line.

    The thread is traced for this from the moment the exception is made. Python drops a trace function that raises, so
    a caught exception sets it again when it is deleted. In a web page nothing is traced, since the frames of other
    stacks cannot be touched there: the watchdog raises the exception again.
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
    if event == "exception" and arg[0] is GeneratorExit:
        frame.f_trace_lines = False  # it may be of an earlier run, and closed because garbage is collected
    if event == "call" and frame.f_code.co_flags & _CAN_BE_CLOSED:
        return _raise  # at its first line, if it is not closed
    if event in ("call", "line") and not _is_spared(frame) and get_ident() in _ending:
        raise Ended
    return _raise


def _is_spared(frame: FrameType) -> bool:
    return str(frame.f_globals.get("__name__", "")).partition(".")[0] in _SPARED or frame.f_code in [
        getattr(callback, "__code__", None) for callback in gc.callbacks
    ]


@contextmanager
def ending_here() -> Iterator[None]:
    """Confine an ending to this context: once :class:`Ended` has left it, the thread continues as before."""
    trace = sys.gettrace()
    try:
        yield
    finally:
        if get_ident() in _ending:
            _ending.discard(get_ident())
            sys.settrace(trace)


def heed() -> None:
    """Raise :class:`Ended` where code that should end has caught it, or has put another exception in its place."""
    if get_ident() in _ending:
        raise Ended


def end_at(frame: FrameType | None) -> None:
    """Raise :class:`Ended` in a handler of a signal that came in ``frame``; in the import system, once that is left.

    Where that waits for a lock, it is raised there, too.
    """
    ended = Ended()
    module = str(frame.f_globals.get("__name__", "")).partition(".")[0] if frame else ""
    if module not in _IMPORTING or (frame and frame.f_code.co_name == "acquire"):
        raise ended


def end_thread(ident: int) -> None:
    """Raise :class:`Ended` in another thread, as soon as it is not in a call that blocks."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(Ended))


class _Nothing(BaseException):
    pass


def spare_me() -> None:
    """Withdraw an :class:`Ended` that ``end_thread`` has sent to the calling thread, if it has not been raised yet."""
    try:
        with ending_here():
            # Given None instead, CPython 3.11 would continue looking for an exception at every step.
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(get_ident()), ctypes.py_object(_Nothing))
            while True:
                pass  # it comes immediately
    except (_Nothing, Ended):
        pass
