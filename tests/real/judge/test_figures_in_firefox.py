"""All figures with a handle in Firefox."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from figures import Kind, kinds
from figures_in_firefox import moves
from firefox import Tab, firefox, tab


@pytest.fixture(scope="module")
def page(require: Callable[[str], None]) -> Iterator[Tab]:
    require("firefox")
    with tab(firefox() or "") as page:
        page.resize(1280, 800)
        yield page
        assert not page.wrong


@kinds
def test_a_figure_moves(page: Tab, address: str, kind: Kind) -> None:
    moves(page, address, kind)
