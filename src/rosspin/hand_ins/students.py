"""Who has handed in what: a row for each student, of whose files the newest counts."""

from __future__ import annotations

import os
import re
import unicodedata
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from ..exercises import EXERCISES, Verdict
from .archives import FoundFile, find
from .files import MOST_PLAIN, HandIn, Refused, plain, read

__all__ = ["Class", "Room", "Row"]

# How learning platforms name what they export. Moodle: a folder, or the start of a file's name, for each student.
_MOODLE = re.compile(r"(?P<name>.+?)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)_?(?P<rest>.*)")
# Canvas: the start of a file's name.
_CANVAS = re.compile(r"(?P<name>[^_]+)(?P<late>_LATE)?_(?P<id>\d+)_\d+_(?P<rest>.+)")
# Gradescope: a folder.
_GRADESCOPE = re.compile(r"(?P<name>submission_(?P<id>\d+))(?P<rest>)")


# So many files are named that are refused; and of the names next to a row, so many.
_MOST_REFUSED = 500
_MOST_NAMES = 5


class Room(NamedTuple):
    """What a table has room for."""

    rows: int
    answers: int
    exercises: int

    def __str__(self) -> str:
        return f"room for {self.rows} files, {self.answers} answers and {self.exercises} exercises"


@dataclass
class Row:
    """What one student has handed in.

    ``name``, ``student`` ID, ``browser`` and ``date`` are the file's own words; ``sender`` is who sent it, as the
    learning platform says, by its name and its ID there, and ``late`` that it came late.
    """

    name: str
    file: str
    student: str = ""
    sender: str = ""
    sender_id: str = ""
    late: bool = False
    browser: str = ""
    date: datetime | None = None
    note: str = ""
    answers: dict[str, str] = field(default_factory=dict)
    verdicts: dict[str, Verdict] = field(default_factory=dict)

    @property
    def when(self) -> str:
        """The date in words, where it is read; empty if it is not known."""
        return f"{self.date:%Y-%m-%d %H:%M}" if self.date else ""

    @property
    def solved(self) -> int:
        """How many answers are right."""
        return sum(verdict.solved for verdict in self.verdicts.values())

    def off(self, exercise: str) -> float | None:
        """How far (m) the vehicle came off its line; None if there is no verdict, or no vehicle."""
        verdict = self.verdicts.get(exercise)
        return verdict.off if verdict else None


class _Student(NamedTuple):
    """Whose a file is, by the names of its folders and of itself: whoever ``sent`` it, or the folder that it is in.

    ``rest`` is what the student called the file, ``version`` how often it was handed in before.
    """

    name: str
    id: str = ""
    sent: bool = False
    late: bool = False
    rest: str = ""
    version: int = 0

    @property
    def person(self) -> _Student:
        """Who the student is: equal for all files of one student."""
        return _Student(self.name, self.id, self.sent)

    @property
    def key(self) -> tuple[str, ...]:
        """What identifies a student's row in the table."""
        return ("sent" if self.sent else "folder", self.name, self.id)

    @property
    def sender(self) -> str:
        """The name by which the learning platform knows the student."""
        return plain(self.name) if self.sent else ""


# What is said of a file for which there is no room.
_FULL = "this table has {room}; rosspin judge, on your computer, takes more"

_Part = tuple[FoundFile, _Student, HandIn]


