"""What is said of a node on a machine that has too much to do."""

from __future__ import annotations

from time import perf_counter

import pytest

from rosspin import TimeStandsStill, simulate
from rosspin.clocks import watchdog


def test_a_node_that_works_is_not_said_to_wait_because_the_machine_is_busy(
    impatient: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The kernel says that it has a processor for a tenth of the time, and stands in line for one in the rest."""

    def node() -> None:
        while True:
            pass

    share = 0.1
    assert share < watchdog._BUSY
    begun = perf_counter()

    def scheduled(watcher: object) -> tuple[float, float]:
        passed = perf_counter() - begun
        return share * passed, (1 - share) * passed

    monkeypatch.setattr(watchdog._FromAThread, "_scheduled_until_now", scheduled)
    with pytest.raises(TimeStandsStill, match="keeps running without sleeping"):
        simulate(node, 1)
    # As many looks as ever at its own time, which is a tenth of what has passed.
    assert share * (perf_counter() - begun) > 0.8 * watchdog._LOOKS * watchdog._INTERVAL
