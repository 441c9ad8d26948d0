"""An order of events next to the usual one: what the threads of nodes did where the two differ. Pure data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from .ticks import Run

__all__ = ["Instant", "Orders", "Step"]


class Step(NamedTuple):
    """A line that a thread ran: its number, after the name of its file if there are several, and its ``text``."""

    thread: str
    line: str
    text: str


class Instant(NamedTuple):
    """What threads did at a ``time`` (s): the steps in the usual order, and those ``here``, each in a row.

    ``deviations`` are the choices made at that time, each as what would usually have been next, and what was.
    """

    time: float
    usual: Sequence[Step]
    here: Sequence[Step]
    deviations: Sequence[tuple[str, str]]

    @property
    def differs(self) -> int | None:
        """The place of the first step that is another one; None if all are the same."""
        most = max(len(self.usual), len(self.here))
        return next((n for n in range(most) if self.usual[n : n + 1] != self.here[n : n + 1]), None)


@dataclass(frozen=True)
class Orders:
    """The run in the usual order, the run in another one, and the ``instants`` at which they should be compared.

    A run is None if time stands still in it. The instants are of all deviations, and the first at which the steps
    differ. The steps of functions, and of nodes that a launch file of ROS 2 starts, are not known.
    """

    usual: Run | None
    here: Run | None
    instants: Sequence[Instant]
