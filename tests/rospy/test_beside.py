"""Packages beside rospy, held to what the real ones have printed."""

from __future__ import annotations

from pathlib import Path

import pytest
from runtimes import kept

from rosspin import simulate

NODES = sorted((Path(__file__).parent / "beside").glob("*.py"))


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_it_prints_what_the_real_one_has_printed(node: Path) -> None:
    assert kept(simulate(node, 60, start=1_700_000_000).console) == kept(
        node.with_suffix(".txt").read_text(encoding="utf-8")
    )
