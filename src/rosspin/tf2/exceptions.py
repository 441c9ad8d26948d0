"""What tf2 raises (source: tf2_py.cpp)."""

from __future__ import annotations

__all__ = [
    *("ConnectivityException", "ExtrapolationException", "InvalidArgumentException", "LookupException"),
    *("TimeoutException", "TransformException"),
]


class TransformException(Exception):
    """A transform cannot be given."""


class ConnectivityException(TransformException):
    """The two frames are in different trees."""


class LookupException(TransformException):
    """A frame is not known, or the tree is a loop."""


class ExtrapolationException(TransformException):
    """The buffer has nothing from that time."""


class InvalidArgumentException(TransformException):
    """An argument cannot be the name of a frame."""


class TimeoutException(TransformException):
    """Nothing here raises it; only a server of transforms does."""


for _name in __all__:
    globals()[_name].__module__ = "tf2"  # which tracebacks show
