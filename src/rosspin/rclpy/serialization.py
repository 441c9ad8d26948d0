"""Messages as bytes (sources: rclpy/serialization.py, rmw_fastrtps_cpp/src/rmw_serialize.cpp)."""

from __future__ import annotations

from typing import Any

from ..messages.cdr import CDRError, deserialize, room, serialize
from ..messages.ros2 import Message, transfer
from .exceptions import RMWError, no_type_support, not_accepted

__all__ = ["deserialize_message", "serialize_message"]


def serialize_message(message: Message) -> bytes:
    """Turn a message into bytes, in ROS 2's format CDR.

    As on a real ROS, there may be more than the message takes, and than a raw subscription gets. Raises AttributeError
    for what is no message, AssertionError for wrong values.
    """
    if not isinstance(message, Message):
        raise no_type_support(type(message))
    return serialize(transfer(message, type(message))).ljust(room(message), b"\0")


def deserialize_message(serialized_message: bytes, message_type: type[Message]) -> Message:
    """Turn bytes into a message of a class. Raises RMWError if they hold none, AttributeError for another class."""
    if not (isinstance(message_type, type) and issubclass(message_type, Message)):
        raise no_type_support(message_type)
    if not isinstance(serialized_message, bytes):
        signature = "(arg0: bytes, arg1: object) -> object"
        given: Any = serialized_message
        raise not_accepted(signature, given, message_type, function="rclpy_deserialize")
    try:
        return deserialize(serialized_message, message_type)
    except CDRError:
        package, folder = message_type.__module__.split(".")[:2]
        name = f"{package}::{folder}::dds_::{message_type.__name__}_"
        text = f"failed to deserialize ROS message: Fast CDR exception deserializing message of type {name}."
        raise RMWError(text) from None
