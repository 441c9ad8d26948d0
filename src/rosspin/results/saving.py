"""Save a file that was asked for: all of it, or nothing."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

__all__ = ["save_whole"]


def save_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Write a file. Raises OSError, which names it, if that fails; then an older one stays, and no part of this one."""
    target = Path(os.path.realpath(path))
    part = target.with_name(f"{target.name}.part")
    try:
        if target.exists() and not target.is_file():  # such as /dev/stdout
            target.write_bytes(data)
            return
        try:
            part.write_bytes(data)
            part.replace(target)
        except BaseException:
            with suppress(OSError):
                part.unlink()
            raise
    except OSError as error:
        raise type(error)(error.errno, error.strerror, os.fspath(path)) from None
