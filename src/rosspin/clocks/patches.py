"""Replace what modules hold, for a while: for the stacks of simulations, with the real thing for everybody else."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any

from .stacks import Stack, current

__all__ = ["Patch", "either", "patched"]

# A module or class, a name in it, and what makes the replacement out of what is there.
Patch = tuple[Any, str, Callable[[Any], Any]]


def either(virtual: Callable[..., Any]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """A replacement that calls ``virtual(stack, *args)`` from a stack of a simulation, the real one from elsewhere."""

    def replace(real: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(real)
        def dispatch(*args: Any, **kwargs: Any) -> Any:
            stack = current()
            return virtual(stack, *args, **kwargs) if isinstance(stack, Stack) else real(*args, **kwargs)

        return dispatch

    return replace


@contextmanager
def patched(patches: Iterable[Patch]) -> Iterator[None]:
    """Within this context the patches are in place; names that this version of Python has not are passed over."""
    before = [(place, name, vars(place)[name], replace) for place, name, replace in patches if name in vars(place)]
    for place, name, real, replace in before:
        setattr(place, name, replace(real))
    try:
        yield
    finally:
        for place, name, real, _ in before:
            setattr(place, name, real)
