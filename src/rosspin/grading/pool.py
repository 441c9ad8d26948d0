"""Judge answers in processes of their own, several at a time.

Each worker is a process that has imported everything, and forks twice for each answer. The first child runs the answer
and writes down what it did. The second judges these notes: nothing of the answer has run in it. What either sends is a
text of limited length, which is checked before it is believed. A worker that an answer has changed is replaced.
"""

from __future__ import annotations

import json
import os
import selectors
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import NamedTuple

from ..cpp import building
from ..exercises import Verdict, code
from ..exercises.traces import LONGEST
from ..hand_ins import MOST_SAID, TIME, too_long
from ..run.kinds import written_in
from .sealed import CannotSeal, Process
from .worker import AS_BEFORE, OPEN, SEALED

__all__ = ["LOOK", "Pool", "Task", "not_judged"]

LOOK = 0.2
"""How long (s) to wait at most for anything before looking at the time, and whether to stop."""

_NOT_SEALED = "It could not be sealed as it has to be, so nothing of it has run."
_BROKE_DOWN = "Its Python broke down before it had noted what the answer did."
_JUDGE_BROKE_DOWN = "The process that judged it broke down."


# So many times as long as others an answer in C++ may take: it is compiled first.
_LONGER = 3


def _is_cpp(text: str) -> bool:
    return written_in(code(text)) is not None


class Task(NamedTuple):
    """An answer to judge: the name of its exercise, and its text."""

    exercise: str
    text: str


# The number of a task, and what came of it if it should be judged.
_Job = tuple[int, Task, str | None]


class _Worker:
    """A process, and what it is doing: the task of this number, which it runs, or judges if there is a trace."""

    def __init__(self, sealed: bool) -> None:
        self._sealed = sealed
        self.process = Process(sealed, TIME)
        self.number = 0
        self.task = Task("", "")
        self.traced = False
        self.time = TIME
        self.deadline = 0.0
        self._job = b""
        self._sent = bytearray()
        self._status = b""
        for file in (self.process.results, self.process.status, self.process.jobs):
            os.set_blocking(file, False)

    def begin(self, number: int, task: Task, trace: str | None = None) -> None:
        """Give it a task, or what came of it to judge."""
        self.number, self.task, self.traced = number, task, trace is not None
        self._give(task._asdict() if trace is None else {**task._asdict(), "trace": trace})

    def _give(self, job: dict[str, str]) -> None:
        is_cpp = bool(job) and "trace" not in job and _is_cpp(job["text"])
        self._job = json.dumps(job).encode()
        self._sent.clear()
        self._status = b""
        self.time = TIME * _LONGER if is_cpp else TIME
        self.deadline = time.monotonic() + self.time
        with suppress(BrokenPipeError):  # which is seen when its status is read
            self.process.control.write(b"%d %d\n" % (len(self._job), is_cpp))

    def work(self) -> bool:
        """Write and read what can be; whether the child has ended, or has to be."""
        with suppress(BlockingIOError, BrokenPipeError):
            if self._job:
                self._job = self._job[os.write(self.process.jobs, self._job) :]
        self._read()
        try:
            self._status = os.read(self.process.status, 100)
        except BlockingIOError:
            return len(self._sent) > LONGEST + 1000
        self._read()  # all that it sent before it ended, and before another child begins
        return True

    def _read(self) -> None:
        with suppress(BlockingIOError):
            while len(self._sent) <= LONGEST + 1000 and (data := os.read(self.process.results, 1 << 16)):
                self._sent += data

    def outcome(self) -> tuple[str | None, bytes]:
        """Return what was sent, and why it is of no use if it is not."""
        word, newline, sent = bytes(self._sent).partition(b"\n")
        if word + newline != (SEALED if self._sealed else OPEN):
            return f"{_NOT_SEALED} (It said: {word.decode(errors='replace')[:100] or 'nothing'}.)", b""
        if not self._status.startswith(b"0 "):
            return _JUDGE_BROKE_DOWN if self.traced else _BROKE_DOWN, b""
        return None, sent

    @property
    def waits_for(self) -> Iterator[tuple[int, int]]:
        """What it waits for: files, and whether to read them or to write to them."""
        yield self.process.results, selectors.EVENT_READ
        yield self.process.status, selectors.EVENT_READ
        if self._job:
            yield self.process.jobs, selectors.EVENT_WRITE

    @property
    def is_as_before(self) -> bool:
        """Whether the child has changed nothing for the next one."""
        return self._status == AS_BEFORE and not self._job

    def tried(self) -> str:
        """Have it do nothing, sealed as for an answer; why that is not so."""
        self._give({})
        while not self.work():
            if time.monotonic() > self.deadline:
                return "it was not ready in time"
            time.sleep(0.001)
        return self.outcome()[0] or ""


