"""Checks of what should be a message or a service (source: rclpy/type_support.py)."""

from __future__ import annotations

from typing import Any

from ..messages.ros2 import Action, Message, Service
from .exceptions import no_type_support

__all__ = ["check_for_type_support", "check_is_valid_msg_type", "check_is_valid_srv_type"]


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Raise AttributeError for what is no class of a message, service or action of ROS 2."""
    if not issubclass(_kind(msg_or_srv_type), (Message, Service, Action)):
        raise no_type_support(msg_or_srv_type)


def _kind(given: Any) -> type:
    """Return the class that is meant: an instance of a message has what its class has."""
    if isinstance(given, Message):
        return type(given)
    return given if isinstance(given, type) else type(None)


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Raise AttributeError, or RuntimeError for a service or action, for what is no class of a message."""
    _check(msg_type, Message, "message", "service")


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Raise AttributeError, or RuntimeError for a message or action, for what is no class of a service."""
    _check(srv_type, Service, "service", "message")


def _check(given: Any, base: type, what: str, other: str) -> None:
    check_for_type_support(given)
    if not issubclass(_kind(given), base):
        raise RuntimeError(f"The {what} type provided is not valid ({given}), this might be a {other} or action")
