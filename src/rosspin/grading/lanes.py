"""Judge answers in processes of their own, several at a time.

For each answer two processes are forked from this one, which has imported everything and runs none of an answer. The
first runs the answer and writes down what it did. The second judges these notes: nothing of the answer has run in it.
What either sends is a text of limited length, which is checked before it is believed.
"""

from __future__ import annotations

import errno
import gc
import importlib
import json
import os
import pkgutil
import selectors
import shutil
import signal
import sys
import sysconfig
import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import NamedTuple, NoReturn

from .. import exercises, rclpy, rospy
from ..clocks.descendants import adopt_orphans, descendants, kill_descendants
from ..exercises import Verdict
from ..exercises.traces import LONGEST
from ..run.alone import refuse_processes
from .hand_ins import MOST_ANSWER, code
from .sealed import limit, seal

__all__ = ["TIME", "Lanes", "Task"]

TIME = 20
"""For how long (s) an answer may run, or be judged, as on the page."""

# So much (characters) is kept of what was said of an answer, as on the page.
_MOST_SAID = 30_000

# How long (s) to wait at most for anything before looking at the time, and whether to stop.
_LOOK = 0.2

# What answers can import besides ROS: of what is installed here, no more than in a page.
_KNOWN = {*sys.stdlib_module_names, "__main__", "rosspin", "greenlet", "yaml", "_yaml"}

_OWN_FD = 3  # the end of the pipe that a child writes to


class Task(NamedTuple):
    """An answer to judge: the name of its exercise, and its text."""

    exercise: str
    text: str


class _Child:
    """A process at work on a task."""

    def __init__(self, pid: int, read: int, number: int, task: Task, trace: str | None, folder: str) -> None:
        self.pid = pid
        self.read = read
        self.number = number
        self.task = task
        self.trace = trace  # what it judges; None: it runs the answer
        self.folder = folder
        self.deadline = time.monotonic() + TIME
        self.sent = bytearray()


class Lanes:
    """Judges tasks, as many at a time as there are processors. Ctrl-C, and SIGTERM, make it stop."""

    def __init__(self) -> None:
        """Import all that answers need, and find out how processes can be sealed here: ``seals``."""
        for name in ("yaml", "xmlrpc.client"):  # which are else loaded when a node needs them
            importlib.import_module(name)
        for package in (rospy, rclpy, exercises):
            for module in pkgutil.iter_modules(package.__path__, f"{package.__name__}."):
                importlib.import_module(module.name)
        adopt_orphans()
        self.stopped = False
        self.lanes = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
        self._selector = selectors.DefaultSelector()
        self._folder = tempfile.mkdtemp(prefix="rosspin-judge-")
        os.chmod(self._folder, 0o711)
        self.seals = frozenset(self._tried().split())

    def _tried(self) -> str:
        """Find out which seals there are, in a process that is sealed for that."""
        pid, read = self._fork(lambda: "", self._folder)
        with open(read, "rb") as file:
            said = file.read()
        os.waitpid(pid, 0)
        return said.partition(b"\n")[0].decode()

    def judge(self, tasks: Iterable[Task], done: Callable[[int, Verdict], None]) -> None:
        """Judge tasks, and call ``done`` with the number of each, from 0 on, and its verdict, in the order they come.

        Those that are not judged when it stops have no verdict.
        """
        gc.collect()
        gc.freeze()
        before = {number: signal.signal(number, self._stop) for number in (signal.SIGINT, signal.SIGTERM)}
        waiting, others = deque(enumerate(tasks)), descendants(os.getpid())
        try:
            while not self.stopped and (waiting or self._selector.get_map()):
                while waiting and len(self._selector.get_map()) < self.lanes:
                    number, task = waiting.popleft()
                    if len(task.text) > MOST_ANSWER:
                        said = f"It has {len(task.text)} characters; at most {MOST_ANSWER} are judged."
                        done(number, _not_judged(task, said))
                    else:
                        self._start(number, task, None)
                self._look(done)
        finally:
            for key in list(self._selector.get_map().values()):
                self._end(key.data)
            for number, handler in before.items():
                signal.signal(number, handler)
            if "network" not in self.seals:  # with namespaces, nothing outlives the first process in them
                kill_descendants(but=others)
            gc.unfreeze()

    def close(self) -> None:
        """Take the folder of the answers away."""
        shutil.rmtree(self._folder, ignore_errors=True)

    def _stop(self, number: int, frame: object) -> None:
        self.stopped = True

    def _start(self, number: int, task: Task, trace: str | None) -> None:
        work = (lambda: _trace(task)) if trace is None else (lambda: _judge(task, trace))
        folder = self._folder if trace is None else ""
        if folder and "disk" not in self.seals:  # else each has a folder in memory in its place
            folder = tempfile.mkdtemp(dir=folder)
        pid, read = self._fork(work, folder)
        self._selector.register(read, selectors.EVENT_READ, _Child(pid, read, number, task, trace, folder))

    def _fork(self, work: Callable[[], str], folder: str) -> tuple[int, int]:
        read, write = os.pipe()
        sys.stdout.flush()
        sys.stderr.flush()
        if pid := os.fork():
            os.close(write)
            return pid, read
        _work(work, write, folder)

    def _look(self, done: Callable[[int, Verdict], None]) -> None:
        for key, _ in self._selector.select(_LOOK):
            child: _Child = key.data
            data = os.read(child.read, 1 << 16)
            child.sent += data
            if not data or len(child.sent) > LONGEST + 1000:
                status = self._end(child)
                self._go_on(child, status, done)
        now = time.monotonic()
        for key in list(self._selector.get_map().values()):
            if key.data.deadline < now:
                self._end(key.data)
                said = f"It was ended after {TIME} s."
                done(key.data.number, _not_judged(key.data.task, said)._replace(verdict="did not end"))

    def _end(self, child: _Child) -> int:
        """End a process and all that it has started; its status."""
        self._selector.unregister(child.read)
        os.close(child.read)
        for kill in (os.killpg, os.kill):
            with suppress(ProcessLookupError, PermissionError):
                kill(child.pid, signal.SIGKILL)
        status = os.waitstatus_to_exitcode(os.waitpid(child.pid, 0)[1])
        if child.folder not in ("", self._folder):
            shutil.rmtree(child.folder, ignore_errors=True)
        return status

    def _go_on(self, child: _Child, status: int, done: Callable[[int, Verdict], None]) -> None:
        """Have what was noted judged, or tell the verdict."""
        _, _, sent = bytes(child.sent).partition(b"\n")
        if child.trace is None and status:
            done(
                child.number, _not_judged(child.task, "Its Python broke down before it had noted what the answer did.")
            )
        elif child.trace is None:
            self._start(child.number, child.task, sent.decode("utf-8", "replace"))
        else:
            done(child.number, self._verdict(child.task, sent))

    @staticmethod
    def _verdict(task: Task, sent: bytes) -> Verdict:
        try:
            found = Verdict(*json.loads(sent))
        except (ValueError, TypeError):
            found = _not_judged(task, "The process that judged it broke down.")
        shown = found.console[: max(_MOST_SAID - len(found.said), 0)]
        said = "\n".join(filter(None, [shown, found.said]))[:_MOST_SAID]
        return found._replace(said=said)


