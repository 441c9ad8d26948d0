"""The timing probes in C++: their simulated ticks next to the real ones'."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rosspin import Tick

LATE = 0.1  # s: a fifth of the period; no two rules are that close

# What a probe calls itself, by the name of its callback.
_SOURCES = {
    **dict.fromkeys(("callback", "lambda"), "timerCallback"),
    **dict.fromkeys(("callback 2", "lambda 2"), "secondCallback"),
}


def differences(simulated: Sequence[Tick], real: Sequence[Tick]) -> list[str]:
    """Where the ticks of a real one are others than the simulated ones, by the clock or by their own account."""
    found = [f"{len(simulated)} ticks, not {len(real)}"] if abs(len(simulated) - len(real)) > 1 else []
    before: dict[str, float] = {}
    for ours, theirs in zip(simulated, real, strict=False):
        # When a call begins just as the next is due, jitter decides whether that one is lost.
        is_tie = abs(ours.expected - before.get(ours.source, math.nan)) < 1e-6
        is_off = abs(ours.real - theirs.real) > LATE or (abs(ours.expected - theirs.expected) > LATE and not is_tie)
        if is_off or (_SOURCES.get(ours.source, ours.source), ours.number) != (theirs.source, theirs.number):
            found.append(f"{ours}, not {theirs}")
        before[ours.source] = ours.real
    return found
