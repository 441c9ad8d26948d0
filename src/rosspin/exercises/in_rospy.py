"""ROS 1, as judging sees it."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from types import CodeType, FrameType
from typing import Any

from .. import rospy
from ..rospy.state import State
from ..rospy.timer import Timer
from ..world.world import World
from .advice import advice

__all__ = ["ENDINGS", "WAITING", "hint", "timer_of", "timers", "whose"]

ENDINGS: tuple[type[BaseException], ...] = ()
WAITING: Collection[CodeType] = (rospy.spin.__code__,)


def timer_of(frame: FrameType) -> Any:
    """Return the timer whose thread begins in a frame, or None."""
    return frame.f_locals["self"] if frame.f_code is Timer.run.__code__ else None


def timers(world: World, printers: Iterable[Any]) -> list[tuple[Any, str, bool, bool]]:
    """Return the timers that were started."""
    return [
        (timer, timer._rosspin_source, not timer.is_alive(), timer._shutdown or timer._oneshot and not timer.is_alive())
        for timer in world.part(State).timers
    ]


def whose(codes: Collection[CodeType]) -> str:
    """Tell whether a timer was ended, with its thread, or a shutdown hook."""
    if Timer.run.__code__ in codes:
        return "timer"
    return "shutdown hook" if rospy.signal_shutdown.__code__ in codes else ""


def hint(error: BaseException, whose: str) -> str:
    """Return the advice on an error in rospy."""
    if isinstance(error, TypeError) and whose == "shutdown hook":
        return "A shutdown hook is called without arguments."
    return advice(error)