class Class:
    """All that was handed in: ``rows``, the files that were ``refused``, with the reasons, and ``notes`` on others.

    ``why_unsealed`` says why the answers were not sealed when they were judged; it is empty if they were.
    """

    def __init__(self, room: Room | None = None) -> None:
        self._room = room
        self.why_unsealed = ""
        self.number_refused = 0
        self.refused: list[tuple[str, str]] = []
        self.notes: list[str] = []
        self._rows: dict[tuple[str, ...], Row] = {}

    @property
    def rows(self) -> list[Row]:
        """The rows in the order of their names, numbers in these by their size."""
        return sorted(self._rows.values(), key=lambda row: (_by_size(row.name), _by_size(row.file)))

    @property
    def exercises(self) -> list[str]:
        """Return the exercises that someone has answered, in the order of the pages."""
        answered = {name for row in self._rows.values() for name in row.answers}
        known = [exercise.name for exercise in EXERCISES if exercise.name in answered]
        return [*known, *sorted(answered.difference(known))]

    def add(self, path: Path, step: Callable[[], None] = lambda: None) -> None:
        """Read a file, a folder or an archive. Raises OSError if there is none such. ``step`` is called for each."""
        files = []
        for each in find(path):
            files.append(each)
            step()
        self.take(files, _name_of(path), str(path))

    def take(self, files: Sequence[FoundFile], name: str, place: str) -> None:
        """Take what was found in one ``place``. Whose it is if nothing else says it, says its ``name``."""
        skipped = len(os.path.commonprefix([file.parts[:-1] for file in files]))
        top = _folder(files[0].parts[0]) if skipped else name
        loose: dict[_Student, list[_Part]] = {}
        left: list[tuple[_Student, FoundFile, str]] = []
        having: set[_Student] = set()
        for file in files:
            folder = _folder(file.parts[skipped]) if len(file.parts) > skipped + 1 else top
            student = _sender(file.parts) or _Student(folder)
            try:
                if file.why:
                    raise Refused(file.why)
                hand_in = read(student.rest or file.parts[-1], file.data)
            except Refused as refused:
                left.append((student.person, file, str(refused)))
                continue
            if student.sent or student.name != top or not hand_in.name:
                having.add(student.person)
            if hand_in.name:
                key = student.key if student.sent else ("", hand_in.name, hand_in.id)
                sent = student.sender, student.id, student.late
                row = Row(hand_in.name, plain(file.path), hand_in.student, *sent, hand_in.id, hand_in.date)
                row.answers = dict(hand_in.answers)
                self._take(row, key)
            else:
                loose.setdefault(student.person, []).append((file, student, hand_in))
        for student, parts in loose.items():
            self._take_loose(student, parts, place)
        for student, file, why in left:
            self._leave(student, file, why, having, "" if student.sent else top)

    def _take(self, row: Row, key: tuple[str, ...]) -> None:
        """Of one student's files the newest counts; of two without a date, the later one."""
        before = self._rows.get(key)
        if before and before.date and (row.date is None or before.date > row.date):
            self.notes.append(f"{row.file} is left out: {row.name} handed in {before.file} after it.")
            return
        if not self._has_room(key, row.answers):
            return self._refuse(row.file, _FULL.format(room=self._room))
        if before:
            said = f"{row.file} takes the place of {before.file}, which {before.name} handed in before."
            self.notes.append(said)
        self._rows[key] = row

    def _has_room(self, key: tuple[str, ...], answers: Collection[str]) -> bool:
        if not self._room:
            return True
        others = [row.answers for other, row in self._rows.items() if other != key]
        used = len(others) + 1, sum(map(len, others)) + len(answers), len({*answers}.union(*others))
        return all(number <= most for number, most in zip(used, self._room, strict=True))

    def _take_loose(self, student: _Student, parts: Sequence[_Part], place: str) -> None:
        """Make one hand-in of the node files and notebooks of one student."""
        parts = sorted(parts, key=lambda part: (part[1].version, _by_size(part[0].path)))
        row = Row(plain(student.name) or "(no name)", plain(parts[0][0].path), "", student.sender, student.id)
        row.late = any(each.late for _, each, _ in parts)
        came: dict[str, str] = {}
        for file, _, hand_in in parts:
            for exercise, text in hand_in.answers.items():
                if exercise in came:
                    said = f"{plain(came[exercise])} is left out: {plain(file.path)} answers {exercise} after it."
                    self.notes.append(said)
                came[exercise], row.answers[exercise] = file.path, text
        if len(parts) > 1:
            row.file += f" and {len(parts) - 1} more"
        key = student.key if student.sent else (*student.key, place)
        if before := self._rows.get(key):
            # The file that the site saved has the last word.
            row = replace(before, answers=row.answers | before.answers)
            if self._has_room(key, row.answers):
                self._rows[key] = row
            else:
                self._refuse(parts[0][0].path, _FULL.format(room=self._room))
        else:
            self._take(row, key)

    def _refuse(self, file: str, why: str) -> None:
        """Say it, unless that has been said of so many that no one would read it."""
        self.number_refused += 1
        if self.number_refused <= _MOST_REFUSED:
            self.refused.append((file, why))
        else:
            more = self.number_refused - _MOST_REFUSED
            self.refused[_MOST_REFUSED:] = [("...", f"{more} more files, for such reasons")]

    def _leave(self, student: _Student, file: FoundFile, why: str, having: Collection[_Student], top: str) -> None:
        """Refuse what holds no answers. Whatever else lies next to someone's answers does not matter."""
        name = file.parts[-1]
        if student in having and not (name.startswith("rosspin-answers") or name.endswith(".zip")):
            return
        self._refuse(plain(file.path), why)
        if student not in having and student.name != top and _Student(top) not in having:
            # A student is missed in the table, whatever was handed in. What lies among answers is no student's folder.
            row = Row(plain(student.name), plain(file.path), "", student.sender, student.id, note=f"refused: {why}")
            if self._has_room(student.key, ()):
                self._rows.setdefault(student.key, row)

    def beside(self) -> list[tuple[Row, list[str], list[str]]]:
        """Return the rows, each with some other names from the same browser, and files of the same name from others."""
        rows = self.rows
        in_browser, of_name = defaultdict[str, list[Row]](list), defaultdict[str, list[Row]](list)
        for row in rows:
            if row.browser:
                in_browser[row.browser].append(row)
                of_name[row.name].append(row)
        return [
            (
                row,
                _few(each.name for each in in_browser.get(row.browser, ()) if each.name != row.name),
                _few(each.file for each in of_name.get(row.name, ()) if row.browser not in ("", each.browser)),
            )
            for row in rows
        ]


