"""Several processes of ROS 2 in one run are compared with the real ones: each does what is recorded of it."""

from __future__ import annotations

import pytest

from tests.helpers import expectations
from tests.helpers.corpus_pairs import LEDGER, PAIR_LIST, PAIRS, Pair, differing, recorded, simulated
from tests.helpers.ledger import Ledger


@pytest.mark.parametrize("pair", PAIR_LIST, ids=lambda pair: pair.name)
def test_the_processes_do_what_is_recorded(pair: Pair) -> None:
    differs = pair.name in expectations.differences("several processes in one run")
    found = differing(simulated(pair), recorded(pair))
    assert bool(found) == differs, found


def test_the_corpus_is_whole() -> None:
    files = {file.stem for file in (PAIRS / "recorded").glob("*.txt")}
    assert files == {file.stem for pair in PAIR_LIST for file in pair.sources}
    assert Ledger.read(LEDGER).entries[2].keys() == {pair.name for pair in PAIR_LIST}
    assert {file.stem for file in PAIRS.glob("*.py")} - files == {"scenario"}
