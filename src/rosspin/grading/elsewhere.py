"""Judge answers in the processes of an executor, here or on other machines, each with a pool of its own."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import contextmanager
from importlib import import_module
from typing import NamedTuple

from ..exercises import Verdict
from .pool import LOOK, Pool, Task, not_judged

__all__ = ["Elsewhere", "executor_of"]


class _Judged(NamedTuple):
    """What became of a task, None if the process was asked to stop, and why answers are not sealed there."""

    verdict: Verdict | None
    why: str


class Elsewhere(Pool):
    """Judges tasks as :class:`Pool` does, in the processes of an executor."""

    def __init__(self, executor: Executor, unsealed: bool = False) -> None:
        """Look whether answers can be sealed there. Raises :class:`CannotSeal` as :class:`Pool` does."""
        self.stopped = False
        self._executor = executor
        self._unsealed = unsealed
        self.why = executor.submit(_try, unsealed).result()

    def judge(self, tasks: Iterable[Task], done: Callable[[int, Verdict], None]) -> None:
        """Judge tasks, as :meth:`Pool.judge` does."""
        waiting: dict[Future[_Judged], tuple[int, Task]] = {}
        with self.stopping():
            try:
                for number, task in enumerate(tasks):
                    waiting[self._executor.submit(_judge, task, self._unsealed)] = number, task
                while waiting and not self.stopped:
                    for future in wait(waiting, LOOK, FIRST_COMPLETED).done:
                        number, task = waiting.pop(future)
                        if verdict := self._verdict(future, task):
                            done(number, verdict)
            finally:
                for future in waiting:
                    future.cancel()

    def _verdict(self, future: Future[_Judged], task: Task) -> Verdict | None:
        try:
            judged = future.result()
        except Exception as error:  # whatever ends a process there, or the way to it
            return not_judged(task, f"{type(error).__name__}: {error}")
        self.why = self.why or judged.why
        return judged.verdict

    def close(self) -> None:
        """The pools end with the processes that they belong to."""


# --- in a process of the executor -------------------------------------------------------------------------------------

# A worker ends with the thread that has started it, so each thread has a pool of its own.
_own = threading.local()


def _pool(unsealed: bool) -> Pool:
    if not hasattr(_own, "pool"):
        _own.pool = Pool(unsealed)
    pool: Pool = _own.pool
    return pool


def _try(unsealed: bool) -> str:
    return _pool(unsealed).why


def _judge(task: Task, unsealed: bool) -> _Judged:
    found: list[Verdict] = []
    pool = _pool(unsealed)
    pool.judge([task], lambda number, verdict: found.append(verdict))
    return _Judged(found[0] if found else None, pool.why)


# --- of the command line ----------------------------------------------------------------------------------------------


@contextmanager
def executor_of(name: str) -> Iterator[Executor]:
    """What MODULE:NAME names, an executor or what makes one, for as long as it is needed.

    Raises ValueError if there is no such name, or if it is no executor.
    """
    module, colon, attribute = name.partition(":")
    if not (module and colon and attribute):
        raise ValueError(f"--workers {name}: write MODULE:NAME, as in concurrent.futures:ProcessPoolExecutor")
    sys.path.insert(0, "")  # a module in the working directory
    try:
        made = getattr(import_module(module), attribute)
        if not isinstance(made, Executor):
            made = made()
    except (ImportError, AttributeError, TypeError) as error:
        raise ValueError(f"--workers {name}: {error}") from error
    finally:
        sys.path.remove("")
    if not isinstance(made, Executor):
        raise ValueError(f"--workers {name}: this is no concurrent.futures.Executor, but {made!r}")
    with made:
        yield made
