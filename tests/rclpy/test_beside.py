"""Packages next to rclpy that are in no package index, compared with what their own code printed on the real rclpy."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosspin import simulate
from tests.helpers.python_texts import of_any_python
from tests.helpers.runtimes import kept

NODES = sorted((Path(__file__).parent / "beside").glob("*.py"))


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_it_prints_what_the_real_one_has_printed(node: Path) -> None:
    real = node.with_suffix(".txt").read_text(encoding="utf-8")
    assert of_any_python(kept(simulate(node, 10).console)) == of_any_python(kept(real))
