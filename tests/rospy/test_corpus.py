"""The stand-in for rospy is compared with the real one: in simulated time each scenario does what is recorded of it."""

from __future__ import annotations

from tests.helpers.corpus_checks import check_late, check_recorded, check_whole, each
from tests.helpers.corpus_ros1 import SCENARIO_LIST, SCENARIOS, Scenario


@each(SCENARIO_LIST)
def test_a_scenario_does_what_is_recorded(scenario: Scenario) -> None:
    check_recorded(scenario)


@each([scenario for scenario in SCENARIO_LIST if scenario.is_timed])
def test_a_little_lateness_changes_no_scenario(scenario: Scenario) -> None:
    check_late(scenario)


def test_the_corpus_is_whole() -> None:
    check_whole(SCENARIO_LIST, SCENARIOS)
