"""Tell what came of it: in words, as a table for spreadsheets, and as JSON."""

from __future__ import annotations

import re
import sys
import unicodedata
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from ..exercises import EXERCISES
from .students import Class, Row

__all__ = ["as_csv", "as_data", "as_words", "hard", "say_python", "say_unsealed", "write_csv"]

# The Python of the page. A newer one reads texts that an older one does not.
PAGE_PYTHON = (3, 14)

# Where a cell may begin with the sign of a formula: at its start, or after a separator in the middle, since a
# spreadsheet may separate by another one. What is white, quoted or not seen may come before the sign.
_SIGNS = "=＝﹦⁼₌+＋﹢⁺₊-－﹣−⁻₋@＠﹫"
_SEPARATORS = ",;|；，"
_UNSEEN = "\u034f\u115f\u1160\u17b4\u17b5\u180b\u180c\u180d\u180f\u3164\uffa0"  # and of category C or Z, and selectors


class Hard(NamedTuple):
    """An exercise: how many have answered it, and solved it, and what those who did not were told, by how many."""

    exercise: str
    title: str
    answered: int
    solved: int
    hints: tuple[tuple[str, int], ...]


def hard(hand_ins: Class) -> list[Hard]:
    """Return the exercises that someone answered and has not solved, the hardest first."""
    titles = {exercise.name: exercise.title for exercise in EXERCISES}
    counted = []
    for name in hand_ins.exercises:
        verdicts = [row.verdicts[name] for row in hand_ins.rows if name in row.verdicts]
        solved = sum(verdict.solved for verdict in verdicts)
        hints = Counter(verdict.hint for verdict in verdicts if verdict.hint)
        counted.append(Hard(name, titles.get(name, ""), len(verdicts), solved, tuple(hints.most_common())))
    missed = [each for each in counted if each.solved < each.answered]
    return sorted(missed, key=lambda each: each.solved / each.answered)


def as_words(hand_ins: Class) -> Iterator[str]:
    """Yield the lines for a terminal: of a single student all that was said, of more a line for each."""
    if hand_ins.why_unsealed:
        yield say_unsealed(hand_ins)
    if len(hand_ins.rows) == 1:
        [row] = hand_ins.rows
        for name, verdict in row.verdicts.items():
            yield f"{name}: {verdict.verdict}"
            yield from (f"  {line}" for line in verdict.said.splitlines())
    for row in hand_ins.rows:
        yield f"{_line(row)}{'; NOT sealed' if hand_ins.why_unsealed else ''}"
    yield from _closest(hand_ins)
    if len(hand_ins.rows) > 1 and (missed := hard(hand_ins)):
        yield "What was hard:"
        for name, _, answered, solved, hints in missed:
            yield f"  {name}: {solved} of {answered} solved"
            yield from (f"    {count} × {hint}" for hint, count in hints[:3])


def _closest(hand_ins: Class) -> Iterator[str]:
    """Compare the vehicles of those who have solved an exercise, the one that stayed closest to its line first."""
    for name in hand_ins.exercises:
        solved = [row for row in hand_ins.rows if name in row.verdicts and row.verdicts[name].solved]
        drives = sorted((off, row.name) for row in solved if (off := row.off(name)) is not None)
        if len(drives) > 1:
            yield f"{name}, largest deviation: {', '.join(f'{off:g} m ({who})' for off, who in drives)}"


def _line(row: Row) -> str:
    by_verdict: dict[str, list[str]] = {}
    for name, verdict in row.verdicts.items():
        by_verdict.setdefault(verdict.verdict, []).append(name)
    by_verdict.pop("solved", None)
    rest = "".join(f"; {verdict}: {', '.join(names)}" for verdict, names in by_verdict.items())
    late = " (late)" if row.late else ""
    if not row.answers:
        return f"{row.name}{late}: no answer{f'; {row.note}' if row.note else ''}"
    return f"{row.name}{late}: {row.solved} of {len(row.answers)} solved{rest}{f'; {row.note}' if row.note else ''}"


