"""The table of the page for teachers: what is read there, and what is told of it. The page has the answers judged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import count
from typing import IO, Any

from ..exercises import Verdict
from . import MOST_ANSWER, too_long
from .archives import find_given
from .reports import as_csv, hard, write_csv
from .students import Class, Room, Row

__all__ = ["ROOM", "Table"]

ROOM = Room(1000, 10_000, 100)

# So many sentences are listed on what was refused or left out.
_MOST_PROBLEMS = 50

# And so many hints of those that were given most often.
_MOST_HINTS = 3


class Table:
    """All that was given to the page. A row has a number there, another one when another file takes its place."""

    def __init__(self) -> None:
        self._class = Class(ROOM)
        self._numbers = count()
        self._rows: dict[int, Row] = {}
        self._problems: list[str] = []

    def read(self, files: Iterable[tuple[str, IO[bytes]]]) -> dict[str, Any]:
        """Read files, each by its path: those with folders were given together. Return the whole table."""
        given: dict[str, dict[tuple[str, ...], IO[bytes]]] = {}
        alone: list[tuple[str, IO[bytes]]] = []
        for path, file in files:
            folder, *parts = path.split("/")
            if parts:
                given.setdefault(folder, {})[tuple(parts)] = file
            else:
                alone.append((folder, file))
        refused, notes = self._class.number_refused, len(self._class.notes)
        for name, file in alone:
            self._class.take([*find_given(name, {(): file})], name.removesuffix(".zip"), name)
        for name, entries in given.items():
            self._class.take([*find_given(name, entries)], name, name)
        self._problems += self._class.notes[notes:]
        self._problems += [f"{file} is refused: {why}." for file, why in self._class.refused[refused:]]
        return self._shown()

    def _shown(self) -> dict[str, Any]:
        names = self._class.exercises
        known = {id(row): number for number, row in self._rows.items()}
        beside = self._class.beside()
        numbers = [known[id(row)] if id(row) in known else next(self._numbers) for row, *_ in beside]
        self._rows = {number: row for number, (row, *_) in zip(numbers, beside, strict=True)}
        return {
            "exercises": names,
            "rows": [
                {
                    **{"number": number, "name": row.name, "student": row.student, "file": row.file},
                    **{"date": row.when, "note": row.note, "late": row.late, "others": others, "namesakes": same},
                    "answers": [names.index(name) for name in row.answers],
                }
                for number, (row, others, same) in zip(numbers, beside, strict=True)
            ],
            "problems": self._problems[:_MOST_PROBLEMS],
            "unlisted": max(len(self._problems) - _MOST_PROBLEMS, 0),
            "refused": self._class.number_refused,
        }

    def answer(self, number: int, exercise: str) -> dict[str, str]:
        """Return the text of an answer; and why it cannot be judged, if it cannot. Both are empty if it is gone."""
        row = self._rows.get(number)
        text = row.answers[exercise] if row else ""
        return {"text": text[:MOST_ANSWER], "why": too_long(text)}

    def report(self, verdicts: Sequence[Sequence[Any]]) -> dict[str, Any]:
        """Tell what came of all: by row and exercise the verdict, the reason, the hint, and ``off``."""
        for number, exercise, verdict, *more in verdicts:
            self._rows[number].verdicts[exercise] = Verdict(verdict, verdict == "solved", "", "", "", *more)
        missed = [[each.exercise, each.answered, each.solved, each.hints[:_MOST_HINTS]] for each in hard(self._class)]
        return {"csv": write_csv(as_csv(self._class)).decode(), "hard": missed}
