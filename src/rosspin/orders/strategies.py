"""Which orders to try, one after the other."""

from __future__ import annotations

import random
from collections.abc import Callable, Hashable, Iterator, Sequence

from ..clocks.explored import Decide, Order

__all__ = ["STRATEGIES", "Strategy", "bound_of_pct"]

# PCT looks for faults that need at most so many things in a certain order: a run for 1, one for 2, one for 3, ...
_DEPTHS = 3

Strategy = Callable[[Order, int, bool], Iterator[Order]]
"""Is given the usual order, after its run, a seed, and whether to be deep. Yields the orders to try, each of which is
run before the next is asked for."""


def fewest_first(usual: Order, seed: int, deep: bool) -> Iterator[Order]:
    """Yield all orders: first those that deviate once from the usual one, then twice, ...

    Source: iterative context bounding, in Musuvathi and Qadeer, "Iterative context bounding for systematic testing of
    multithreaded programs" (PLDI 2007), as in CHESS. There preemptions are counted, here deviations.
    """
    level = [usual]
    while level:
        following = []
        for before in level:
            last = max(before.made, default=-1)
            ends = [point for point in before.ends if last < 0 and point < min(before.made, default=0)]
            points = range(last + 1, len(before.options))
            choices = [(point, choice) for point in points for choice in range(1, before.options[point])]
            for point, choice in (*((point, 1) for point in ends), *choices):
                order = Order({**before.made, point: choice}, deep=deep)
                yield order
                following.append(order)
        level = following


def at_random(usual: Order, seed: int, deep: bool) -> Iterator[Order]:
    """Yield orders in which everything that may be next is equally likely, at each point."""
    draw = random.Random(seed)
    while True:
        yield Order(decide=lambda point, options: draw.randrange(len(options)), deep=deep)


def by_priority(usual: Order, seed: int, deep: bool) -> Iterator[Order]:
    """Yield orders in which the thread with the highest of random priorities goes on. These change at random points.

    Source: PCT, in Burckhardt, Kothari, Musuvathi and Nagarakatte, a "scheduler with probabilistic guarantees of
    finding bugs" (ASPLOS 2010), algorithm 1. Of things that are no threads, such as what an executor has seen, one has
    the highest priority likewise.
    """
    draw = random.Random(seed)
    longest, number = len(usual.options), 0
    while True:
        order = Order(decide=_priorities(draw, longest, number % _DEPTHS), deep=deep)
        yield order
        longest, number = max(longest, len(order.options)), number + 1


def _priorities(draw: random.Random, points: int, changes: int) -> Decide:
    of: dict[Hashable, float] = {}
    changing = set(draw.sample(range(points), min(changes, points)))

    def decide(point: int, options: Sequence[Hashable]) -> int:
        for option in options:
            of.setdefault(option, draw.random())
        first = max(range(len(options)), key=lambda place: of[options[place]])
        if point in changing:
            changing.discard(point)
            of[options[first]] = -1.0 - len(changing)  # below all others; of two that fell, the first is the lower
            first = max(range(len(options)), key=lambda place: of[options[place]])
        return first

    return decide


def bound_of_pct(threads: int, points: int, schedules: int, depth: int) -> float:
    """Return the least probability with which ``schedules`` runs of PCT find a fault of a depth.

    The first run is in the usual order; the others take turns with the depths. Each of that depth finds it with at
    least 1 / (n k^(depth - 1)), for n threads and k points (theorem 9 there).
    """
    once = 1 / (max(threads, 1) * max(points, 1) ** (depth - 1))
    return float(1 - (1 - once) ** ((schedules - 1 + _DEPTHS - depth) // _DEPTHS))


STRATEGIES: dict[str, Strategy] = {"all": fewest_first, "pct": by_priority, "random": at_random}
