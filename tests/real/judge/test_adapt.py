"""An author changes a node as the how-to says, in a copy with all pages, whose notebooks measure on the wall clock."""

from __future__ import annotations

import re
from pathlib import Path

from tests.helpers.author import copied, go_the_way


def test_the_how_to_is_a_way_through_all_pages(tmp_path: Path) -> None:
    listed = go_the_way(copied(tmp_path), runs_timer=True)
    assert re.search(r"^docs/how-timing-works\.rst:\d+$", listed, re.MULTILINE)
