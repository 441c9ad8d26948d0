"""What the figures with a handle carry is what runs give; that pages show it is in real/page/test_figures.py."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.built_pages import parsed
from tests.helpers.figures import Kind, check_rows, kinds
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)


def shown(row: list[Any], first: float, span: float) -> dict[str, Any]:
    """A row as a page draws it: across in percent."""
    name, words, _, lost, ticks = row
    return {
        "drawn_by": "the page",
        "name": name,
        "words": words,
        "marks": [100 * (real - first) / span for real, _ in ticks],
        "bars": [100 * duration / span for _, duration in ticks if duration],
        "crosses": lost,
    }


@kinds
def test_rows_are_those_of_runs(site: Path, kind: Kind) -> None:
    """At the first, the last and some other positions."""
    page = parsed(site / kind.page)
    carried = json.loads(str(page.select("figure[data-positions]")[kind.number]["data-positions"]))
    first, span, positions = carried["first"], carried["span"], carried["positions"]
    assert len(positions) > 5
    for value, _, alternative, rows in [*positions[:-1:5], positions[-1]]:
        check_rows(kind, float(value), [shown(row, first, span) for row in rows], alternative, span)


def test_handles_go_from_their_first_number_to_their_last(site: Path) -> None:
    for source in [ROOT / "index.rst", *ROOT.glob("docs/**/*.rst")]:
        words = re.findall(r"(?m)^   :handle: .+, (\S+) to (\S+) by", source.read_text(encoding="utf-8"))
        page = parsed(site / source.relative_to(ROOT).with_suffix(".html"))
        carried = [json.loads(str(figure["data-positions"])) for figure in page.select("figure[data-positions]")]
        ends = [[float(found["positions"][end][0]) for end in (0, -1)] for found in carried]
        assert ends == [[float(word) for word in each] for each in words], source
