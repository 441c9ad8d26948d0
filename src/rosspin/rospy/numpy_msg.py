"""Messages whose arrays of numbers are numpy's (source: rospy/numpy_msg.py). numpy is needed when a class is made."""

from __future__ import annotations

from typing import Any

from ..messages.ros1 import Message
from ..messages.wire import numpy_array

__all__ = ["numpy_msg"]


def numpy_msg(msg_type: type[Message]) -> type[Message]:
    """Make the class of messages like these whose arrays of numbers are numpy's, except of ``uint8``.

    Received arrays are read-only. One that is not numpy's, such as a list, raises AttributeError when it is published.
    """
    made: type[Message] | None = vars(msg_type).get("_numpy")
    if made is None:
        steps = msg_type._plan(numpy_array)
        namespace: dict[str, Any] = {"__slots__": msg_type.__slots__, "__module__": "rospy.numpy_msg", "_steps": steps}
        made = type(f"Numpy_{msg_type._type.replace('/', '__')}", (msg_type,), namespace)
        msg_type._numpy = made  # type: ignore[attr-defined]  # kept as long as the class, which is of one run
    return made
