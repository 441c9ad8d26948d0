"""rosgraph for nodes of ROS 1 (sources: rosgraph/masterapi.py, rosenv.py). Loaded when a node imports it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

from ..world.world import NotSimulated, refusing
from . import client
from . import rosgraph as names
from .master import ALTERS, CALLS, OF_NAMES, URI
from .state import state

__all__ = [
    "ROS_HOSTNAME",
    "ROS_IP",
    "ROS_IPV6",
    "ROS_MASTER_URI",
    "ROS_NAMESPACE",
    "Master",
    "MasterError",
    "MasterException",
    "MasterFailure",
    "get_master_uri",
    "is_master_online",
    "myargv",
]

ROS_MASTER_URI, ROS_NAMESPACE, ROS_HOSTNAME = "ROS_MASTER_URI", "ROS_NAMESPACE", "ROS_HOSTNAME"
ROS_IP, ROS_IPV6 = "ROS_IP", "ROS_IPV6"


class MasterException(Exception):
    """Base of the master's errors."""


class MasterFailure(MasterException):
    """The master has failed. It never does."""


class MasterError(MasterException):
    """The master says that there is no such thing."""


Error, Failure, ROSMasterException = MasterError, MasterFailure, MasterException


class Master:
    """The master, as the node ``caller_id`` asks it: ``getSystemState()`` and its like return a value.

    Raises MasterError if there is none. There is only the master of the run: another ``master_uri`` is refused.
    """

    def __init__(self, caller_id: str, master_uri: str | None = None) -> None:
        if master_uri not in (None, URI):
            raise NotSimulated(f"the master {master_uri}")
        self.master_uri = URI
        self.caller_id = names.make_caller_id(caller_id).removesuffix("/")

    def is_online(self) -> bool:
        """Whether it answers, as it does here."""
        return True

    def __getattr__(self, key: str) -> Callable[..., Any]:
        if key == "handle" or key.startswith(ALTERS):
            raise NotSimulated(f"rosgraph.Master.{key}")
        found = CALLS.get(key) or OF_NAMES.get(key)
        if not found:
            raise AttributeError(f"'Master' object has no attribute '{key}'", name=key, obj=self)
        call, count = found

        def ask(*args: Any) -> Any:
            if len(args) != count:
                raise TypeError(f"Master.{key}() takes {count + 1} positional arguments but {len(args) + 1} were given")
            if key == "searchParam":
                if name := client.search_from(self.caller_id, args[0]):
                    return name
                raise MasterError(f"Cannot find parameter [{args[0]}] in an upwards search")
            if key in OF_NAMES:
                args = names.resolve_name(args[0], self.caller_id), *args[1:]
            code, text, value = call(state(), *args)
            if code != 1:
                raise MasterError(text)
            return value

        return ask


def is_master_online(master_uri: str | None = None) -> bool:
    """Whether the master of the run answers, as it does."""
    return Master("rosgraph", master_uri).is_online()


is_online = is_master_online


def get_master_uri(env: Any = None, argv: Any = None) -> str:
    """Return where the master of the run would be found, whatever the environment says."""
    return URI


def myargv(argv: list[str] | None = None) -> list[str]:
    """Return a command line, the node's if none is given, without its remappings."""
    return [arg for arg in (sys.argv if argv is None else argv) if names.REMAP not in arg]


__getattr__ = refusing("rosgraph", {"network", "roslogging", "rosenv", "xmlrpc"})

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {
    "rosgraph": sys.modules[__name__],
    "rosgraph.masterapi": sys.modules[__name__],
    "rosgraph.names": names,
}
masterapi = sys.modules[__name__]
for _kind in (MasterError, MasterException, MasterFailure):
    _kind.__module__ = "rosgraph.masterapi"  # which tracebacks show
