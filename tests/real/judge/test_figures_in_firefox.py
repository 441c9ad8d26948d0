"""All figures with a handle in Firefox."""

from __future__ import annotations

from tests.helpers.figures import Kind, kinds
from tests.helpers.figures_in_firefox import moves
from tests.helpers.firefox import Tab


@kinds
def test_a_figure_moves(firefox_page: Tab, address: str, kind: Kind) -> None:
    moves(firefox_page, address, kind)
