"""The names of rclpy's C++ module that nodes import: its exceptions (source: rclpy/src/rclpy/_rclpy_pybind11.cpp)."""

from __future__ import annotations

import sys
from typing import Any

from ..world.world import NotSimulated
from .event_handler import UnsupportedEventTypeError
from .exceptions import InvalidHandle, RCLError, RCLInvalidROSArgsError, RMWError, UnknownROSArgsError
from .node import NodeNameNonExistentError
from .qos import rmw_qos_profile_t

__all__ = [
    "InvalidHandle",
    "NodeNameNonExistentError",
    "RCLError",
    "RCLInvalidROSArgsError",
    "RMWError",
    "UnknownROSArgsError",
    "UnsupportedEventTypeError",
    "rclpy_implementation",
    "rmw_qos_profile_t",
]

rclpy_implementation = sys.modules[__name__]


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(f"module 'rclpy._rclpy_pybind11' has no attribute {name!r}", name=name)
    raise NotSimulated(f"rclpy._rclpy_pybind11.{name}")
