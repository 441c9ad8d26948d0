"""The stand-in for rospy: its names and its rules for time, on the wall clock or in simulated time.

What is here behaves as in rospy 1.15.15; the rest raises :class:`NotSimulated`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from importlib import import_module
from types import ModuleType
from typing import Any

from ..clocks.frames import show_in
from ..messages import MessageFinder, genpy, ros1
from ..messages.ros1 import Message
from ..world.world import NotSimulated
from . import client, core, exceptions, msg, names, numpy_msg, rostime, service, timer, topics, validators
from .client import *
from .core import *
from .exceptions import *
from .master import get_master
from .msg import AnyMsg
from .names import *
from .rostime import Duration, Time, get_rostime, get_time
from .service import Service, ServiceException, ServiceProxy, wait_for_service
from .timer import Rate, Timer, sleep
from .topics import Publisher, SubscribeListener, Subscriber

__all__ = [
    "AnyMsg",
    "Duration",
    "Header",
    "Message",
    "Publisher",
    "Rate",
    "Service",
    "ServiceException",
    "ServiceProxy",
    "SubscribeListener",
    "Subscriber",
    "Time",
    "Timer",
    "get_master",
    "get_rostime",
    "get_time",
    "sleep",
    "wait_for_service",
    *client.__all__,
    *core.__all__,
    *exceptions.__all__,
    *names.__all__,
]

Header: Any  # made when it is asked for

# The names of rospy that are not here: the master and the network need a real ROS.
NOT_SIMULATED = {
    "MasterProxy",
    "get_ros_root",
    "impl",
    "msproxy",
    "parse_rosrpc_uri",
}

# Names that do less here than in rospy, and what each lacks.
IN_PART = {
    **dict.fromkeys(
        (name for name in core.__all__ if name.startswith("log")),
        "On the console only: nothing goes to ``/rosout`` or into a log file.",
    ),
    **dict.fromkeys(
        (name for name in client.__all__ if "param" in name),
        "The parameters belong to the run: its nodes share them, and no other program sees them.",
    ),
    "Publisher": "The queue loses nothing: ``queue_size``, ``tcp_nodelay`` and ``headers`` have no effect.",
    "Service": "There is no network: ``buff_size`` has no effect.",
    "Subscriber": "There is no network: ``buff_size`` and ``tcp_nodelay`` have no effect.",
    "get_master": "It tells of the nodes of the run, and sets parameters; it registers nothing, and has no ``target``.",
    "get_node_uri": "No one listens there: it only differs from node to node.",
    "init_node": "There is no network: ``disable_rosout`` and the ports have no effect.",
}

# What a node may import, by its name on a real ROS.
MODULES = {
    "rospy": sys.modules[__name__],
    "genpy": ros1,
    "genpy.message": ros1,
    "genpy.rostime": genpy,
    "rospy.client": client,
    "rospy.core": core,
    "rospy.exceptions": exceptions,
    "rospy.impl.validators": validators,
    "rospy.msg": msg,
    "rospy.names": names,
    "rospy.numpy_msg": numpy_msg,
    "rospy.rostime": rostime,
    "rospy.service": service,
    "rospy.timer": timer,
    "rospy.topics": topics,
}

# Whoever prints an object sees where its class is on a real ROS. Times stay where pickle finds them after a run, too.
_HOMES = dict.fromkeys(("Service", "ServiceProxy"), "rospy.impl.tcpros_service")
for _name in ("rospy.service", "rospy.timer", "rospy.topics"):
    for _value in [value for value in vars(MODULES[_name]).values() if isinstance(value, type)]:
        if _value.__module__ == MODULES[_name].__name__:
            show_in(_value, _HOMES.get(_value.__name__, _name))

# Few nodes ask for these of genpy.message.
_FILLING = {"fill_message_args", "get_message_class", "get_printable_message_args", "get_service_class"}


def _of_filling(name: str) -> Any:
    if name in _FILLING:
        return getattr(import_module("..messages.filling", __package__), name)
    raise AttributeError(f"module 'genpy.message' has no attribute {name!r}", name=name)


ros1.__getattr__ = _of_filling  # type: ignore[method-assign]

# What importing rospy registers with atexit: function, args, kwargs.
AT_EXIT: list[Any] = [(core.signal_shutdown, ("atexit",), {})]


def for_process() -> ModuleType:
    """Return the module that a process gets as ``rospy``."""
    return sys.modules[__name__]


def brought_by(name: str) -> Iterable[str]:
    """Return the full names of rospy's modules that importing a module brings: all, as rospy imports them itself."""
    return MODULES


def __getattr__(name: str) -> Any:
    if name == "Header":  # the class that this run's std_msgs.msg has
        try:
            return import_module("std_msgs.msg").Header
        except ImportError:  # outside of a run
            return MessageFinder(1).messages["std_msgs/Header"]
    if name in NOT_SIMULATED:
        raise NotSimulated(f"rospy.{name}")
    raise AttributeError(f"module 'rospy' has no attribute '{name}'", name=name)
