"""While a simulation runs, ``time.sleep`` and the clocks of the ``time`` module are the simulation's for its stacks."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .clock import nanoseconds
from .rospy.world import NotSimulated
from .simulation import Simulation, running

__all__ = ["virtual_time"]


def _sleep(simulation: Simulation, seconds: float) -> None:
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    simulation.sleep(nanoseconds(seconds))


def _seconds(simulation: Simulation) -> float:
    return simulation.now() / 1e9


def _no_thread(simulation: Simulation, thread: threading.Thread) -> None:
    raise NotSimulated("threading.Thread")


def _dispatch(real: Callable[..., Any], virtual: Callable[..., Any]) -> Callable[..., Any]:
    """Call ``virtual`` from a stack of a simulation, ``real`` from everywhere else."""

    def either(*args: Any) -> Any:
        simulation = running.get()
        return real(*args) if simulation is None else virtual(simulation, *args)

    either.__name__ = real.__name__
    either.__doc__ = real.__doc__
    return either


_PATCHES = [
    (time, "sleep", _dispatch(time.sleep, _sleep)),
    (time, "time", _dispatch(time.time, _seconds)),
    (time, "time_ns", _dispatch(time.time_ns, Simulation.now)),
    (time, "monotonic", _dispatch(time.monotonic, _seconds)),
    (time, "monotonic_ns", _dispatch(time.monotonic_ns, Simulation.now)),
    (time, "perf_counter", _dispatch(time.perf_counter, _seconds)),
    (time, "perf_counter_ns", _dispatch(time.perf_counter_ns, Simulation.now)),
    (threading.Thread, "start", _dispatch(threading.Thread.start, _no_thread)),
]


@contextmanager
def virtual_time() -> Iterator[None]:
    """Within this context the ``time`` module is virtual for the stacks of simulations."""
    before = [(place, name, getattr(place, name)) for place, name, _ in _PATCHES]
    for place, name, patch in _PATCHES:
        setattr(place, name, patch)
    try:
        yield
    finally:
        for place, name, original in before:
            setattr(place, name, original)
