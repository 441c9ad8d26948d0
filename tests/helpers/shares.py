"""Fixed shares of tests that say the same of many pages or nodes; which one a test is in follows from its name."""

from __future__ import annotations

import os
from zlib import crc32

import pytest

# Which share of them runs, from 0 on; a number that is too large begins from 0 again.
SHARE = int(os.environ.get("ROSSPIN_SHARE") or 0)


def is_in(name: str, shares: int, share: int) -> bool:
    """Whether a name belongs to a share, of so many."""
    return crc32(name.encode()) % shares == share % shares


def is_left_out(item: pytest.Item, share: int) -> bool:
    """Whether a test is in another share; only one that is marked ``shares(n)``, itself or its file, can be."""
    mark = item.get_closest_marker("shares")
    return mark is not None and not is_in(item.nodeid, mark.args[0], share)
