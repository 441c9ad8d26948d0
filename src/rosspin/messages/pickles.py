"""Take messages to another process, where their classes are made anew."""

from __future__ import annotations

import io
import pickle
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from ..results.ticks import Message
from .finder import MessageFinder

__all__ = ["Packed", "pack", "unpack"]

# A Message whose message is in bytes; None if it cannot leave its process, as with an object of the node's own in it.
Packed = tuple[str, str, float, bytes | None]


def pack(messages: Sequence[Message]) -> list[Packed]:
    """Turn messages into data that another process can read."""
    return [(topic, node, time, _pickled(message)) for topic, node, time, message in messages]


def unpack(packed: Sequence[Packed], folder: Path | None) -> tuple[Message, ...]:
    """Make anew the messages of a node whose file is in ``folder``; None for each that could not be packed."""
    find = cache(lambda ros: MessageFinder(ros, folder).messages)

    class Unpickler(pickle.Unpickler):
        def persistent_load(self, which: tuple[int, str]) -> Any:
            ros, name = which
            return find(ros)[name]

    return tuple(
        Message(topic, node, time, None if data is None else Unpickler(io.BytesIO(data)).load())
        for topic, node, time, data in packed
    )


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
            if re.fullmatch(r"\w+\.msg\._\w+", kind.__module__):
                return 1 if hasattr(kind, "_md5sum") else 2, f"{kind.__module__.partition('.')[0]}/{kind.__name__}"
        return None
