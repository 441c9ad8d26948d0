"""Take messages to another process, where their classes are made again."""

from __future__ import annotations

import io
import pickle
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from ..results.ticks import Call, Message
from .finder import MessageFinder

__all__ = ["Packed", "pack", "unpack"]

# The fields of a Message or a Call in bytes; None for one that cannot leave its process, as with an object of the
# node's own in it.
Packed = list[bytes | None]


def pack(records: Sequence[Message | Call]) -> list[Packed]:
    """Turn messages, or calls, into data that another process can read."""
    return [list(map(_pickled, record)) for record in records]


def unpack(packed: Sequence[Sequence[Packed]], kinds: Sequence[Any], folder: Path | None) -> list[tuple[Any, ...]]:
    """Make records of these kinds again, of a node whose file is in ``folder``; a field that is not packed is None."""
    find = cache(lambda ros: MessageFinder(ros, folder).messages)

    class Unpickler(pickle.Unpickler):
        def persistent_load(self, which: tuple[int, str]) -> Any:
            ros, name = which
            return find(ros)[name]

    def load(data: bytes | None) -> Any:
        return None if data is None else Unpickler(io.BytesIO(data)).load()

    return [tuple(kind(*map(load, fields)) for fields in each) for kind, each in zip(kinds, packed, strict=True)]


def _pickled(message: Any) -> bytes | None:
    file = io.BytesIO()
    try:
        _Pickler(file).dump(message)
    except (pickle.PicklingError, AttributeError, TypeError):
        return None
    return file.getvalue()


class _Pickler(pickle.Pickler):
    def persistent_id(self, thing: Any) -> tuple[int, str] | None:
        """For a message class, its ROS and the message's name. A node's own subclass counts as the class it extends."""
        for kind in thing.__mro__ if isinstance(thing, type) else ():
            if re.fullmatch(r"\w+\.(msg|srv|action)\._\w+", kind.__module__):
                return 1 if hasattr(kind, "_md5sum") else 2, f"{kind.__module__.partition('.')[0]}/{kind.__name__}"
        return None
