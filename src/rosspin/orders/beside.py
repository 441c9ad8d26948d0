"""Show two orders of one run side by side: what is different, in lines of the node."""

from __future__ import annotations

import linecache
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, islice, zip_longest
from pathlib import Path

from ..clocks.clock import NS
from ..clocks.explored import Order, Turn
from ..results.orders import Instant, Orders, Step

__all__ = ["instants", "side_by_side"]

# So many instants are shown in lines, with so many lines of each.
_INSTANTS = 3
_LINES = 16

_WIDTH = 60


def instants(usual: Order, failing: Order, start: int = 0) -> list[Instant]:
    """Return where two orders should be compared, after a run in each, from ``start`` (ns) on, that noted its turns."""
    columns = [_by_time(order.turns or ()) for order in (usual, failing)]
    several = len({turn.filename for column in columns for turns in column.values() for turn in turns}) > 1
    times = dict.fromkeys(deviation.time for deviation in failing.said)
    differ = (time for time in sorted({*columns[0], *columns[1]}) if columns[0].get(time) != columns[1].get(time))
    found = []
    for time in sorted({*times, *islice(differ, 1)}):
        steps = [[_step(turn, several) for turn in column.get(time, ())] for column in columns]
        chosen = [(each.usual, each.here) for each in failing.said if each.time == time]
        found.append(Instant((time - start) / NS, steps[0], steps[1], chosen))
    return found


def _by_time(turns: Iterable[Turn]) -> dict[int, list[Turn]]:
    """Group the turns by their times; of the same one in a row, only the first."""
    by_time: dict[int, list[Turn]] = {}
    for turn, _ in groupby(turns):
        by_time.setdefault(turn.time, []).append(turn)
    return by_time


def _step(turn: Turn, several: bool) -> Step:
    where = f"{Path(turn.filename).name}:{turn.line}" if several else f"{turn.line}"
    return Step(turn.thread, where, linecache.getline(turn.filename, turn.line).strip())


def side_by_side(orders: Orders) -> Iterator[str]:
    """Yield lines that show an order next to the usual one: their instants, and their consoles."""
    for instant in orders.instants:
        for usually, here in instant.deviations:
            yield f"  at {instant.time:.10g} s usually {usually}, here {here}"
    for instant in [each for each in orders.instants if each.differs is not None][:_INSTANTS]:
        rows = list(zip_longest(map(_say, instant.usual), map(_say, instant.here), fillvalue=""))
        start = max((instant.differs or 0) - 2, 0)
        yield from _table(f"at {instant.time:.10g} s", rows[start : start + _LINES])
        if len(rows) > start + _LINES:
            yield f"  ... and {len(rows) - start - _LINES} more lines at this time"
    consoles = [run.console.splitlines() if run else [] for run in (orders.usual, orders.here)]
    lines = zip_longest(*consoles, fillvalue="nothing more")
    for one, other in islice((row for row in lines if row[0] != row[1]), 1):
        yield from ("", "the first line in which the consoles differ", f"  usually  {one}", f"  here     {other}")


def _table(what: str, rows: Sequence[tuple[str, str]]) -> Iterator[str]:
    yield ""
    yield f"{f'{what}: the usual order':<{_WIDTH}} | this order"
    for one, other in rows:
        yield f"{_cut(one):<{_WIDTH}} {'|' if one == other else '*'} {_cut(other)}".rstrip()


def _cut(text: str) -> str:
    return text if len(text) <= _WIDTH else f"{text[: _WIDTH - 4]} ..."


def _say(step: Step) -> str:
    return f"{step.thread:<12} {step.line:>4}  {step.text}"
