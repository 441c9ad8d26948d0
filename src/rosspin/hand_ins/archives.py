"""Find the files in folders and archives, as learning platforms export them. Nothing is unpacked onto the disk.

They are on the disk, or a browser has them.
"""

from __future__ import annotations

import errno
import io
import os
import re
import stat
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import IO, Any, NamedTuple, cast

from . import MOST_FILE
from .files import SUFFIXES

__all__ = ["ON_DISK", "ON_PAGE", "Bounds", "FoundFile", "find", "find_given"]

# So many archives within each other are read.
_DEEPEST = 4

# Of an archive among what was handed in, together with those within it, a tenth of what is read in all.
_OF_ONE = 10


class Bounds(NamedTuple):
    """What is read at most: entries of folders and archives, and bytes of answers, of packed archives, of lists."""

    entries: int
    answers: int
    unpacked: int
    listed: int


ON_DISK = Bounds(200_000, 400_000_000, 2_000_000_000, 20_000_000)
ON_PAGE = Bounds(20_000, 100_000_000, 1_000_000_000, 20_000_000)
"""A page's Python has less memory, in which an archive within another one is as a whole."""

# How entries may be packed: zipfile unpacks these, and no others, without making more of them than is asked for.
_PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)

_OTHER_ARCHIVES = (".7z", ".rar", ".tar", ".gz", ".tgz", ".bz2", ".xz")

# What systems and programs leave in folders: no one hands it in.
_LEFT_BEHIND = re.compile(r"\..*|__MACOSX|__pycache__|Thumbs\.db|desktop\.ini|node_modules", re.IGNORECASE)


class FoundFile(NamedTuple):
    """A file: the folders and archives that it is in and its name, below what was given; and what is in it.

    If it cannot be read, ``why`` says so.
    """

    parts: tuple[str, ...]
    data: bytes = b""
    why: str = ""

    @property
    def path(self) -> str:
        """All parts as one text."""
        return "/".join(self.parts)


class _Budget:
    """How much may still be read, and within which other budget."""

    def __init__(self, bounds: Bounds, above: _Budget | None = None) -> None:
        self.bounds = bounds
        self.left = {name: most // (_OF_ONE if above else 1) for name, most in bounds._asdict().items()}
        self._above = above

    def take(self, what: str, number: int) -> None:
        """Take so much. Raises :class:`_TooMuch` if there is less."""
        self.left[what] -= number
        if self.left[what] < 0:
            raise _TooMuch(self)
        if self._above:
            self._above.take(what, number)


class _TooMuch(Exception):
    """A budget is used up."""

    def __init__(self, budget: _Budget) -> None:
        self.budget = budget


class _Listed:
    """An archive whose list is read: no more of it than there may be. What is in it is read within other bounds."""

    def __init__(self, file: IO[bytes], budget: _Budget) -> None:
        self._file = file
        self.budget: _Budget | None = budget

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)

    def read(self, size: int = -1) -> bytes:
        if self.budget is None:
            return self._file.read(size)
        left = self.budget.left["listed"]
        data = self._file.read(left + 1 if size < 0 else min(size, left + 1))
        self.budget.take("listed", len(data))
        return data


def find(path: Path) -> Iterator[FoundFile]:
    """Yield the files in a folder or an archive, or a single file. Raises OSError if it is none of these."""
    return _within_bounds(path.name, _find(path, budget := _Budget(ON_DISK)), budget)


def find_given(name: str, files: Mapping[tuple[str, ...], IO[bytes]]) -> Iterator[FoundFile]:
    """Yield the files that a browser has: of a folder with this name, by their paths in it; or one, without a path."""
    return _within_bounds(name, _find_given(name, files, budget := _Budget(ON_PAGE)), budget)


def _within_bounds(name: str, files: Iterator[FoundFile], budget: _Budget) -> Iterator[FoundFile]:
    try:
        yield from files
    except _TooMuch:
        yield FoundFile((name,), why="there is too much in all; have it judged in parts")


def _find_given(name: str, files: Mapping[tuple[str, ...], IO[bytes]], budget: _Budget) -> Iterator[FoundFile]:
    for parts in sorted(files, key=_in_order):
        budget.take("entries", 1)
        try:
            if not parts:
                yield from _single(name, files[parts], budget)
            elif not any(map(_LEFT_BEHIND.fullmatch, parts)):
                yield from _opened(parts, files[parts], budget)
        except OSError as error:
            yield FoundFile(parts or (name,), why=f"it cannot be read: {error.strerror}")


def _in_order(parts: tuple[str, ...]) -> list[tuple[bool, str]]:
    """Return what paths are ordered by: in a folder files come first, as on the disk."""
    return [(place < len(parts), part) for place, part in enumerate(parts, 1)]


def _find(path: Path, budget: _Budget) -> Iterator[FoundFile]:
    if not path.is_dir():
        if path.exists() and not path.is_file():  # a pipe may never end
            raise OSError(errno.EINVAL, "it is no file, and no folder")
        with open(path, "rb") as file:
            yield from _single(path.name, file, budget)
        return
    waiting: list[tuple[str, ...]] = [()]
    while waiting:
        parts = waiting.pop()
        try:
            with os.scandir(Path(path, *parts)) as entries:
                folders, files = _sorted(entries, budget)
        except OSError as error:
            if not parts:
                raise
            yield FoundFile(parts, why=f"it cannot be read: {error.strerror}")
            continue
        for name in files:
            yield from _file(Path(path, *parts, name), (*parts, name), budget)
        waiting += ((*parts, name) for name in reversed(folders))