def _not_judged(task: Task, said: str) -> Verdict:
    return Verdict("not judged", False, f"Exercise {task.exercise}: not judged.", "", said)


# --- in a child -------------------------------------------------------------------------------------------------------


def _work(work: Callable[[], str], write: int, folder: str) -> NoReturn:
    """In a process that was forked for it: do the work, and send which seals it has, and what comes of it.

    Without a ``folder`` it is not sealed.
    """
    try:
        os.setsid()
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        nothing = os.open(os.devnull, os.O_RDWR)
        for number in range(3):
            os.dup2(nothing, number)
        os.dup2(write, _OWN_FD)
        os.closerange(_OWN_FD + 1, 4096)  # the other lanes' pipes among them
        seals = seal(folder) if folder else ()
        os.chdir(folder or "/")
        limit(TIME + 1)
        _send(" ".join(sorted(seals)) + "\n")
        _send(work())
    except BaseException:
        os._exit(1)
    os._exit(0)


def _send(text: str) -> None:
    data = text.encode()
    while data:
        try:
            data = data[os.write(_OWN_FD, data) :]
        except OSError as error:
            if error.errno != errno.EINTR:
                raise


def _trace(task: Task) -> str:
    """Run an answer in a Python as the page has it: with the standard library and ROS, and without other processes."""
    paths = {sysconfig.get_paths()[name] for name in ("stdlib", "platstdlib")}
    sys.path[:] = [path for path in sys.path if _is_python_s_own(path, paths)]
    sys.meta_path[:] = [finder for finder in sys.meta_path if "editable" not in repr(finder)]
    for name in [*sys.modules]:
        if name.partition(".")[0] not in _KNOWN:
            del sys.modules[name]
    refuse_processes()
    try:
        return exercises.trace(task.exercise, code(task.text))
    except ValueError:
        return ""  # there is no such exercise, which its judge says


def _is_python_s_own(path: str, paths: set[str]) -> bool:
    return path.endswith(".zip") or any(path == own or path == os.path.join(own, "lib-dynload") for own in paths)


def _judge(task: Task, trace: str) -> str:
    return json.dumps(exercises.verdict(task.exercise, code(task.text), trace))
