"""What is said of a node on a machine that has too much to do."""

from __future__ import annotations

import os
import subprocess

import pytest

from rosspin import TimeStandsStill, simulate


@pytest.mark.skipif(
    not os.path.exists("/proc/self/schedstat"), reason="only Linux tells how long a thread stood in line"
)
def test_a_node_that_works_is_not_said_to_wait_because_the_machine_is_busy(impatient: None) -> None:
    def node() -> None:
        while True:
            pass

    others = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(10 * (os.cpu_count() or 1))]
    try:
        with pytest.raises(TimeStandsStill, match="keeps running without sleeping"):
            simulate(node, 1)
    finally:
        for other in others:
            other.kill()
            other.wait()
