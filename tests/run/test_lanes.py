"""The simulated lane is what it is called: a test that needs more is an error there."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import pytest

from rosspin import measure, simulate
from tests.helpers.simulated_only import OutOfLane, simulated_only
from tests.helpers.tree import ROOT

NODE = "import rospy\nrospy.init_node('node')\n"

REAL: dict[str, Callable[[Any], object]] = {
    "it sleeps for 0.001 s": lambda write: time.sleep(0.001),
    "it starts shellfish": lambda write: subprocess.run(["shellfish"]),  # which begins like sh
    "it starts sleep": lambda write: subprocess.run(["sleep", "0"]),
    "it runs a node on the wall clock: ": lambda write: measure(lambda: None, 1),
    "it runs a node on the wall": lambda write: measure(write(NODE), 1),
}


@pytest.mark.parametrize("said", REAL)
def test_what_is_real_is_refused(write: Any, said: str) -> None:
    with pytest.raises(OutOfLane, match=said), simulated_only():
        REAL[said](write)


def test_it_is_refused_even_if_the_test_catches_it() -> None:
    with pytest.raises(OutOfLane, match="belongs into tests/real"), simulated_only():
        with suppress(OutOfLane):
            time.sleep(0.001)


def test_what_is_simulated_is_not_refused(write: Any) -> None:
    with simulated_only():
        assert simulate(write(f"{NODE}import time\ntime.sleep(1)\n"), 2).status == 0
        time.sleep(0)


@pytest.mark.parametrize(("given", "seed"), [({}, 0), ({"ROSSPIN_SEED": ""}, 0), ({"ROSSPIN_SEED": "3"}, 3)])
def test_the_seed_is_the_same_each_time_unless_another_is_asked_for(given: dict[str, str], seed: int) -> None:
    assert _seed(given) == seed


def test_a_random_seed_is_drawn_once() -> None:
    one, other = (_seed({"ROSSPIN_SEED": "random"}) for _ in range(2))
    assert one != other


def _seed(given: dict[str, str]) -> int:
    """The seed in a process, which a process that this one starts has, too."""
    code = "import os, subprocess, sys; from tests.helpers import seeds; print(seeds.SEED, flush=True)\n"
    code += "if len(sys.argv) < 3: subprocess.run([sys.executable, '-c', sys.argv[1], '', ''], check=True)"
    environment = {name: value for name, value in os.environ.items() if name != "ROSSPIN_SEED"} | given
    command = [sys.executable, "-c", code, code]
    run = subprocess.run(command, env=environment | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    first, second = run.stdout.split()
    assert first == second
    return int(first)


@pytest.mark.parametrize("fixture", ["require", "chromium", "browser", "address"])
def test_it_has_no_fixture_for_what_is_real(request: pytest.FixtureRequest, fixture: str) -> None:
    with pytest.raises(pytest.FixtureLookupError):
        request.getfixturevalue(fixture)
