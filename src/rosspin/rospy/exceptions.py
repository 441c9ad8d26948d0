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
    """Base class of rospy's exceptions."""


class ROSSerializationException(ROSException):
    """A message could not be serialised."""


class ROSInitException(ROSException):
    """The node is not initialised, or could not be."""


class ROSInterruptException(ROSException, KeyboardInterrupt):
    """A call was interrupted, for example by shutdown. It is a KeyboardInterrupt, too."""


class ROSTimeMovedBackwardsException(ROSInterruptException):
    """ROS time moved backwards during a sleep, by ``time`` seconds."""

    def __init__(self, time: float) -> None:
        super().__init__("ROS time moved backwards")
        self.time = time


class ROSInternalException(Exception):
    """Base class of internal errors of ROS."""


class TransportException(ROSInternalException):
    """Base class of transport errors."""


class TransportTerminated(TransportException):
    """A transport was closed."""


class TransportInitError(TransportException):
    """A transport could not be set up."""


# Tracebacks show the names of a real ROS.
for _name in __all__:
    globals()[_name].__module__ = "rospy.exceptions"
