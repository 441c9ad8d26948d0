"""Tests that say the same of many pages or nodes: another part of their cases goes round each day."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

import pytest


def waiting(items: Iterable[pytest.Item], turn: int) -> list[pytest.Item]:
    """Those whose turn it is not: of a test marked ``turns(n)``, all but an nth of its cases."""
    cases: Counter[str] = Counter()
    others = []
    for item in items:
        if mark := item.get_closest_marker("turns"):
            test = item.nodeid.partition("[")[0]
            (share,) = mark.args
            if cases[test] % share != turn % share:
                others.append(item)
            cases[test] += 1
    return others
