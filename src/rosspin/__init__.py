"""Run a ROS node without ROS, and see when it ticked."""

from __future__ import annotations

import sys

# With python -m, the current folder is first on the path: a queue.py there would take the place of Python's.
if sys.argv[:1] == ["-m"] and not __file__.startswith(sys.path[0]):
    del sys.path[0]

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .orders.exploring import Exploration, explore, explored
    from .results.ticks import Call, FaultEvent, Message, Run, Tick
    from .run.explain import TimeStandsStill
    from .run.roslaunch.launch import Node
    from .run.simulate import simulate
    from .run.steps import NodeFailed, StartedNode, start
    from .run.wall import measure
    from .world.world import NotSimulated

# Where each name is imported from when it is first asked for: pytest loads this package in every run.
_MODULES = {
    "orders.exploring": ("Exploration", "explore", "explored"),
    "run.roslaunch.launch": ("Node",),
    "run.explain": ("TimeStandsStill",),
    "run.simulate": ("simulate",),
    "run.steps": ("NodeFailed", "StartedNode", "start"),
    "results.ticks": ("Call", "Message", "FaultEvent", "Run", "Tick"),
    "run.wall": ("measure",),
    "world.world": ("NotSimulated",),
}

__all__ = [
    "Call",
    "Exploration",
    "Message",
    "FaultEvent",
    "Node",
    "NodeFailed",
    "NotSimulated",
    "Run",
    "StartedNode",
    "Tick",
    "TimeStandsStill",
    "explore",
    "explored",
    "measure",
    "simulate",
    "start",
]


def __getattr__(name: str) -> Any:
    for module, names in _MODULES.items():
        if name in names:
            found = globals()[name] = getattr(import_module(f".{module}", __name__), name)
            return found
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}", name=name)


def load_ipython_extension(shell: Any) -> None:
    """``%load_ext rosspin``: the cell magics ``%%simulate`` and ``%%measure``."""
    from .site.magics import Magics

    shell.register_magics(Magics)
