"""On the real ROS 1 and 2 and on the wall clock: a twentieth of the scenarios, chosen by their names.

The real ones do what is recorded of the scenarios, the stand-ins on the wall clock what they do in simulated time.
`make judge` runs all scenarios.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.helpers import corpus_ros1, corpus_ros2
from tests.helpers.corpus import Scenario
from tests.helpers.lacking import LACKS
from tests.helpers.ledger import part
from tests.helpers.runs import Runs, asked_for, check
from tests.helpers.runtimes import RUNTIMES

CASES = [
    (runtime, scenario)
    for scenario in part([*corpus_ros1.SCENARIO_LIST, *corpus_ros2.SCENARIO_LIST])
    for runtime in RUNTIMES[scenario.ros]
]


@pytest.fixture(scope="module")
def runs(request: pytest.FixtureRequest) -> Iterator[Runs]:
    """Runs of those scenarios that are asked for."""
    cases = [(asked["runtime"], asked["scenario"]) for asked in asked_for(request)]
    with Runs({runtime for runtime, _ in cases}, cases) as runs:
        yield runs


@pytest.mark.parametrize("runtime, scenario", CASES, ids=[f"{runtime}-{scenario.name}" for runtime, scenario in CASES])
def test_scenario(runs: Runs, require: Callable[[str], None], runtime: str, scenario: Scenario) -> None:
    if runtime in LACKS:
        require(runtime)
    check(runtime, scenario, runs.console(runtime, scenario))
