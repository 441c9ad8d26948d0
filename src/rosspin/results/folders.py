"""Temporary folders, which are removed by the next run if this one is killed."""

from __future__ import annotations

import itertools
import os
import tempfile
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

__all__ = ["TemporaryFolder", "sweep"]

_PREFIX = "rosspin-"

# Whoever holds the lock on this file lives. Children that are started do not hold it, too.
_LOCK = ".owner"


class TemporaryFolder:
    """A folder, by its ``path``, for as long as it is entered, or until :meth:`remove`."""

    def __init__(self) -> None:
        self.path = Path(tempfile.mkdtemp(prefix=_PREFIX))
        self._lock = _locked(self.path / f"{_LOCK}-new")
        if self._lock is not None:
            (self.path / f"{_LOCK}-new").rename(self.path / _LOCK)  # which others can see only now

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.remove()

    def remove(self) -> None:
        """Remove it, with all that is in it."""
        _remove(self.path)
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None


def sweep() -> None:
    """Remove the temporary folders of the user's processes that have been killed."""
    if not hasattr(os, "getuid"):  # on Windows
        return
    for folder in Path(tempfile.gettempdir()).glob(f"{_PREFIX}*"):
        with suppress(OSError):
            if folder.is_symlink() or folder.stat().st_uid != os.getuid() or not (folder / _LOCK).is_file():
                continue
            lock = _locked(folder / _LOCK)
            if lock is not None:
                _remove(folder)
                os.close(lock)


def _remove(top: Path) -> None:
    """Remove a folder as far as that goes: also what is deeper than Python or a path can go, or closed to its owner."""
    numbers = itertools.count()
    waiting = [top]
    with suppress(OSError):
        top.chmod(0o700)
    while waiting:
        folder = waiting.pop()
        with suppress(OSError):
            for entry in [*os.scandir(folder)]:
                with suppress(OSError):
                    if entry.is_dir(follow_symlinks=False):
                        os.chmod(entry.path, 0o700)
                        waiting.append(Path(entry.path).rename(top / f".{next(numbers)}"))
                    else:
                        os.unlink(entry.path)
            if folder != top:
                folder.rmdir()
    with suppress(OSError):
        top.rmdir()


def _locked(path: Path) -> int | None:
    """Open a file and lock it; None if another process has locked it, or if this system has no such locks."""
    try:
        import fcntl
    except ImportError:  # on Windows
        return None
    file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(file)
        return None
    return file
