"""What holds the corpus of scenarios together: ledger, shares, expectations, verdicts on runs, and who may begin."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from . import admission, corpus_checks, corpus_ros1, corpus_ros2, expectations, ledger, runs, sandboxes
from .corpus import Scenario, recorded, simulated
from .corpus_pairs import PAIR_LIST
from .ledger import Ledger
from .shares import is_left_out
from .verdicts import Inconclusive

ALL = [*corpus_ros1.SCENARIO_LIST, *corpus_ros2.SCENARIO_LIST]
BY_NAME = {scenario.name: scenario for scenario in ALL}

# --- the ledger -------------------------------------------------------------------------------------------------------


def test_the_ledger_is_read_as_it_was_written(tmp_path: Path) -> None:
    found = Ledger({1: {}, 2: {}}, {"a_race": [3, 1], "mishaps on ros2": [2]})
    for each in ALL[::50]:
        found.confirm(each, "rospy 1.15.15" if each.ros == 1 else "Jazzy")
    found.write(tmp_path / "ledger.toml")
    assert Ledger.read(tmp_path / "ledger.toml") == found
    assert Ledger.read(tmp_path / "none.toml") == Ledger({1: {}, 2: {}}, {})


def test_the_real_ros_runs_each_scenario_in_one_of_twenty_shares() -> None:
    chosen = [ledger.part(corpus_ros1.SCENARIO_LIST, share) for share in range(ledger.SHARES)]
    assert all(0 < len(each) < len(corpus_ros1.SCENARIO_LIST) / 8 for each in chosen)
    names = [scenario.name for each in chosen for scenario in each]
    assert sorted(names) == sorted(scenario.name for scenario in corpus_ros1.SCENARIO_LIST)


def test_the_share_of_a_test_follows_from_its_name_alone(request: pytest.FixtureRequest) -> None:
    def case(name: str, *marks: pytest.MarkDecorator) -> pytest.Item:
        item = pytest.Function.from_parent(request.node.parent, name=name, callobj=lambda: None)
        for mark in marks:
            item.add_marker(mark)
        return item

    whole = case("whole")
    cases = [case(f"{test}[{n}]", pytest.mark.shares(of)) for test, of in (("a", 4), ("b", 5)) for n in range(11)]
    runs = [[share for share in range(20) if not is_left_out(each, share)] for each in (whole, *cases)]
    assert [len(each) for each in runs] == [20] + [5] * 11 + [4] * 11
    assert len({first for first, *_ in runs[1:12]}) > 1  # a test's are spread


# --- expectations -----------------------------------------------------------------------------------------------------


def test_each_expectation_says_why_and_is_of_scenarios_that_there_are() -> None:
    entries = [entry for kind in expectations.ALL.values() for entry in kind]
    assert all(entry.outcomes and entry.reason and entry.link.startswith("https://") for entry in entries)
    assert {name for entry in entries for name in entry.scenarios} <= {*BY_NAME, *(pair.name for pair in PAIR_LIST)}
    where = {
        "ros1",
        "ros2",
        "kilted",
        "wall",
        "page",
        "roslaunch",
        "several processes in one run",
        *corpus_checks.STAND_INS.values(),
    }
    assert {entry.where for entry in entries} <= where | {*corpus_checks.STAND_INS.values()}


# --- verdicts on runs -------------------------------------------------------------------------------------------------

GRID = BY_NAME["timer_grid"]
SHOWN_AS_ENUM = BY_NAME["timer_clocks"]


@pytest.fixture
def console() -> Callable[[Scenario], str]:
    """The console of a run as it is recorded."""
    return lambda scenario: scenario.recordings[0].read_text()


def test_a_run_as_recorded_passes_even_if_it_was_disturbed(console: Callable[[Scenario], str]) -> None:
    runs.check("ros2", GRID, console(GRID))
    runs.check("ros2", GRID, console(GRID) + "@stall 0.300\n")


def test_a_difference_fails_and_tells_nothing_of_a_run_that_was_disturbed(console: Callable[[Scenario], str]) -> None:
    other = console(GRID) + "one more line\n"
    with pytest.raises(AssertionError, match="one more line"):
        runs.check("ros2", GRID, other)
    with pytest.raises(Inconclusive, match=r"stood still for 0\.300 s on ros2"):
        runs.check("ros2", GRID, other + "@stall 0.300\n@stall 0.020\n")


def test_a_difference_that_is_expected_has_to_happen(console: Callable[[Scenario], str]) -> None:
    runs.check("kilted", SHOWN_AS_ENUM, console(SHOWN_AS_ENUM) + "another line\n")
    with pytest.raises(AssertionError, match="no longer happens"):
        runs.check("kilted", SHOWN_AS_ENUM, console(SHOWN_AS_ENUM))


def test_a_run_that_met_a_race_of_any_node_tells_nothing(console: Callable[[Scenario], str]) -> None:
    for runtime in ("ros2", "kilted"):
        with pytest.raises(Inconclusive, match="a race that any node may meet"):
            runs.check(runtime, GRID, console(GRID) + "Exception ignored in: <function Task.__del__ at 0x1>\n")
    own = BY_NAME["context_own"]  # calls shutdown() twice, and prints what comes of it
    assert "rcl_shutdown already called" in console(own)
    runs.check("ros2", own, console(own))


def test_the_control_beside_tells_of_stalls_within_a_run(monkeypatch: pytest.MonkeyPatch) -> None:
    now = 100.0
    monkeypatch.setattr("tests.helpers.runs.time.monotonic", lambda: now)
    beside = runs._Beside()
    for took in (0.025, 0.5, 0.3, 0.025):  # it should be called every 25 ms
        now += took
        beside.called(took, 0.0)
    assert beside.since(100.0) == pytest.approx(0.8)
    assert beside.since(100.6) == pytest.approx(0.225)
    assert beside.since(100.9) == 0.0


def test_on_the_wall_a_race_may_come_out_in_each_way() -> None:
    assert runs.exact("wall", GRID) == [simulated(GRID)]
    race = BY_NAME["executor_multi_raises"]
    assert runs.exact("wall", race) == [simulated(race), *recorded(race)]


def test_a_page_that_says_something_else_fails() -> None:
    scenario = BY_NAME["values_time"]

    def evaluate(function: str, argument: object) -> object:
        return ["something else\n", {"status": 0}]

    sandbox = sandboxes.Sandbox(evaluate, "", corpus_ros1.SCENARIOS)
    with pytest.raises(AssertionError, match="something else"):
        sandboxes.check(sandbox, scenario)
    sandboxes.check(sandbox, BY_NAME["threads_idents"])


# --- who may begin ----------------------------------------------------------------------------------------------------


def test_a_run_begins_once_a_processor_is_free_or_all_have_waited_for_long(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = iter([0.1, 0.2, 1.4])
    monkeypatch.setattr(admission, "_free", lambda: next(seen))
    admission.Admission(10.0).wait()
    assert list(seen) == []

    monkeypatch.setattr(admission, "_free", lambda: 0.0)
    door = admission.Admission(2.5 * admission.WINDOW)
    door.wait()
    assert door._patience <= 0
    door = admission.Admission(10.0)
    door.open()
    door.wait()