def _single(name: str, file: IO[bytes], budget: _Budget) -> Iterator[FoundFile]:
    data = file.read(MOST_FILE + 1)
    if name.lower().endswith(".zip") or data.startswith(b"PK\x03\x04"):
        file.seek(0)
        yield from _unzipped((), file, budget, 1, name)
    else:
        yield FoundFile((name,), data)


def _sorted(entries: Iterable[os.DirEntry[str]], budget: _Budget) -> tuple[list[str], list[str]]:
    """Return the folders among them, and the rest, links to folders included."""
    folders: list[str] = []
    files: list[str] = []
    for entry in entries:
        budget.take("entries", 1)
        if not _LEFT_BEHIND.fullmatch(entry.name):
            (folders if entry.is_dir(follow_symlinks=False) else files).append(entry.name)
    return sorted(folders), sorted(files)


def _file(place: Path, parts: tuple[str, ...], budget: _Budget) -> Iterator[FoundFile]:
    try:
        # A link may lead to the teacher's own files, and what is no file may never end.
        if not stat.S_ISREG(os.lstat(place).st_mode):
            yield FoundFile(parts, why="it is a link, or no file")
        else:
            with open(place, "rb") as file:
                yield from _opened(parts, file, budget)
    except OSError as error:
        yield FoundFile(parts, why=f"it cannot be read: {error.strerror}")


def _opened(parts: tuple[str, ...], file: IO[bytes], budget: _Budget) -> Iterator[FoundFile]:
    if parts[-1].lower().endswith(".zip"):
        yield from _handed_in(parts, file, budget, 1)
    else:
        yield _content(parts, file, budget)


def _content(parts: tuple[str, ...], file: IO[bytes], budget: _Budget) -> FoundFile:
    """Read what is of use: nothing of a film, and of no file more than is judged."""
    if not _holds_answers(parts[-1]):
        other = parts[-1].lower().endswith(_OTHER_ARCHIVES)
        return FoundFile(
            parts, why="unpack it first: of archives, zip is read" if other else "it is no file of answers"
        )
    data = file.read(MOST_FILE + 1)
    budget.take("answers", len(data))
    return FoundFile(parts, data)


def _handed_in(parts: tuple[str, ...], file: IO[bytes], above: _Budget, depth: int) -> Iterator[FoundFile]:
    """Yield the files in an archive that is one of several: whatever is in it, others are read as well."""
    budget = _Budget(above.bounds, above)
    try:
        yield from _unzipped(parts, file, budget, depth)
    except _TooMuch as error:
        if error.budget is not budget:
            raise
        yield FoundFile(parts, why="there is too much in it")


def _unzipped(
    parts: tuple[str, ...], file: IO[bytes], budget: _Budget, depth: int, name: str = ""
) -> Iterator[FoundFile]:
    """Yield the files in an archive, whose own ``name`` is no part of theirs, and in those within it."""
    try:
        listed = _Listed(file, budget)
        archive = zipfile.ZipFile(cast(IO[bytes], listed))
        listed.budget = None
        entries = sorted(archive.infolist(), key=_name)
    except (zipfile.BadZipFile, NotImplementedError, ValueError, OSError):
        yield FoundFile(parts or (name,), why="it is no zip archive that can be read")
        return
    budget.take("entries", len(entries))
    for entry in entries:
        # Only a name: whatever folders it goes up to, nothing is written there.
        inner = tuple(part for part in re.split(r"[/\\]", _name(entry)) if part not in ("", ".", ".."))
        if entry.is_dir() or not inner or any(map(_LEFT_BEHIND.fullmatch, inner)):
            continue
        place = (*parts, *inner)
        try:
            yield from _entry(archive, entry, place, budget, depth)
        except (zipfile.BadZipFile, zlib.error, NotImplementedError, EOFError, ValueError, OSError):
            yield FoundFile(place, why="it is damaged in its archive")


def _entry(
    archive: zipfile.ZipFile, entry: zipfile.ZipInfo, place: tuple[str, ...], budget: _Budget, depth: int
) -> Iterator[FoundFile]:
    if entry.flag_bits & 1:
        yield FoundFile(place, why="it is locked with a password")
    elif stat.S_ISLNK(entry.external_attr >> 16):
        yield FoundFile(place, why="it is a link, or no file")
    elif entry.compress_type not in _PACKED:
        yield FoundFile(place, why="it is packed in a way that is not read here; unpack the archive first")
    elif not place[-1].lower().endswith(".zip"):
        with archive.open(entry) as file:
            yield _content(place, file, budget)
    elif depth == _DEEPEST:
        yield FoundFile(place, why=f"it is an archive within {_DEEPEST} others")
    else:
        most = budget.bounds.unpacked // _OF_ONE
        with archive.open(entry) as file:
            data = file.read(most + 1)
        inner = _handed_in if depth == 1 else _unzipped
        if len(data) > most:
            yield FoundFile(place, why="there is too much in it")
        else:
            budget.take("unpacked", len(data))
            yield from inner(place, io.BytesIO(data), budget, depth + 1)


def _holds_answers(name: str) -> bool:
    return name.lower().endswith(SUFFIXES)


def _name(entry: zipfile.ZipInfo) -> str:
    """Return the name of an entry. Without the flag for UTF-8 it is in UTF-8 all the same, as macOS has it, or not."""
    if entry.flag_bits & 0x800:
        return entry.filename
    try:
        return entry.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return entry.filename
