"""An author changes a node as the how-to says, by its commands, in a copy with the pages that follow from the node."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.helpers.author import copied, go_the_way

pytestmark = pytest.mark.shares(10)

# Enough for the way of the how-to; all pages go it in tests/real/judge.
FEW_PAGES = [
    *(f"docs/tutorial{page}.rst" for page in ("", "-timer", "-launch", "-rate")),
    *("docs/reference/launch-files.rst", "docs/glossary.rst"),
    *("notebooks/timer.md", "notebooks/rate.md"),
]


def test_the_how_to_is_a_way_through(tmp_path: Path) -> None:
    go_the_way(copied(tmp_path, FEW_PAGES), runs_timer=False)
