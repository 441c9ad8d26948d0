"""Find the files in folders and archives, as learning platforms export them. Nothing is unpacked onto the disk."""

from __future__ import annotations

import errno
import io
import os
import re
import stat
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import IO, NamedTuple

from .hand_ins import MOST_FILE, SUFFIXES

__all__ = ["Found", "find"]

# What is read of archives at most: so many within each other, files in all, and bytes.
_DEEPEST = 4
_MOST_FILES = 50_000
_MOST_BYTES = 400_000_000

# How entries may be packed: zipfile unpacks these, and no others, without making more of them than is asked for.
_PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)

_OTHER_ARCHIVES = (".7z", ".rar", ".tar", ".gz", ".tgz", ".bz2", ".xz")

# What systems and programs leave in folders: nobody hands it in.
_LEFT_BEHIND = re.compile(r"\..*|__MACOSX|__pycache__|Thumbs\.db|desktop\.ini|node_modules", re.IGNORECASE)


class Found(NamedTuple):
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
    """How much may still be read."""

    def __init__(self) -> None:
        self.files = _MOST_FILES
        self.bytes = _MOST_BYTES


def find(path: Path) -> Iterator[Found]:
    """Yield the files in a folder or an archive, or a single file. Raises OSError if it is none of these."""
    if not path.is_dir():
        parts = (path.name,)
        if path.exists() and not path.is_file():  # a pipe may never end
            raise OSError(errno.EINVAL, "it is no file, and no folder")
        with open(path, "rb") as file:
            data = file.read(MOST_FILE + 1)
            if path.suffix.lower() == ".zip" or data.startswith(b"PK\x03\x04"):
                file.seek(0)
                yield from _unzipped((), file, _Budget(), 1, path.name)
                return
        yield Found(parts, data)
        return
    budget = _Budget()
    for folder, folders, files in os.walk(path):
        folders[:] = sorted(name for name in folders if not _LEFT_BEHIND.fullmatch(name))
        for name in sorted(files):
            if not _LEFT_BEHIND.fullmatch(name):
                place = Path(folder, name)
                yield from _file(place, place.relative_to(path).parts, budget)


def _file(place: Path, parts: tuple[str, ...], budget: _Budget) -> Iterator[Found]:
    try:
        # A link may lead to the teacher's own files, and what is no file may never end.
        if not stat.S_ISREG(os.lstat(place).st_mode):
            yield Found(parts, why="it is a link, or no file")
        elif place.suffix.lower() == ".zip":
            with open(place, "rb") as file:
                yield from _unzipped(parts, file, budget, 1)
        else:
            with open(place, "rb") as file:
                yield _content(parts, file, budget)
    except OSError as error:
        yield Found(parts, why=f"it cannot be read: {error.strerror}")


def _content(parts: tuple[str, ...], file: IO[bytes], budget: _Budget) -> Found:
    """Read what is of use: nothing of a film, and of no file more than is judged."""
    if not _holds_answers(parts[-1]):
        other = parts[-1].lower().endswith(_OTHER_ARCHIVES)
        return Found(parts, why="unpack it first: of archives, zip is read" if other else "it is no file of answers")
    data = file.read(min(MOST_FILE + 1, budget.bytes + 1))
    budget.bytes -= len(data)
    budget.files -= 1
    if budget.bytes < 0 or budget.files < 0:
        return Found(parts, why="there is too much in all; have it judged in parts")
    return Found(parts, data)


def _unzipped(parts: tuple[str, ...], file: IO[bytes], budget: _Budget, depth: int, name: str = "") -> Iterator[Found]:
    """Yield the files in an archive, whose own ``name`` is no part of theirs, and in those within it."""
    try:
        archive = zipfile.ZipFile(file)
        entries = sorted(archive.infolist(), key=_name)
    except (zipfile.BadZipFile, NotImplementedError, ValueError, OSError):
        yield Found(parts or (name,), why="it is no zip archive that can be read")
        return
    for entry in entries:
        # Only a name: whatever folders it goes up to, nothing is written there.
        inner = tuple(part for part in re.split(r"[/\\]", _name(entry)) if part not in ("", ".", ".."))
        if entry.is_dir() or not inner or any(map(_LEFT_BEHIND.fullmatch, inner)):
            continue
        place = (*parts, *inner)
        if budget.files < 0:
            yield Found(place, why="there is too much in all; have it judged in parts")
            return
        try:
            yield from _entry(archive, entry, place, budget, depth)
        except (zipfile.BadZipFile, zlib.error, NotImplementedError, EOFError, ValueError, OSError):
            yield Found(place, why="it is damaged in its archive")


def _entry(
    archive: zipfile.ZipFile, entry: zipfile.ZipInfo, place: tuple[str, ...], budget: _Budget, depth: int
) -> Iterator[Found]:
    if entry.flag_bits & 1:
        yield Found(place, why="it is locked with a password")
    elif stat.S_ISLNK(entry.external_attr >> 16):
        yield Found(place, why="it is a link, or no file")
    elif entry.compress_type not in _PACKED:
        yield Found(place, why="it is packed in a way that is not read here; unpack the archive first")
    elif not place[-1].lower().endswith(".zip"):
        with archive.open(entry) as file:
            yield _content(place, file, budget)
    elif depth == _DEEPEST:
        yield Found(place, why=f"it is an archive within {_DEEPEST} others")
    else:
        with archive.open(entry) as file:
            data = file.read(budget.bytes + 1)
        budget.bytes -= len(data)
        if budget.bytes < 0:
            yield Found(place, why="there is too much in all; have it judged in parts")
        else:
            yield from _unzipped(place, io.BytesIO(data), budget, depth + 1)


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
