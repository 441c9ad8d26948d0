"""rospy's exceptions (source: rospy/exceptions.py)."""

from __future__ import annotations

__all__ = [
    "ROSException",
    "ROSInitException",
    "ROSInternalException",
    "ROSInterruptException",
    "ROSSerializationException",
    "ROSTimeMovedBackwardsException",
    "TransportException",
    "TransportInitError",
    "TransportTerminated",
]


class ROSException(Exception):
    """Base of what rospy raises."""


class ROSSerializationException(ROSException):
    """A message could not be serialised."""


class ROSInitException(ROSException):
    """The node is not initialised, or could not be."""


class ROSInterruptException(ROSException, KeyboardInterrupt):
    """A call was interrupted, by shutdown for one; caught by handlers of either base."""


class ROSTimeMovedBackwardsException(ROSInterruptException):
    """ROS time went back during a sleep, by ``time`` seconds."""

    def __init__(self, time: float) -> None:
        super().__init__("ROS time moved backwards")
        self.time = time


class ROSInternalException(Exception):
    """Base of what goes wrong inside ROS."""


class TransportException(ROSInternalException):
    """Base of transport errors."""


class TransportTerminated(TransportException):
    """A transport ended."""


class TransportInitError(TransportException):
    """A transport could not be set up."""


# Tracebacks call them as on a real ROS.
for _name in __all__:
    globals()[_name].__module__ = "rospy.exceptions"
