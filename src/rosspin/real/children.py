"""Start processes in a temporary folder, collect their consoles, press Ctrl-C, and leave nothing of them behind."""

from __future__ import annotations

import math
import os
import re
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple, Self, TextIO

from ..clocks.ctrl_c import ROSLAUNCH, Ending
from ..results.folders import TemporaryFolder

__all__ = [
    "SITECUSTOMIZE",
    "START_PATIENCE",
    "Children",
    "Output",
    "check_seconds",
    "say_deaths",
    "shell_status",
]

# How long (s) a process may take to get going on a busy machine.
START_PATIENCE = 60.0

# The text of sitecustomize.py, which Python runs first if its folder is on PYTHONPATH. Unbuffered, print writes a line
# and its end apart, so that other processes or threads can write in between; on a terminal they cannot.
SITECUSTOMIZE = """import sys; sys.path.remove(__file__.rpartition("/")[0])
for stream in filter(None, (sys.stdout, sys.stderr)): stream.reconfigure(line_buffering=True, write_through=False)
"""


class Output(NamedTuple):
    """What a process did: console text, exit status as a shell has it; its start, and Ctrl-C (s since the epoch)."""

    console: str
    status: int
    start: float
    interrupt: float | None = None


class Children:
    """A temporary folder and the processes that were started in it. Leaving it ends them and removes it."""

    ending: Ending = ROSLAUNCH

    def __init__(self) -> None:
        self._temporary = TemporaryFolder()
        self.folder = self._temporary.path
        self._mark = f"ROS_HOME={self.folder}".encode()
        self._children: list[subprocess.Popen[bytes]] = []
        # A shell that starts something in the background has it ignore Ctrl-C, and our children would inherit that.
        self._deaf = (
            signal.getsignal(signal.SIGINT) is signal.SIG_IGN and threading.current_thread() is threading.main_thread()
        )
        if self._deaf:
            signal.signal(signal.SIGINT, signal.default_int_handler)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        try:
            for number in (signal.SIGINT, signal.SIGTERM):
                _signal_all(self._processes, number, 3.0)
        finally:
            _signal_all(self._processes, signal.SIGKILL, 5.0)
            for child in self._children:
                child.wait()
            self._temporary.remove()
            if self._deaf:
                signal.signal(signal.SIGINT, signal.SIG_IGN)

    @property
    def environment(self) -> dict[str, str]:
        """The environment of whatever runs here. ROS writes into the folder, whose name also marks our processes."""
        return {
            **os.environ,
            "ROS_HOME": str(self.folder),
            "ROS_LOG_DIR": str(self.folder / "log"),
            # Through a pipe Python would keep its lines back until it has many.
            "PYTHONUNBUFFERED": "1",
        }

    def run(
        self,
        command: Sequence[str],
        seconds: float | None,
        onward: TextIO | None = None,
        begins: re.Pattern[str] | None = None,
        ending: Ending | None = None,
        clean: Callable[[str], str] = str,
        more: Mapping[str, str] | None = None,
    ) -> Output:
        """Run a command until it ends or ``seconds`` are over, then end it: with Ctrl-C, and as ``ending`` says.

        The seconds count from the first line of the console that matches ``begins``, or else from the start. A real
        Ctrl-C ends the command in the same way; one that cuts ``seconds`` short is then raised in the caller.
        ``clean`` turns each line into what the console keeps of it; ``more`` is added to the environment.
        """
        ending = ending or self.ending
        process = self.start(command, subprocess.PIPE, subprocess.STDOUT, more)
        console = _Reader(process, onward, begins, ending, clean)
        interrupt = None
        try:
            if begins is not None and not console.begun.wait(START_PATIENCE):
                raise RuntimeError(f"{command[0]} did not start anything:\n{console.text()}")
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            interrupt = time.time()
            _end(process, ending)
        except KeyboardInterrupt:
            _end(process, ending)
            if seconds is not None:
                raise
        return Output(console.text(), shell_status(process.wait()), console.start, interrupt)

    def start(
        self, command: Sequence[str], stdout: int, stderr: int | None = None, more: Mapping[str, str] | None = None
    ) -> subprocess.Popen[bytes]:
        """Start a command and leave it alone."""
        # In a session of its own: a Ctrl-C on the terminal is ours to pass on.
        process = subprocess.Popen(
            command,
            env={**self.environment, **(more or {})},
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            start_new_session=True,
        )
        self._children.append(process)
        return process

    def _processes(self) -> Iterator[int]:
        """Find all processes that were started here, by whomever: roslaunch gives its nodes sessions of their own."""
        for entry in Path("/proc").glob("[0-9]*/environ"):
            try:
                if self._mark in entry.read_bytes().split(b"\0"):
                    yield int(entry.parent.name)
            except OSError:
                pass
        for child in self._children:
            child.poll()


class _Reader:
    """Collects what a process prints, and passes it on, in a thread."""

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        onward: TextIO | None,
        begins: re.Pattern[str] | None,
        ending: Ending,
        clean: Callable[[str], str],
    ) -> None:
        assert process.stdout is not None
        self.start = time.time()
        self.begun = threading.Event()
        self._process = process
        self._pipe = process.stdout
        self._onward = onward
        self._begins = begins
        self._ending = ending
        self._clean = clean
        self._lines: list[str] = []
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def text(self) -> str:
        """Return all that was printed so far. Waits a little for what is still on its way."""
        self._thread.join(1.0)
        return "".join(self._lines)

    def _read(self) -> None:
        with self._pipe:
            for raw in self._pipe:
                line = raw.decode(errors="replace")
                if self._begins is not None and not self.begun.is_set() and self._begins.search(line):
                    self.start = time.time()
                    self.begun.set()
                if line := self._clean(line):
                    self._lines.append(line)
                    if self._onward is not None:
                        self._pass_on(line)
        self.begun.set()  # nothing more can begin

    def _pass_on(self, line: str) -> None:
        assert self._onward is not None
        try:
            self._onward.write(line)
            self._onward.flush()
        except OSError:  # no one listens any more, as after `| head`
            self._onward = None
            threading.Thread(target=_end, args=(self._process, self._ending), daemon=True).start()


def _end(process: subprocess.Popen[bytes], ending: Ending) -> None:
    def ends_within(seconds: float) -> bool:
        with suppress(subprocess.TimeoutExpired):
            process.wait(seconds)
        return process.returncode is not None

    ending.carry_out(process.send_signal, ends_within)


def _signal_all(processes: Callable[[], Iterator[int]], number: signal.Signals, patience: float) -> None:
    """Send a signal to processes, if there are any, and give them ``patience`` seconds to end."""
    for pid in processes():
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass
    deadline = time.monotonic() + patience
    while any(processes()) and time.monotonic() < deadline:
        time.sleep(0.05)


def check_seconds(seconds: float | None) -> None:
    """Raise ValueError if a run cannot last so long."""
    if seconds is not None and not 0 <= seconds < math.inf:
        raise ValueError(f"seconds must be a number of at least 0, not {seconds!r}")


def say_deaths(deaths: Mapping[str, int], onward: TextIO | None) -> str:
    """Name the nodes that did not end with 0, in the last lines of a console; also write these to ``onward``."""
    words = "".join(f"rosspin: {name} ended with status {_named(status)}\n" for name, status in deaths.items())
    if onward is not None and words:
        onward.write(words)
    return words


def shell_status(code: int) -> int:
    """Return an exit status as a shell has it: 128 + number for a signal."""
    return 128 - code if code < 0 else code


def _named(status: int) -> str:
    return f"{status} ({signal.Signals(status - 128).name})" if 128 < status < 160 else str(status)
