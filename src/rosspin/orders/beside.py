"""Show two orders of one run side by side: what is different, in lines of the node."""

from __future__ import annotations

import linecache
from collections.abc import Iterator, Sequence
from itertools import groupby, islice, zip_longest
from pathlib import Path

from ..clocks.clock import NS
from ..clocks.explored import Order, Turn

__all__ = ["side_by_side"]

# So many instants are shown, with so many lines of each.
_INSTANTS = 3
_LINES = 16

_WIDTH = 60


def side_by_side(usual: tuple[Order, str], failing: tuple[Order, str]) -> Iterator[str]:
    """Yield lines that show an order beside the usual one. Of each, take the order, after its run, and the console."""
    orders = usual[0], failing[0]
    for time, usually, here in failing[0].said:
        yield f"  at {time / NS:.10g} s usually {usually}, here {here}"
    instants = dict.fromkeys(deviation.time for deviation in failing[0].said)
    for time in list(instants)[:_INSTANTS]:
        columns = [_turns(order.turns or (), time) for order in orders]
        rows = list(zip_longest(columns[0], columns[1], fillvalue=""))
        differ = next((place for place, (one, other) in enumerate(rows) if one != other), None)
        if differ is not None:
            start = max(differ - 2, 0)
            yield from _table(f"at {time / NS:.10g} s", rows[start : start + _LINES])
            if len(rows) > start + _LINES:
                yield f"  ... and {len(rows) - start - _LINES} more lines at this time"
    consoles = zip_longest(usual[1].splitlines(), failing[1].splitlines(), fillvalue="nothing more")
    for one, other in islice((row for row in consoles if row[0] != row[1]), 1):
        yield from ("", "the first line in which the consoles differ", f"  usually  {one}", f"  here     {other}")


def _table(what: str, rows: Sequence[tuple[str, str]]) -> Iterator[str]:
    yield ""
    yield f"{f'{what}: the usual order':<{_WIDTH}} | this order"
    for one, other in rows:
        yield f"{_cut(one):<{_WIDTH}} {'|' if one == other else '*'} {_cut(other)}".rstrip()


def _cut(text: str) -> str:
    return text if len(text) <= _WIDTH else f"{text[: _WIDTH - 4]} ..."


def _turns(turns: Sequence[Turn], time: int) -> list[str]:
    """The lines that were run at a time, each once in a row."""
    at = [turn for turn in turns if turn.time == time]
    several = len({turn.filename for turn in turns}) > 1
    return [_say(turn, several) for turn, _ in groupby(at)]


def _say(turn: Turn, several: bool) -> str:
    line = linecache.getline(turn.filename, turn.line).strip()
    where = f"{Path(turn.filename).name}:{turn.line}" if several else f"{turn.line}"
    return f"{turn.thread:<12} {where:>4}  {line}"
