"""Which orders to try, one after the other."""

from __future__ import annotations

import random
from collections.abc import Callable, Hashable, Iterator, Sequence
from itertools import count, islice

from ..clocks.explored import Order

__all__ = ["STRATEGIES", "Strategy", "bound_of_pct"]

# PCT looks for faults that need at most so many things in a certain order: a run for 1, one for 2, one for 3, ...
_DEPTHS = 3

# So many orders at first are tried together; then twice as many each time, up to the greatest number.
_FIRST, _GREATEST = 30, 960

Strategy = Callable[[Order, int, bool], Iterator[list[Order]]]
"""Is given the usual order, after its run, a seed, and whether to be deep. Yields the orders to try, several together,
which may be run at the same time: all of them are run before the next are asked for. Which they are does not depend on
how many processes run them."""


def _sizes() -> Iterator[int]:
    return (min(_FIRST << number, _GREATEST) for number in count())


def fewest_first(usual: Order, seed: int, deep: bool) -> Iterator[list[Order]]:
    """Yield all orders: first those that deviate once from the usual one, then twice, ...

    Source: iterative context bounding, in Musuvathi and Qadeer, "Iterative context bounding for systematic testing of
    multithreaded programs" (PLDI 2007), as in CHESS. There preemptions are counted, here deviations.
    """
    level, sizes = [usual], _sizes()
    while level:
        orders, level = (order for before in level for order in _once_more(before, deep)), []
        while batch := list(islice(orders, next(sizes))):
            yield batch
            level += batch


def _once_more(before: Order, deep: bool) -> Iterator[Order]:
    """Yield the orders that deviate once more than one that was run, later in the run."""
    last = max(before.made, default=-1)
    test_points = [point for point in before.test_points if last < 0 and point < min(before.made, default=0)]
    points = range(last + 1, len(before.options))
    choices = [(point, choice) for point in points for choice in range(1, before.options[point])]
    for point, choice in (*((point, 1) for point in test_points), *choices):
        yield Order({**before.made, point: choice}, deep=deep)


def at_random(usual: Order, seed: int, deep: bool) -> Iterator[list[Order]]:
    """Yield orders in which everything that may be next is equally likely, at each point."""
    number = count()
    for size in _sizes():
        yield [Order(decide=_Random(_draw(seed, next(number))), deep=deep) for _ in range(size)]


class _Draw(random.Random):
    """Draws for one order.

    It may be sent to a process while a thread runs nodes there, each of which has a ``random`` of its own: there pickle
    finds this class, but not Python's.
    """


def _draw(seed: int, number: int) -> _Draw:
    """Make what draws for one order, whatever is drawn for the others."""
    return _Draw(f"{seed} {number}")


class _Random:
    """Decides at random."""

    def __init__(self, draw: _Draw) -> None:
        self._draw = draw

    def __call__(self, point: int, options: Sequence[Hashable]) -> int:
        return self._draw.randrange(len(options))


def by_priority(usual: Order, seed: int, deep: bool) -> Iterator[list[Order]]:
    """Yield orders in which the thread with the highest of random priorities continues. These change at random points.

    Source: PCT, in Burckhardt, Kothari, Musuvathi and Nagarakatte, a "scheduler with probabilistic guarantees of
    finding bugs" (ASPLOS 2010), algorithm 1. Of things that are no threads, such as what an executor has seen, one has
    the highest priority likewise.
    """
    longest, number = len(usual.options), count()
    for size in _sizes():
        batch = []
        for order in islice(number, size):
            decide = _Priorities(_draw(seed, order), longest, order % _DEPTHS)
            batch.append(Order(decide=decide, deep=deep))
        yield batch
        longest = max(longest, *(len(order.options) for order in batch))


class _Priorities:
    """Decides by priorities drawn at random, of which so many change at one of so many points."""

    def __init__(self, draw: _Draw, points: int, changes: int) -> None:
        self._draw = draw
        self._of: dict[Hashable, float] = {}
        self._changing = set(draw.sample(range(points), min(changes, points)))

    def __call__(self, point: int, options: Sequence[Hashable]) -> int:
        of = self._of
        for option in options:
            of.setdefault(option, self._draw.random())
        first = max(range(len(options)), key=lambda place: of[options[place]])
        if point in self._changing:
            self._changing.discard(point)
            of[options[first]] = -1.0 - len(self._changing)  # below all; of two that fell, the first is the lower
            first = max(range(len(options)), key=lambda place: of[options[place]])
        return first


def bound_of_pct(threads: int, points: int, schedules: int, depth: int) -> float:
    """Return the least probability with which ``schedules`` runs of PCT find a fault of a depth.

    The first run is in the usual order; the others take turns with the depths. Each of that depth finds it with at
    least 1 / (n k^(depth - 1)), for n threads and k points (theorem 9 there).
    """
    once = 1 / (max(threads, 1) * max(points, 1) ** (depth - 1))
    return float(1 - (1 - once) ** ((schedules - 1 + _DEPTHS - depth) // _DEPTHS))


STRATEGIES: dict[str, Strategy] = {"all": fewest_first, "pct": by_priority, "random": at_random}
