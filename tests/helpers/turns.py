"""Tests that say the same of many pages or nodes: another part of their cases goes round each day."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from zlib import crc32

import pytest


def waiting(items: Iterable[pytest.Item], turn: int) -> list[pytest.Item]:
    """Those whose turn it is not: of what is marked ``turns(n)``, a test or a file, all but an nth of its cases."""
    cases: Counter[str] = Counter()
    others = []
    for item in items:
        if found := next(item.iter_markers_with_node("turns"), None):
            marked, mark = found
            (share,) = mark.args
            name = marked.nodeid.partition("[")[0]
            # A file whose only test takes turns is not the first of its round on the same day as all others.
            if (cases[name] + crc32(name.encode())) % share != turn % share:
                others.append(item)
            cases[name] += 1
    return others
