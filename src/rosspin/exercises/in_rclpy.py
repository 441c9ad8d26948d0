"""ROS 2, as judging sees it. It is imported for answers on ROS 2 only: its stand-in is large."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from types import CodeType, FrameType
from typing import Any

from .. import rclpy
from ..clocks.clock import NS
from ..rclpy.context import State
from ..rclpy.exceptions import ExternalShutdownException, RCLError, ROSInterruptException
from ..rclpy.executors import Executor, _call
from ..rclpy.qos import QoSProfile
from ..rclpy.timer import Timer
from ..rclpy.topics import Subscription
from ..world.world import World
from .advice import advice
from .watched import Watched

__all__ = ["ENDINGS", "WAITING", "heard_in", "hint", "in_words", "parameters", "timer_of", "timers", "whose"]

# RCLError: rclpy.shutdown() after Ctrl-C
ENDINGS: tuple[type[BaseException], ...] = (
    KeyboardInterrupt,
    ExternalShutdownException,
    ROSInterruptException,
    RCLError,
)
WAITING: Collection[CodeType] = (
    rclpy.spin.__code__,
    Executor.spin.__code__,
    Executor.spin_until_future_complete.__code__,
)


def timer_of(frame: FrameType) -> Any:
    """Return the timer that an executor calls in a frame, or None."""
    called = frame.f_locals["entity"] if frame.f_code is _call.__code__ else None
    return called if isinstance(called, Timer) else None


def timers(world: World, printers: Iterable[Any]) -> list[Watched]:
    """Return its nodes' timers without their Rates', and timers that have printed something and are gone."""
    nodes = [node for context in world.part(State).contexts for node in context.nodes]
    owners = {timer: node.full_name for node in nodes if (own := node.node()) for timer in own._timers}
    return [
        Watched(
            timer,
            timer._rosspin_source,
            False,
            timer._rosspin_cancelled or timer._rosspin_destroyed,
            timer._rosspin_period / NS,
            owners.get(timer, ""),
        )
        for timer in dict.fromkeys([*owners, *printers])
        if hasattr(timer, "_rosspin_source")
    ]


def heard_in(frame: FrameType) -> Any:
    """Return the message with which an executor calls a subscription back in a frame, or None."""
    if frame.f_code is not _call.__code__ or not isinstance(frame.f_locals["entity"], Subscription):
        return None
    return next(iter(frame.f_locals.get("args", ())), None)


def parameters(world: World) -> list[str]:
    """Return the parameters that its nodes have declared."""
    nodes = [node.node() for context in world.part(State).contexts for node in context.nodes]
    return sorted({name for node in nodes if node is not None for name in node._parameters})


def in_words(qos: QoSProfile) -> str:
    """Return the policies that an endpoint of a topic is often given."""
    return f"{qos.reliability.short_key}, {qos.durability.short_key}, depth {qos.depth}"


def whose(codes: Collection[CodeType]) -> str:
    """Return nothing: an exception in a callback ends the whole node."""
    return ""


def hint(error: BaseException, whose: str) -> str:
    """Return what may be behind an error that rclpy raises."""
    if isinstance(error, AttributeError) and str(error).startswith("'NoneType'"):
        return "This is None. The result of a future is None until the answer has come: use it in a done callback."
    return advice(error)
