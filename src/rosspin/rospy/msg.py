"""Make and serialise messages as rospy does (source: rospy/msg.py)."""

from __future__ import annotations

import io
from typing import Any, ClassVar

from ..messages.ros1 import Message
from .exceptions import ROSException
from .names import TOPIC_ANYTYPE

__all__ = ["AnyMsg", "args_kwds_to_message", "serialize_message"]


class AnyMsg(Message):
    """Lets a subscriber take any topic, whatever its type. The messages are kept as the bytes ``_buff``.

    Raises ROSException for arguments.
    """

    __slots__ = ["_buff"]
    _type = _md5sum = TOPIC_ANYTYPE
    _full_text = ""
    _has_header = False
    _slot_types: ClassVar[list[str]] = []

    def __init__(self, *args: Any) -> None:
        if args:
            raise ROSException("AnyMsg does not accept arguments")
        self._buff: bytes | None = None

    def serialize(self, buff: Any) -> None:
        """Write the bytes. Raises ROSException if there are none."""
        if self._buff is None:
            raise ROSException("AnyMsg is not initialized")
        buff.write(self._buff)

    def deserialize(self, data: bytes) -> AnyMsg:
        """Keep the bytes."""
        self._buff = data
        return self


def args_kwds_to_message(data_class: type[Message], args: tuple[Any, ...], kwds: dict[str, Any]) -> Message:
    """Make a message from the arguments of ``publish``. Raises TypeError or AttributeError if they make none."""
    if args and kwds:
        raise TypeError("publish() can be called with arguments or keywords, but not both.")
    if len(args) == 1:
        (message,) = args
        if hasattr(message, "_md5sum") and (message._md5sum == data_class._md5sum or isinstance(message, AnyMsg)):
            return message  # type: ignore[no-any-return]
        if isinstance(message, Message) and data_class._slot_types[:1] != [message._type]:
            expected = "".join(data_class._slot_types[:1])
            raise TypeError(f"expected [{expected}] but got [{message._type}]")
    return data_class(*args, **kwds)


def serialize_message(seq: int, message: Message) -> bytes:
    """Set the ``seq`` of a message's header, and return the message's bytes. Raises what ``Message.serialize`` does."""
    if message._has_header:
        header: Any = message.header  # type: ignore[attr-defined]
        header.seq = seq
        if header.frame_id is None:
            header.frame_id = "0"
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()
