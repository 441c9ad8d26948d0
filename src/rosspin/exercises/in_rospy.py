"""ROS 1, as judging sees it."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from types import CodeType, FrameType
from typing import Any

from .. import rospy
from ..rospy.state import State
from ..rospy.timer import Timer
from ..rospy.topics import Subscription
from ..world.world import World
from .advice import advice
from .watched import Watched

__all__ = ["ENDINGS", "WAITING", "heard_in", "hint", "in_words", "parameters", "timer_of", "timers", "whose"]

ENDINGS: tuple[type[BaseException], ...] = ()
WAITING: Collection[CodeType] = (rospy.spin.__code__,)


def timer_of(frame: FrameType) -> Any:
    """Return the timer whose thread begins in a frame, or None."""
    return frame.f_locals["self"] if frame.f_code is Timer.run.__code__ else None


def timers(world: World, printers: Iterable[Any]) -> list[Watched]:
    """Return the timers that were started."""
    return [
        Watched(
            timer,
            timer._rosspin_source,
            not timer.is_alive(),
            timer._shutdown or timer._oneshot and not timer.is_alive(),
            timer._period.to_sec() if isinstance(timer._period, rospy.Duration) else 0.0,
        )
        for timer in world.part(State).timers
    ]


def heard_in(frame: FrameType) -> Any:
    """Return the message with which a subscription calls back from a frame, or None."""
    return frame.f_locals["message"] if frame.f_code is Subscription._call.__code__ else None


def parameters(world: World) -> list[str]:
    """Return the parameters that it has asked for, which no one declares."""
    return sorted(world.part(State).sought - {"/use_sim_time"})


def in_words(qos: None) -> str:
    """Return nothing: there is no QoS."""
    return ""


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
