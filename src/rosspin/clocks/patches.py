"""Replace names in modules for a while: stacks of simulations get the replacement, all other code the real thing."""

from __future__ import annotations

import builtins
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import lru_cache, wraps
from operator import is_
from typing import Any

from .stacks import Stack, current

__all__ = ["Builtins", "Patch", "either", "patched"]

# A module or class, a name in it, and a function that makes the replacement from what is there.
Patch = tuple[Any, str, Callable[[Any], Any]]


def either(virtual: Callable[..., Any]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Make a replacement that calls ``virtual(stack, *args)`` on a stack of a simulation, the real thing elsewhere."""

    @lru_cache(maxsize=2)
    def replace(real: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(real)
        def dispatch(*args: Any, **kwargs: Any) -> Any:
            stack = current()
            return virtual(stack, *args, **kwargs) if isinstance(stack, Stack) else real(*args, **kwargs)

        return dispatch

    return replace


@contextmanager
def patched(patches: Iterable[Patch]) -> Iterator[None]:
    """Within this context the patches are in place; names that this version of Python lacks are skipped."""
    before = [(place, name, vars(place)[name], replace) for place, name, replace in patches if name in vars(place)]
    for place, name, real, replace in before:
        setattr(place, name, replace(real))
    try:
        yield
    finally:
        for place, name, real, _ in before:
            setattr(place, name, real)


class Builtins:
    """A context that confines what code does to the built-in names: at its end they are as they were before.

    When it is entered again, the names are as the code left them. Its end uses none of them: they may be replaced.
    """

    def __init__(self) -> None:
        self._names = vars(builtins)
        self._outside = self._inside = self._names.copy()

    def __enter__(self) -> None:
        before, self._outside = self._outside, self._names.copy()
        if self._inside is not before:
            self._put(self._inside)

    def __exit__(self, *_: object) -> None:
        self._inside = self._names.copy()
        self._put(self._outside)
        inside, outside = self._inside, self._outside
        if len(inside) == len(outside) and all(map(is_, inside.values(), outside.values())):
            self._inside = outside

    def _put(self, names: dict[str, Any]) -> None:
        self._names.update(names)
        for name in [*self._names]:
            if name not in names:
                del self._names[name]
