"""All scenarios of several processes on the real ROS 2: what is not recorded is, what is must be confirmed.

If it is a scenario or the real one that has changed, delete the recordings.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.helpers.corpus_pairs import LEDGER, PAIR_LIST, Pair, differing, read, recorded, run
from tests.helpers.ledger import Ledger
from tests.helpers.runtimes import version
from tests.helpers.verdicts import control

BEARS = 0.05  # s that a process may stand still


@pytest.fixture(scope="module")
def ledger() -> Iterator[Ledger]:
    ledger = Ledger.read(LEDGER)
    yield ledger
    ledger.write(LEDGER)


@pytest.mark.parametrize("pair", PAIR_LIST, ids=lambda pair: pair.name)
def test_the_real_one_does_what_is_recorded(ledger: Ledger, require: Callable[[str], None], pair: Pair) -> None:
    require("ros2")
    with control(BEARS):
        texts = run(pair)
        if pair.recordings:
            assert differing(recorded(pair), read(texts)) == []
        else:
            pair.record(texts)
    ledger.confirm(pair, version("ros2"))
