"""The stand-in for rospy: its names and its rules for time, on the wall clock or in simulated time.

What is here behaves as in rospy 1.15.15; the rest raises :class:`NotSimulated`.
"""

from __future__ import annotations

import sys
from typing import NoReturn

from ..world import NotSimulated
from . import client, core, exceptions, genpy, names, rostime, timer, validators
from .client import *
from .core import *
from .exceptions import *
from .names import *
from .rostime import Duration, Time, get_rostime, get_time
from .timer import Rate, Timer, sleep

__all__ = [
    "Duration",
    "Rate",
    "Time",
    "Timer",
    "get_rostime",
    "get_time",
    "sleep",
    *client.__all__,
    *core.__all__,
    *exceptions.__all__,
    *names.__all__,
]

# What rospy has beside: topics, services and the master need a real ROS.
NOT_SIMULATED = {
    "AnyMsg",
    "Header",
    "MasterProxy",
    "Message",
    "Publisher",
    "Service",
    "ServiceException",
    "ServiceProxy",
    "SubscribeListener",
    "Subscriber",
    "get_master",
    "get_node_uri",
    "get_published_topics",
    "get_ros_root",
    "impl",
    "msg",
    "msproxy",
    "numpy_msg",
    "parse_rosrpc_uri",
    "service",
    "topics",
    "wait_for_message",
    "wait_for_service",
}

# Names that do less here than in rospy, and what is lacking.
IN_PART = {
    **dict.fromkeys(
        (name for name in core.__all__ if name.startswith("log")),
        "On the console only: nothing goes to ``/rosout`` or into a log file.",
    ),
    **dict.fromkeys(
        (name for name in client.__all__ if "param" in name),
        "The node has parameters of its own: there is no server through which nodes share them.",
    ),
    "init_node": "There is no network: ``disable_rosout`` and the ports have no effect.",
}

# What a node may import, by its name on a real ROS.
MODULES = {
    "rospy": sys.modules[__name__],
    "genpy": genpy,
    "genpy.rostime": genpy,
    "rospy.client": client,
    "rospy.core": core,
    "rospy.exceptions": exceptions,
    "rospy.impl.validators": validators,
    "rospy.names": names,
    "rospy.rostime": rostime,
    "rospy.timer": timer,
}


def __getattr__(name: str) -> NoReturn:
    if name in NOT_SIMULATED:
        raise NotSimulated(f"rospy.{name}")
    raise AttributeError(f"module 'rospy' has no attribute '{name}'", name=name)
