"""Judge what students hand in, on a computer: what the page for teachers does, for a whole class in one go.

Hand-ins are found in folders and archives as learning platforms export them. Each answer runs in a process of its own,
and is judged by the notes of its runs in another one, in which nothing of it has run.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from collections.abc import Sequence
from concurrent.futures import Executor
from pathlib import Path

from ..exercises import Verdict
from ..hand_ins.reports import as_csv, as_data, as_words, say_python, say_unsealed, write_csv
from ..hand_ins.students import Class
from ..results.saving import save_whole
from .elsewhere import Elsewhere
from .pool import Pool, Task
from .sealed import CannotSeal

__all__ = ["judge"]

_REMEDY = (
    "Each would run with all of your rights. Where there is nothing to lose, as in a container with a single student's "
    "answers, or where the answers are your own, add --unsealed"
)

_STOPPED = Verdict("stopped", False, "", "", "It was stopped before it was judged.")


def judge(
    paths: Sequence[str],
    csv: str | None = None,
    as_json: bool = False,
    unsealed: bool = False,
    executor: Executor | None = None,
) -> int:
    """Judge what was handed in, and say what came of it. Returns the exit status.

    Where answers cannot be sealed, nothing is judged unless it may be ``unsealed``. The processes of an ``executor``
    judge the answers, if there is one, else as many on this machine as it has processors. The verdicts are the same.
    """
    hand_ins, reading = Class(), _Reading()
    try:
        for path in paths:
            hand_ins.add(Path(path), reading.step)
    except OSError as error:
        return _misused(f"{path}: {error.strerror}")
    finally:
        reading.end()
    if csv and (Path(csv).is_dir() or not Path(csv).parent.is_dir()):
        return _misused(f"--csv {csv}: this is a folder, or there is no such folder")
    places = [(row, name) for row in hand_ins.rows for name in row.answers]
    for row, name in places:
        row.verdicts[name] = _STOPPED
    try:
        pool = Elsewhere(executor, unsealed) if executor else Pool(unsealed)
    except CannotSeal as error:
        return _misused(f"answers cannot be sealed here: {str(error).rstrip('.')}. {_REMEDY}")
    progress = _Progress(len(places))
    for said in (*hand_ins.notes, *(f"{file} is refused: {why}." for file, why in hand_ins.refused)):
        print(said, file=sys.stderr)

    def done(number: int, verdict: Verdict) -> None:
        row, name = places[number]
        row.verdicts[name] = verdict
        progress.step()

    try:
        pool.judge((Task(name, row.answers[name]) for row, name in places), done)
    finally:
        pool.close()
        progress.end()
    hand_ins.why_unsealed = pool.why
    for said in (say_unsealed(hand_ins), say_python(hand_ins)):
        if said:
            print(said, file=sys.stderr)
    status = 0
    if csv:
        try:
            save_whole(csv, write_csv(as_csv(hand_ins)))
        except OSError as error:
            status = _misused(f"--csv {csv}: {error.strerror}")
    _print(hand_ins, as_json)
    if pool.stopped:
        return 128 + signal.SIGINT
    if not hand_ins.rows:
        print("No hand-in was found.", file=sys.stderr)
    is_right = bool(places) and all(verdict.solved for row in hand_ins.rows for verdict in row.verdicts.values())
    return status or (0 if is_right and all(row.answers for row in hand_ins.rows) else 1)


def _print(hand_ins: Class, as_json: bool) -> None:
    if as_json:
        print(json.dumps(as_data(hand_ins), indent=1))
        return
    # A terminal that lacks a character is shown something else; and no one's text moves its cursor.
    encoding = sys.stdout.encoding or "utf-8"
    for line in as_words(hand_ins):
        shown = "".join(each if each.isprintable() else "\N{REPLACEMENT CHARACTER}" for each in line.expandtabs())
        print(shown.encode(encoding, "replace").decode(encoding))


def _misused(said: str) -> int:
    print(f"rosspin: {said}", file=sys.stderr)
    return 2


class _Reading:
    """A line on the terminal that says how many files have been found; elsewhere nothing."""

    def __init__(self) -> None:
        self._number = 0

    def step(self) -> None:
        self._number += 1
        if self._number % 100 == 0 and sys.stderr.isatty():
            print(f"\r{self._number} files", end="\033[K", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._number >= 100 and sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


class _Progress:
    """A line on the terminal that says how far it is; elsewhere nothing."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._done = 0
        self._began = time.monotonic()
        self._shown = sys.stderr.isatty()

    def step(self) -> None:
        self._done += 1
        if not self._shown:
            return
        part = self._done / self._number
        left = (time.monotonic() - self._began) * (1 - part) / part
        bar = ("#" * round(20 * part)).ljust(20, ".")
        said = f"\r[{bar}] {self._done} of {self._number} answers, {left:.0f} s left "
        columns = os.get_terminal_size(sys.stderr.fileno()).columns or 80  # some say that they have none
        print(said[:columns], end="\033[K", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
