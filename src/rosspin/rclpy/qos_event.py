"""The former name of event_handler, without the warning that it is deprecated (source: rclpy/qos_event.py)."""

from .event_handler import *  # noqa: F403
from .event_handler import __all__ as __all__
