"""What runs next to the process of a worker for answers in C++: a compiler and a Node.js, in the worker's own sandbox.

Neither knows an answer before it is asked to compile or to run it. To the compiler, and to the program that it makes,
there are no files but those that they are given: their world is WebAssembly's.
"""

from __future__ import annotations

import os
import resource
import subprocess
from contextlib import ExitStack, suppress
from fcntl import F_DUPFD_CLOEXEC, fcntl
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..cpp import building, nodejs

__all__ = ["Programs"]

# At most (bytes, or their number): what is in memory and can be written to, a file, open files. To reserve addresses
# is part of how WebAssembly keeps a program to its memory, and has no limit here.
_LIMITS = {
    resource.RLIMIT_DATA: 4 << 30,
    resource.RLIMIT_FSIZE: 10 << 20,
    resource.RLIMIT_NOFILE: 64,
    resource.RLIMIT_CORE: 0,
}

_LEAST = 10  # the least number of a file that a child keeps


class Programs:
    """Both, as soon as they are needed. ``node`` is where Node.js is."""

    def __init__(self, node: str) -> None:
        building.NODE = node
        self._lent: list[_Lent] = []

    def start(self) -> None:
        """Start what does not run yet; to be called by the worker, before it forks a child that uses them."""
        if not self._lent:
            for ros in building.ROSES:
                building.stand_in(ros)  # which each child would do again
            self._lent = [_Lent(command) for command in (building.compile_command(), nodejs.run_command())]

    def end(self) -> None:
        """End both: it is not known what a child that did not end well has left them in."""
        while self._lent:
            self._lent.pop().end()

    @property
    def computes(self) -> bool:
        """Whether one of them still computes what no one waits for."""
        return any(each.computes for each in self._lent)

    @property
    def files(self) -> list[int]:
        """The numbers of the files by which a child talks with them."""
        return [file for each in self._lent for file in (each.stdin.fileno(), each.stdout.fileno())]

    def used(self) -> ExitStack:
        """Within this context, a child uses them; what it compiles is for no other one."""
        stack = ExitStack()
        kept = stack.enter_context(TemporaryDirectory(dir="."))
        building.keep_programs_in(Path(kept).absolute())
        for lent, idle in zip(self._lent, (building.IDLE, nodejs.IDLE), strict=False):
            idle[:] = [lent]
            lent.back = partial(idle.append, lent)
        return stack


class _Lent:
    """A process of the worker, as its child knows it, who can neither end it nor start another."""

    def __init__(self, command: list[str]) -> None:
        self._process = subprocess.Popen(
            command,
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={},
            preexec_fn=_limit,
        )
        assert self._process.stdin and self._process.stdout
        self.pid = self._process.pid
        self.stdin = os.fdopen(fcntl(self._process.stdin, F_DUPFD_CLOEXEC, _LEAST), "wb", buffering=0)
        self.stdout = os.fdopen(fcntl(self._process.stdout, F_DUPFD_CLOEXEC, _LEAST), "rb", buffering=0)
        self._process.stdin.close()
        self._process.stdout.close()
        self.back: Any = lambda: None
        self.computes = False

    def end(self) -> None:
        self._process.kill()
        self._process.wait()
        self.stdin.close()
        self.stdout.close()

    def poll(self) -> int | None:
        return None

    def kill(self) -> None:
        if not self.computes:
            self.back()  # it gives up what it waits for when it is asked for something else

    def send_signal(self, number: int) -> None:
        self.computes = True  # until the worker ends it

    def __enter__(self) -> _Lent:
        return self

    def __exit__(self, *error: object) -> None:
        pass


def _limit() -> None:
    for kind, most in _LIMITS.items():
        _, hard = resource.getrlimit(kind)
        with suppress(ValueError, OSError):
            resource.setrlimit(kind, (min(most, hard) if hard >= 0 else most,) * 2)
