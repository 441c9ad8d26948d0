"""Threads of a node, on whichever clock its world has."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable
from types import FrameType, TracebackType

from ..clock import nanoseconds
from .world import NotSimulated, world

__all__ = ["own_frame", "own_frames", "print_traceback", "start_thread"]

_PACKAGE = __name__.rpartition(".rospy")[0]


class Thread:
    """A thread that has been started; ``alive`` until its function has returned or raised."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.alive = True
        self.ended = world().clock.condition()

    def join(self, timeout: float | None) -> None:
        """Wait until the thread has ended, at most ``timeout`` seconds."""
        clock = world().clock
        deadline = None if timeout is None else clock.now() + nanoseconds(timeout)
        while self.alive and (deadline is None or clock.now() < deadline):
            self.ended.wait(10**9 if deadline is None else deadline - clock.now())


def start_thread(function: Callable[[], None]) -> Thread:
    """Run ``function`` in a daemon thread. An exception there is printed and ends that thread alone."""
    here = world()
    here.threads += 1
    thread = Thread(f"Thread-{here.threads}")

    def run() -> None:
        try:
            function()
        except SystemExit:
            pass
        except NotSimulated as error:
            here.failure = error
            here.shutdown = True
        except (Exception, KeyboardInterrupt):
            sys.stderr.write(f"Exception in thread {thread.name}:\n")
            print_traceback(made)
        finally:
            thread.alive = False
            thread.ended.notify_all()

    caller = own_frame(sys._getframe())
    made = traceback.FrameSummary(
        caller.f_code.co_filename, caller.f_lineno, f"{caller.f_code.co_name}, which made this timer", lookup_line=False
    )
    here.clock.start(run, f"{made.filename}:{made.lineno}")
    return thread


def own_frame(frame: FrameType) -> FrameType:
    """The innermost frame outside of this package: the line of the node that is being run."""
    while _is_ours(frame) and frame.f_back:
        frame = frame.f_back
    return frame


def _is_ours(frame: FrameType) -> bool:
    module = frame.f_globals.get("__name__", "")
    return bool(module == _PACKAGE or module.startswith(_PACKAGE + "."))


def own_frames(trace: TracebackType | None) -> TracebackType | None:
    """A traceback without the frames of this package: those of the node are left."""
    frames = []
    while trace:
        if not _is_ours(trace.tb_frame):
            frames.append(trace)
        trace = trace.tb_next
    kept = None
    for frame in reversed(frames):
        kept = TracebackType(kept, frame.tb_frame, frame.tb_lasti, frame.tb_lineno)
    return kept


def print_traceback(made: traceback.FrameSummary | None = None) -> None:
    """Print the exception being handled on stderr, with the node's own frames.

    If it has none, as when the callback cannot be called, the frame ``made`` is shown, in which its thread was started.
    """
    kind, error, trace = sys.exc_info()
    assert kind is not None and error is not None
    printed = traceback.TracebackException(kind, error, own_frames(trace))
    # The heading is there even if no frame is.
    printed.stack = printed.stack or traceback.StackSummary.from_list([made] if made else [])
    sys.stderr.write("".join(printed.format()))
    world().errors.append(error)
