"""actionlib for nodes of ROS 1. Loaded when a node imports it."""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

from . import action_client, action_server
from .action_client import (
    ActionClient,
    ActionException,
    ClientGoalHandle,
    CommState,
    CommStateMachine,
    GoalManager,
    SimpleActionClient,
    SimpleGoalState,
    TerminalState,
    get_name_of_constant,
    statuses,
)
from .action_server import (
    ActionServer,
    GoalIDGenerator,
    ServerGoalHandle,
    SimpleActionServer,
    StatusTracker,
    nop_cb,
)

__all__ = [
    "ActionClient",
    "ActionException",
    "ActionServer",
    "ClientGoalHandle",
    "CommState",
    "CommStateMachine",
    "GoalIDGenerator",
    "GoalManager",
    "ServerGoalHandle",
    "SimpleActionClient",
    "SimpleActionServer",
    "SimpleGoalState",
    "StatusTracker",
    "TerminalState",
    "get_name_of_constant",
    "nop_cb",
]


def __getattr__(name: str) -> Any:
    if name == "GoalStatus":  # messages are each node's own
        return statuses()
    if name in ("GoalID", "GoalStatusArray"):
        return getattr(import_module("actionlib_msgs.msg"), name)
    raise AttributeError(f"module 'actionlib' has no attribute {name!r}", name=name)


# What a node may import, by its name on a real ROS. Its messages are each node's own.
MODULES: dict[str, ModuleType] = {
    "actionlib": sys.modules[__name__],
    **{f"actionlib.{name}": action_client for name in ("action_client", "exceptions", "simple_action_client")},
    **{
        f"actionlib.{name}": action_server
        for name in (
            "action_server",
            "goal_id_generator",
            "server_goal_handle",
            "simple_action_server",
            "status_tracker",
        )
    },
}
for _name, _module in MODULES.items():
    globals().setdefault(_name.rpartition(".")[2], _module)  # so that actionlib.action_client is there immediately
