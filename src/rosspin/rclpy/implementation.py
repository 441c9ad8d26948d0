"""The names of rclpy's C++ module that nodes import: its exceptions and enumerations.

Source: rclpy/src/rclpy/_rclpy_pybind11.cpp.
"""

from __future__ import annotations

import sys
from typing import Any

from ..world.world import NotSimulated
from .event_handler import UnsupportedEventTypeError as UnsupportedEventTypeError
from .exceptions import InvalidHandle as InvalidHandle
from .exceptions import RCLError as RCLError
from .exceptions import RCLInvalidROSArgsError as RCLInvalidROSArgsError
from .exceptions import RMWError as RMWError
from .exceptions import UnknownROSArgsError as UnknownROSArgsError
from .lifecycle import TransitionCallbackReturn as _Return
from .node import NodeNameNonExistentError as NodeNameNonExistentError
from .qos import QoSCompatibility as QoSCompatibility
from .qos import rmw_qos_profile_t as rmw_qos_profile_t
from .signals import SignalHandlerOptions as SignalHandlerOptions

__all__: list[str] = []  # the page of names lists these by their own modules

TransitionCallbackReturnType = _Return
rclpy_implementation = sys.modules[__name__]


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(f"module 'rclpy._rclpy_pybind11' has no attribute {name!r}", name=name)
    raise NotSimulated(f"rclpy._rclpy_pybind11.{name}")
