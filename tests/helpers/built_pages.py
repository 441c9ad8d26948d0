"""The pages of the built site, each parsed once for all tests of a process. Tests read them, and change nothing."""

from __future__ import annotations

import gc
from functools import cache
from pathlib import Path

from bs4 import BeautifulSoup


@cache
def parsed(path: Path) -> BeautifulSoup:
    """A page, by its path."""
    page = BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")
    gc.freeze()  # it stays
    return page