def _few(names: Iterable[str]) -> list[str]:
    found = [*names]
    more = len(found) - _MOST_NAMES
    return [*found[:_MOST_NAMES], f"{more} more"] if more > 0 else found


def _sender(parts: Sequence[str]) -> _Student | None:
    """Find out from the names of its folders, and from its own, who sent a file; None if they do not say it."""
    for part in parts:
        is_last, folder = part is parts[-1], _folder(part)
        if match := _MOODLE.fullmatch(folder) or _GRADESCOPE.fullmatch(folder):
            return _Student(match["name"], match["id"], sent=True, rest=match["rest"] if is_last else "")
        # Canvas has no folders, whose names could be anything.
        if (is_last or folder != part) and (match := _CANVAS.fullmatch(folder)):
            version = re.search(r"-(\d+)\.\w+$", part)
            number, rest = int(version[1]) if version else 0, match["rest"] if is_last else ""
            return _Student(match["name"], match["id"], True, bool(match["late"]), rest, number)
    return None


def _folder(part: str) -> str:
    """Return the name of a folder, or of an archive that stands for one."""
    return part[:-4] if part.lower().endswith(".zip") else part


def _name_of(path: Path) -> str:
    """Whose files these are if nothing else says it: the folder's, or that in which the file is."""
    place = path.resolve()
    return place.name if place.is_dir() else place.stem if place.suffix == ".zip" else place.parent.name


def _unmarked(letter: str) -> str:
    found = re.fullmatch(r"LATIN (?:SMALL|CAPITAL) LETTER (.) WITH .+", unicodedata.name(letter, ""))
    return found[1] if found else letter


def _by_size(text: str) -> list[tuple[int, str]]:
    """Return what texts are ordered by: numbers by their size, and letters as those without their marks."""
    text = text[:MOST_PLAIN]
    words = re.findall(r"\d+|\D+", "".join(map(_unmarked, unicodedata.normalize("NFC", text))).casefold())
    return [(int(word), "") if word.isdecimal() and len(word) < 20 else (-1, word) for word in words]