class Pool:
    """Judges tasks, as many at a time as there are processors. Ctrl-C, and SIGTERM, make it stop.

    ``why`` says why answers are not sealed; it is empty if they are.
    """

    def __init__(self, unsealed: bool = False) -> None:
        """Start a worker. If answers cannot be sealed, they have to be allowed to be ``unsealed``.

        Otherwise :class:`CannotSeal` is raised.
        """
        self.stopped = False
        self.why = ""
        self._number = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
        try:
            worker = _Worker(sealed=True)
            if why := worker.tried():
                worker.process.end()
                raise CannotSeal(why)
        except CannotSeal as error:
            if not unsealed:
                raise
            self.why = str(error)
            worker = _Worker(sealed=False)
        self._idle = [worker]
        self._at_work: list[_Worker] = []

    def judge(self, tasks: Iterable[Task], done: Callable[[int, Verdict], None]) -> None:
        """Judge tasks, and call ``done`` with the number of each, from 0 on, and its verdict, in the order they come.

        Those that are not judged when it stops have no verdict.
        """
        waiting: deque[_Job] = deque((number, task, None) for number, task in enumerate(tasks))
        with self.stopping():
            try:
                while not self.stopped and (waiting or self._at_work):
                    while waiting and len(self._at_work) < self._number:
                        self._begin(waiting.popleft(), done)
                    self._look(waiting, done)
            finally:
                for worker in self._at_work:
                    worker.process.end()
                self._at_work = []

    @contextmanager
    def stopping(self) -> Iterator[None]:
        """Within this context, signals stop it. A thread that is not the main one gets none."""
        own = threading.current_thread() is threading.main_thread()
        numbers = (signal.SIGINT, signal.SIGTERM) if own else ()
        before = {number: signal.signal(number, self._stop) for number in numbers}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def close(self) -> None:
        """End all workers."""
        for worker in self._idle:
            worker.process.end()
        self._idle = []

    def _stop(self, number: int, frame: object) -> None:
        self.stopped = True

    def _begin(self, job: _Job, done: Callable[[int, Verdict], None]) -> None:
        number, task, trace = job
        if why := too_long(task.text):
            done(number, not_judged(task, why))
            return
        if trace is None and _is_cpp(task.text):
            try:
                building.prepare()
            except ValueError as error:
                done(number, not_judged(task, f"{error}."))
                return
        try:
            worker = self._idle.pop() if self._idle else _Worker(not self.why)
        except (CannotSeal, OSError) as error:
            done(number, not_judged(task, _NOT_SEALED if isinstance(error, CannotSeal) else str(error)))
            return
        self._at_work.append(worker)
        worker.begin(number, task, trace)

    def _look(self, waiting: deque[_Job], done: Callable[[int, Verdict], None]) -> None:
        with selectors.DefaultSelector() as selector:
            for worker in self._at_work:
                for file, events in worker.waits_for:
                    selector.register(file, events)
            selector.select(LOOK)
        for worker in [*self._at_work]:
            if worker.work():
                self._go_on(worker, waiting, done)
            elif worker.deadline < time.monotonic():
                self._at_work.remove(worker)
                worker.process.end()
                said = f"It was ended after {worker.time} s."
                done(worker.number, not_judged(worker.task, said)._replace(verdict="did not end"))

    def _go_on(self, worker: _Worker, waiting: deque[_Job], done: Callable[[int, Verdict], None]) -> None:
        """Have what was noted judged, or tell the verdict."""
        self._at_work.remove(worker)
        why, sent = worker.outcome()
        if worker.is_as_before:
            self._idle.append(worker)
        else:
            worker.process.end()
        if why:
            done(worker.number, not_judged(worker.task, why))
        elif worker.traced:
            done(worker.number, _verdict(worker.task, sent))
        else:
            waiting.appendleft((worker.number, worker.task, sent.decode("utf-8", "replace")))


def _verdict(task: Task, sent: bytes) -> Verdict:
    try:
        found = Verdict(*json.loads(sent))
    except (ValueError, TypeError):
        found = not_judged(task, _JUDGE_BROKE_DOWN)
    shown = found.console[: max(MOST_SAID - len(found.said), 0)]
    said = "\n".join(filter(None, [shown, found.said]))[:MOST_SAID]
    return found._replace(said=said)


def not_judged(task: Task, said: str) -> Verdict:
    """Make the verdict on an answer that was not judged, for the reason that is ``said``."""
    return Verdict("not judged", False, f"Exercise {task.exercise}: not judged.", "", said)
