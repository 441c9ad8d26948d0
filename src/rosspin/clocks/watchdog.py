"""End a simulated run whose node does not let the time pass; nothing else could end it."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from _thread import get_ident
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import perf_counter
from traceback import walk_stack
from types import FrameType
from typing import Any

from .ending import Ended, end_at, end_thread, spare_me
from .frames import Place, called_from, places, trail, trail_of
from .stacks import Stack, current

__all__ = ["Stuck", "Watchdog", "watch"]

# How far apart (s) the looks at a run are, and how many find it stuck: under 5 s in all. A standstill of the machine
# itself is one look, and a look at code that was waiting for a processor is a part of one.
_INTERVAL = 0.4
_LOOKS = 9

# How many times as long an import may take: a large library on a slow machine does. A stack that is being taken down,
# and does not even heed that its time is over, has as long before the process ends.
_PATIENT = 10

# A thread that has a processor, or wants one, for less than this share of the time waits for something else.
_BUSY = 0.2

# Taken before any node can replace them. The timer counts the time for which the process works: the timer of real time
# may be in use, and this one hardly ever is.
_pthread_kill: Any = getattr(signal, "pthread_kill", None)
_setitimer: Any = getattr(signal, "setitimer", None)
_getitimer: Any = getattr(signal, "getitimer", None)
_ITIMER: Any = getattr(signal, "ITIMER_VIRTUAL", None)


class Stuck(Exception):
    """A run was found stuck at ``places``, innermost first. ``waits`` says that it was waiting there, not working.

    After these come the places at which it was then ended: when it was found, it may have been between two stacks.
    ``computed`` is how long (s) code in C had let nothing else run, if that is why.
    """

    def __init__(self, places: list[Place], waits: bool, computed: float = 0.0) -> None:
        super().__init__()
        self.places = places
        self.waits = waits
        self.computed = computed


class Watchdog:
    """Ends the code within its ``with`` when ``sign_of_life()`` has not changed for some seconds, and raises Stuck.

    Code that is importing something is given more time. Exceptions are raised in stacks only, never in what runs them.
    """

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        self._sign_of_life = sign_of_life
        self._is_main = threading.current_thread() is threading.main_thread()
        self._last = -1
        self._looks = 0.0
        self._worked = self._busy_until_now()
        self._stuck: Stuck | None = None
        self._interrupted = False  # by someone's Ctrl-C
        self._due = False  # whether what is running should be ended
        self._taking_down = False

    def __enter__(self) -> Watchdog:
        if self._is_main:
            # Only a signal also ends calls that block.
            self._previous = signal.signal(signal.SIGINT, self._on_signal)
        return self

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if self._is_main:
            signal.signal(signal.SIGINT, self._previous)
        if isinstance(error, Ended) and self._stuck:
            self._stuck.places += places(trail_of(error.__traceback__))
            raise self._stuck from None
        if self._interrupted:
            raise KeyboardInterrupt from None

    @contextmanager
    def taking_down(self) -> Iterator[Callable[[], bool]]:
        """Within this context stacks are ended, in as much time again. Yields a function that says if it is over.

        Until then nothing is raised in them; after that, only in a stack that keeps the others from being ended.
        """
        self._begin(taking_down=True)
        try:
            yield lambda: self._due
        finally:
            self._begin(taking_down=False)

    def _begin(self, taking_down: bool) -> None:
        self._taking_down, self._due, self._looks, self._last = taking_down, False, 0, -1

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        raise NotImplementedError

    def _busy_until_now(self) -> float:
        """For how long (s) the thread that is watched has had a processor or wanted one. In a page it always has."""
        return perf_counter()

    def _look(self) -> float:
        """How much a look counts: less than 1 if the thread has waited for a processor since the last one."""
        return 1.0

    def _is_due(self, find_frame: Callable[[], FrameType | None]) -> bool:
        """Look at the code, and decide whether to end it. ``find_frame()`` is where it is.

        What holds a frame keeps all that the frame refers to, such as a node that should be gone: it is seldom asked.
        """
        self._due = self._due or (self._is_over() if self._taking_down else self._is_stuck(find_frame))
        return self._due

    def _is_over(self) -> bool:
        """Whether the time to take a run down is over."""
        self._looks += self._look()
        return round(self._looks) > _LOOKS

    def _is_stuck(self, find_frame: Callable[[], FrameType | None]) -> bool:
        """Whether the code has been without a sign of life for too many looks."""
        seen, self._last = self._last, self._sign_of_life()
        look = self._look()
        if self._last != seen:
            self._looks = 0
            self._worked = self._busy_until_now()
            return False
        self._looks += look
        if round(self._looks) < _LOOKS:
            return False
        frame = find_frame()
        if _is_importing(frame) and round(self._looks) < _LOOKS * _PATIENT:
            return False
        if self._stuck is None:
            worked = self._busy_until_now() - self._worked
            self._stuck = Stuck(places(trail(frame)), waits=worked < _BUSY * self._looks * _INTERVAL)
        return True


class _FromAThread(Watchdog):
    """Looks, from a thread of its own, at the thread that made it.

    Code in C may let no other thread run. For the main thread, each look therefore resets a timer of the process. It
    rings if there is no look for long, and its signal asks the code to end. Most endless calls heed it.
    """

    def __init__(self, sign_of_life: Callable[[], int]) -> None:
        self._ident = get_ident()
        self._clock = time.pthread_getcpuclockid(self._ident) if hasattr(time, "pthread_getcpuclockid") else None
        self._scheduled = f"/proc/self/task/{threading.get_native_id()}/schedstat"
        self._looked = perf_counter()
        self._in_line = self._scheduled_until_now()[1]
        super().__init__(sign_of_life)
        self._done = threading.Event()
        self._turn = threading.Lock()  # held while looking, and while something else begins
        self._sent = self._received = 0  # signals of its own, or exceptions
        self._watcher = threading.Thread(target=self._watch, daemon=True)
        self._has_timer = self._is_main and _ITIMER is not None

    def __enter__(self) -> Watchdog:
        if self._has_timer:
            self._previous_timer = signal.signal(signal.SIGVTALRM, self._on_timer), _getitimer(_ITIMER)
        self._set_timer()
        super().__enter__()
        self._watcher.start()
        return self

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        self._done.set()
        self._watcher.join()
        if self._has_timer:
            handler, times = self._previous_timer
            _setitimer(_ITIMER, *times)
            signal.signal(signal.SIGVTALRM, handler)
        self._take_back()
        super().__exit__(kind, error, trace)

    def _begin(self, taking_down: bool) -> None:
        with self._turn:
            super()._begin(taking_down)
            self._take_back()

    def _take_back(self) -> None:
        if not self._is_main and self._sent != self._received:
            spare_me()
            self._received = self._sent

    def _busy_until_now(self) -> float:
        return sum(self._scheduled_until_now())

    def _scheduled_until_now(self) -> tuple[float, float]:
        """For how long (s) the thread has had a processor, and has waited for one, which only Linux tells."""
        try:
            with open(self._scheduled) as file:
                worked, in_line, _ = map(int, file.read().split())
            return worked / 1e9, in_line / 1e9
        except OSError:
            return (time.process_time() if self._clock is None else time.clock_gettime(self._clock)), 0.0

    def _look(self) -> float:
        looked, in_line = self._looked, self._in_line
        self._looked, (_, self._in_line) = perf_counter(), self._scheduled_until_now()
        return min(1.0, max(0.0, self._looked - looked - (self._in_line - in_line)) / _INTERVAL)

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        if self._done.is_set():
            return
        if self._received == self._sent:
            self._interrupted = self._due = True
        self._received = self._sent
        if self._due and isinstance(current(), Stack):
            end_at(frame)

    def _set_timer(self) -> None:
        self._set_at = perf_counter()
        if self._has_timer:
            _setitimer(_ITIMER, _INTERVAL * _LOOKS * _PATIENT)

    def _has_rung(self) -> bool:
        """Whether the timer has rung. Before its signal is handled, the watcher may get to look again."""
        return self._has_timer and not any(_getitimer(_ITIMER))

    def _on_timer(self, number: int, frame: FrameType | None) -> None:
        """Handle the timer's signal: the process has worked for long without a look, and code in C lets this run."""
        computed = perf_counter() - self._set_at
        if self._done.is_set():
            return
        if computed < _INTERVAL * _LOOKS * _PATIENT:  # several threads have worked at the same time
            self._set_timer()
            return
        if self._stuck is None and not self._taking_down:
            self._stuck = Stuck(places(trail(frame)), waits=False, computed=computed)
        self._due = True
        if isinstance(current(), Stack):
            end_at(frame)

    def _find_frame(self) -> FrameType | None:
        return sys._current_frames().get(self._ident)

    def _watch(self) -> None:
        while not self._done.wait(_INTERVAL):
            if not self._has_rung():
                self._set_timer()
            with self._turn:
                if not self._is_due(self._find_frame):
                    continue
                if self._taking_down and self._looks > _LOOKS * _PATIENT:
                    _end_process(self._find_frame())
                self._looks += 1
                if self._done.is_set():
                    break
                self._sent += 1
                if self._is_main:
                    _pthread_kill(self._ident, signal.SIGINT)
                else:
                    end_thread(self._ident)


def _end_process(frame: FrameType | None) -> None:
    """End the process: code in C holds the thread that everything else needs, and nothing can be raised in it."""
    at = called_from(frame) if frame else None
    where = f"{at.f_code.co_filename}:{at.f_lineno}: " if at else ""
    text = f"rosspin: {where}the run is over, but this does not end, so the whole process is ended\n"
    os.write(2, text.encode(errors="replace"))
    os._exit(1)


class _FromInterrupts(Watchdog):
    """Looks when it is interrupted: in a web page, without threads, ``web/src/worker.js`` interrupts every 0.4 s."""

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        from .jspi import can_raise  # which only a page can import

        if self._is_due(lambda: frame) and can_raise(frame):
            raise Ended


def watch(sign_of_life: Callable[[], int]) -> Watchdog:
    """Make the :class:`Watchdog` for this platform."""
    return _FromInterrupts(sign_of_life) if sys.platform == "emscripten" else _FromAThread(sign_of_life)


def _is_importing(frame: FrameType | None) -> bool:
    frames = walk_stack(frame) if frame else ()
    return any(each.f_code.co_filename == "<frozen importlib._bootstrap>" for each, _ in frames)
