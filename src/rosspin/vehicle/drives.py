"""What a run shows of a vehicle: where it was, and who told it what."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

from ..results.ticks import Message
from .physics import EDGE, START, nearest, point

__all__ = ["NODE", "OTHERS", "STILL", "Command", "Drive", "Spot", "say_off"]

NODE = "/vehicle"
"""The full name of its node."""

OTHERS = ("/joystick", "/tablet")
"""The full names of the nodes that steer it together with an answer."""

STILL = 0.05
"""A vehicle that has gone no farther (m) than this stands still."""

_JUMP = 0.5  # m; so far nothing drives between two messages that say where it is


class Spot(NamedTuple):
    """Where the vehicle was at a time (s): in m, heading in radians, and how far ``off`` its line (m)."""

    time: float
    x: float
    y: float
    heading: float
    off: float


class Command(NamedTuple):
    """A message on ``/cmd_vel``: when (s), the full name of its sender, the speed (m/s) and the turn (rad/s)."""

    time: float
    node: str
    speed: float
    turn: float


class Drive(NamedTuple):
    """All that a run shows of one vehicle."""

    spots: tuple[Spot, ...]
    commands: tuple[Command, ...]

    @classmethod
    def of(cls, messages: Iterable[Message]) -> Drive:
        """Read it from the messages of a run. Those on ``/pose`` count if the vehicle sent them."""
        spots: list[Spot] = []
        commands, number, before = [], 0, START[:2]
        for topic, node, time, message in messages:
            if (topic, node) == ("/pose", NODE):
                x, y = message.x, message.y
                if not math.dist((x, y), before) <= _JUMP:
                    continue
                before, number = (x, y), nearest(x, y, number)
                spots.append(Spot(time, x, y, message.theta, math.dist((x, y), point(number))))
            elif topic == "/cmd_vel" and hasattr(message, "angular"):
                commands.append(Command(time, node, _number(message.linear.x), _number(message.angular.z)))
        return cls(tuple(spots), tuple(commands))

    @property
    def worst(self) -> Spot:
        """Where it was farthest off its line."""
        return max(self.spots, key=lambda spot: spot.off)

    @property
    def way(self) -> float:
        """How far it has driven (m)."""
        return sum(math.dist(one[1:3], other[1:3]) for one, other in zip(self.spots, self.spots[1:], strict=False))

    @property
    def words(self) -> str:
        """What is seen of it, as a sentence: where the vehicle was, and whose commands came."""
        senders = Counter(command.node for command in self.commands)
        came = ", ".join(f"{count} from {node}" for node, count in senders.items()) or "none"
        last = self.spots[-1]
        drives = f"drives {self.way:.1f} m in {last.time:g} s and {say_off(self.worst.off, self.worst.time)}"
        if self.way < STILL:
            drives = f"stands still for {last.time:g} s"
        return f"The vehicle {drives}. Commands: {came}."


def _number(value: float) -> float:
    """Return a number as the vehicle takes it."""
    return value if math.isfinite(value) else 0.0


def say_off(off: float, time: float) -> str:
    """Say how far off its line a vehicle was at the worst time, as the rest of a sentence."""
    if off <= EDGE:
        return f"keeps to its line: at most {100 * off:.0f} cm off"
    return f"leaves its line by {off:.1f} m, at {time:.1f} s"
