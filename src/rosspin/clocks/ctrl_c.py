"""How a process is asked to end: by Ctrl-C, by stronger signals if that does not help, and by SIGKILL at last."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import NamedTuple

__all__ = ["ALONE", "ROS2_LAUNCH", "ROSLAUNCH", "Ending"]


class Ending(NamedTuple):
    """The signals that a process is sent, and how long (s) it is given after each. Then SIGKILL."""

    signals: tuple[tuple[signal.Signals, float], ...]

    @property
    def patience(self) -> float:
        """How long (s) a process has to end before it is killed."""
        return sum(seconds for _, seconds in self.signals)

    def carry_out(
        self, send: Callable[[signal.Signals], object], ends_within: Callable[[float], bool]
    ) -> signal.Signals:
        """Send a process one signal after another until it ends within the time (s) that it is given.

        Return the last signal that it took: SIGKILL, which is not waited for, if it heeds no other.
        """
        for number, seconds in self.signals:
            send(number)
            if ends_within(seconds):
                return number
        send(signal.SIGKILL)
        return signal.SIGKILL


# Each launcher ends its nodes in this way (sources: roslaunch/nodeprocess.py, launch/actions/execute_local.py).
ROSLAUNCH = Ending(((signal.SIGINT, 15.0), (signal.SIGTERM, 2.0)))
ROS2_LAUNCH = Ending(((signal.SIGINT, 5.0), (signal.SIGTERM, 5.0)))

# A node without a launcher gets Ctrl-C alone, and as much time as under roslaunch.
ALONE = Ending(((signal.SIGINT, ROSLAUNCH.patience),))