def as_csv(hand_ins: Class) -> list[list[str | int]]:
    """Return the table: a row for each student, a column for each exercise, and then one for each reason."""
    names = hand_ins.exercises
    driven = [name for name in names if any(row.off(name) is not None for row in hand_ins.rows)]
    head = ["name", "student ID", "sent by", "sender ID", "late", "file", "note", "date"]
    head += ["same browser as", "same name in another browser", "sealed", "answers", "solved"]
    rows: list[list[str | int]] = [
        [*head, *names, *(f"{name}: why" for name in names), *(f"{name}: off (m)" for name in driven)]
    ]
    for row, others, namesakes in hand_ins.beside():
        verdicts = [row.verdicts.get(name) for name in names]
        sent = [row.sender, row.sender_id, "late" if row.late else ""]
        about = [row.name, row.student, *sent, row.file, row.note, row.when, ", ".join(others), ", ".join(namesakes)]
        about.append("NO" if hand_ins.why_unsealed else "yes")
        said = [each.verdict if each else "" for each in verdicts]
        said += [each.why if each else "" for each in verdicts]
        offs = ("" if (off := row.off(name)) is None else f"{off:g}" for name in driven)
        rows.append([*about, len(row.answers), row.solved, *said, *offs])
    noted = {row.file for row in hand_ins.rows if row.note}
    rows += [["", "", "", "", "", file, f"refused: {why}"] for file, why in hand_ins.refused if file not in noted]
    return [[*row, *[""] * (len(rows[0]) - len(row))] for row in rows]


def write_csv(rows: Iterable[Sequence[str | int]]) -> bytes:
    """Write rows as spreadsheets read them. No cell is a formula, nor any part of one."""
    # With a byte order mark, without which Excel reads no UTF-8.
    return "".join(f"{','.join(map(_field, row))}\r\n" for row in rows).encode("utf-8-sig", "replace")


def _field(value: str | int) -> str:
    line = re.sub(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]+", " ", str(value))
    guarded, at_start = [], True
    for each in line:
        if at_start and each in _SIGNS:
            guarded.append("'")
        at_start = each in _SEPARATORS or (at_start and (each == '"' or _is_unseen(each)))
        guarded.append(each)
    return '"' + "".join(guarded).replace('"', '""') + '"'


def _is_unseen(letter: str) -> bool:
    is_selector = "\ufe00" <= letter <= "\ufe0f" or "\U000e0100" <= letter <= "\U000e01ef"
    return letter in _UNSEEN or is_selector or unicodedata.category(letter)[0] in "CZ"


def as_data(hand_ins: Class) -> dict[str, Any]:
    """Return all that is known, for JSON."""
    return {
        "sealed": not hand_ins.why_unsealed,
        "warning": say_unsealed(hand_ins),
        "students": [
            {
                "sealed": not hand_ins.why_unsealed,
                "name": row.name,
                "student": row.student,
                "sender": row.sender,
                "sender_id": row.sender_id,
                "late": row.late,
                "file": row.file,
                "note": row.note,
                "date": row.date.isoformat() if row.date else None,
                "solved": row.solved,
                "answers": {
                    name: {key: verdict._asdict()[key] for key in ("verdict", "solved", "why", "hint", "off", "said")}
                    for name, verdict in row.verdicts.items()
                },
            }
            for row in hand_ins.rows
        ],
        "refused": [{"file": file, "why": why} for file, why in hand_ins.refused],
        "notes": hand_ins.notes,
        "hard": [each._asdict() | {"hints": dict(each.hints)} for each in hard(hand_ins)],
    }


def say_unsealed(hand_ins: Class) -> str:
    """Say that the answers were not sealed; nothing if they were."""
    if not hand_ins.why_unsealed:
        return ""
    why = hand_ins.why_unsealed[0].upper() + hand_ins.why_unsealed[1:]
    return f"The answers were NOT sealed: each ran with all of your rights. ({why}.)"


def say_python(hand_ins: Class) -> str:
    """Say so if answers were no Python to this one, and could be to the page's."""
    if sys.version_info >= PAGE_PYTHON:
        return ""
    count = sum(" is not Python: " in verdict.why for row in hand_ins.rows for verdict in row.verdicts.values())
    if not count:
        return ""
    mine, page = (".".join(map(str, version)) for version in (sys.version_info[:2], PAGE_PYTHON))
    answers = f"{count} answer{' is' if count == 1 else 's are'}"
    return f"{answers} no Python to this Python {mine}; the page's is {page}, and newer ones read more."
