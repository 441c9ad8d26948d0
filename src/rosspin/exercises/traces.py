"""Write down what the runs of an answer showed, and read it again in another Python.

A trace may come from anywhere. It is refused unless all of it has the right types, and is finite and small. Whether it
describes the runs of this answer cannot be seen: an answer that takes over the Python in which it runs can write down
whatever it likes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from json import dumps, loads
from types import NoneType, UnionType
from typing import Any, NamedTuple, get_args, get_origin, get_type_hints

from .observed import ObservedRun

__all__ = ["LONGEST", "LONGEST_TEXT", "Failure", "Misfit", "Outcome", "Request", "Trace", "read", "write"]

LONGEST = 2_000_000
"""A trace has at most so many characters."""

LONGEST_TEXT = 30_000
"""Each text in it has at most so many."""


class Misfit(ValueError):
    """A trace allows no verdict."""

    def __init__(self, why: str) -> None:
        super().__init__(f"The trace does not fit: {why}.")


class Request(NamedTuple):
    """What is asked of an answer: a run of ``seconds`` with the command line ``args``.

    SIGTERM may come before Ctrl-C, at ``terminated_at`` (s). With a ``seed`` the threads take turns at any point. From
    ``stalls_at`` (s) on, nothing of the answer runs for a while. ``variables`` are the names of variables to report.
    ``beside`` are the other nodes, each a process of its own, which continue if only the answer gets Ctrl-C, at
    ``interrupted_at`` (s).
    """

    seconds: float
    args: tuple[str, ...] = ()
    terminated_at: float | None = None
    seed: int | None = None
    stalls_at: float | None = None
    variables: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    interrupted_at: float | None = None


class Failure(NamedTuple):
    """Why an answer could not be run, and how to continue."""

    text: str
    hint: str


class Outcome(NamedTuple):
    """A request and what came of it: either ``run`` or ``failure``."""

    request: Request
    run: ObservedRun | None
    failure: Failure | None


class Trace(NamedTuple):
    """The outcomes of all requests to an answer to the exercise called ``name``, in their order.

    ``console`` is what the first run printed, as far as it is worth showing. ``cut`` says that something else did not.
    """

    name: str
    console: str
    cut: bool
    outcomes: tuple[Outcome, ...]


def write(trace: Trace) -> str:
    """Write a trace as JSON."""
    return dumps(trace, allow_nan=False, separators=(",", ":"))


def read(text: str, name: str) -> Trace:
    """Read the trace of an answer to an exercise. Raises :class:`Misfit` for anything else."""
    if not isinstance(text, str) or len(text) > LONGEST:
        raise Misfit("it is too long")
    try:
        trace = _read(Trace, loads(text))
    except (ValueError, TypeError, OverflowError, RecursionError) as error:
        raise Misfit("it is damaged") from error
    assert isinstance(trace, Trace)
    if trace.name != name:
        raise Misfit("it belongs to another exercise")
    for request, run, failure in trace.outcomes:
        if (run is None) is (failure is None) or (run and run.seconds != request.seconds):
            raise Misfit("it is damaged")
    return trace


def _read(kind: Any, data: Any) -> Any:
    """Turn data of JSON into ``kind``, the type of an annotation. Raises ValueError or TypeError if it does not fit."""
    if get_origin(kind) is UnionType:
        [other] = (each for each in get_args(kind) if each is not NoneType)
        return None if data is None else _read(other, data)
    if kind is float:
        # JSON has one kind of number.
        if type(data) not in (int, float) or not math.isfinite(data):
            raise ValueError(kind)
        return float(data)
    if kind in (str, int, bool):
        if type(data) is not kind or (kind is str and len(data) > LONGEST_TEXT) or (kind is int and abs(data) >> 63):
            raise ValueError(kind)
        return data
    if type(data) is not list:
        raise TypeError(kind)
    if get_origin(kind) is not tuple:
        return kind(*_read_each(_fields(kind), data))
    kinds = get_args(kind)
    return _read_each([kinds[0]] * len(data) if kinds[-1] is ... else kinds, data)


def _read_each(kinds: Sequence[Any], data: list[Any]) -> tuple[Any, ...]:
    return tuple(_read(kind, each) for kind, each in zip(kinds, data, strict=True))


@cache
def _fields(kind: Any) -> tuple[Any, ...]:
    return tuple(get_type_hints(kind).values())
