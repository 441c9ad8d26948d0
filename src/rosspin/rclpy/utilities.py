"""Small functions that ``rclpy`` itself offers, too (source: rclpy/utilities.py)."""

from __future__ import annotations

import os

from ..clocks.clock import NS
from .arguments import Arguments
from .context import Context, get_default_context, state

__all__ = [
    "get_available_rmw_implementations",
    "get_default_context",
    "get_rmw_implementation_identifier",
    "ok",
    "remove_ros_args",
    "shutdown",
    "timeout_sec_to_nsec",
    "try_shutdown",
]


def ok(*, context: Context | None = None) -> bool:
    """Whether a context (default: the default one) is valid."""
    return (context or get_default_context()).ok()


def shutdown(*, context: Context | None = None) -> None:
    """End a context. Raises what :func:`rclpy.shutdown` raises."""
    (context or get_default_context(shutting_down=True)).shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """End a context unless it has ended. After the default one, ``init`` makes a new one."""
    if context is not None:
        context.try_shutdown()
        return
    context = get_default_context()
    context.try_shutdown()
    if state().default is context:
        state().default = None


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """Return a command line (default: the process's) without the words for ROS."""
    return Arguments(state().world.argv if args is None else args).rest


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout in ns; -1 (no limit) for None or one below 0."""
    return -1 if timeout_sec is None or timeout_sec < 0 else int(float(timeout_sec) * NS)


def get_rmw_implementation_identifier() -> str:
    """The middleware that Jazzy has by default."""
    return "rmw_fastrtps_cpp"


def get_available_rmw_implementations() -> set[str]:
    """Return the middlewares that are there, of those that the variable RMW_IMPLEMENTATIONS names if it names any.

    Raises RuntimeError if it names one that is not there.
    """
    available = {get_rmw_implementation_identifier()}
    names = os.environ.get("RMW_IMPLEMENTATIONS")
    if not names:
        return available
    wanted = set(names.split(os.pathsep))
    if missing := wanted - available:
        raise RuntimeError(
            f"The RMW implementations {missing} specified in 'RMW_IMPLEMENTATIONS' are not available "
            f"({', '.join(sorted(available))})"
        )
    return available & wanted
