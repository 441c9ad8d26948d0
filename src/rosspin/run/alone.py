"""A Python that starts no other process, as in a web page: whatever would start one is refused by its name."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

from ..world.world import NotSimulated
from .process import starter

__all__ = ["ON_A_COMPUTER", "refuse_processes"]

ON_A_COMPUTER = "the wall clock or on a real ROS"
"""Where processes can be started instead."""


class _NoProcesses:
    """Refuses the modules that ``multiprocessing`` imports only for a process, or for what processes share."""

    @staticmethod
    def find_spec(name: str, path: Any = None, target: Any = None) -> None:
        if name in ("multiprocessing.resource_tracker", "multiprocessing.synchronize"):
            raise NotSimulated(starter(sys._getframe()), ON_A_COMPUTER)


def _refusing(name: str) -> Any:
    def refuse(*args: Any, **options: Any) -> None:
        raise NotSimulated(name, ON_A_COMPUTER)

    return refuse


def refuse_processes() -> None:
    """From now on, whoever asks this Python for a process gets NotSimulated. Nothing takes this back."""
    sys.meta_path.insert(0, _NoProcesses)
    os.fork = _refusing("os.fork")
    subprocess.Popen.__init__ = _refusing("subprocess")  # type: ignore[method-assign]
