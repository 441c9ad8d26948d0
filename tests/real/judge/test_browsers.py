"""All scenarios in both browsers: they print there what they print in simulated time elsewhere."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser

from tests.helpers import corpus_ros1, corpus_ros2
from tests.helpers.corpus import Scenario
from tests.helpers.corpus_checks import each
from tests.helpers.firefox import firefox, tab
from tests.helpers.looks import faults
from tests.helpers.readers import reader
from tests.helpers.sandboxes import Evaluate, Sandbox, check

PAGE = "docs/tutorial.html"


@pytest.fixture(scope="module")
def in_chromium(request: pytest.FixtureRequest, address: str) -> Iterator[Evaluate]:
    browser: Browser = request.getfixturevalue("browser")
    with reader(browser) as context:
        page = context.new_page()
        wrong = faults(page, address)
        page.goto(address + PAGE)
        yield page.evaluate
        assert not wrong


@pytest.fixture(scope="module")
def in_firefox(require: Callable[[str], None], address: str) -> Iterator[Evaluate]:
    require("firefox")
    with tab(firefox() or "") as page:  # it tells of what the sandbox forbids Python; see tests/real/test_firefox.py
        page.open(address + PAGE)
        yield page.evaluate


@pytest.fixture(scope="module", params=["in_chromium", "in_firefox"])
def evaluate(request: pytest.FixtureRequest) -> Evaluate:
    found: Evaluate = request.getfixturevalue(request.param)
    return found


@pytest.fixture(scope="module")
def ros1(evaluate: Evaluate, address: str) -> Sandbox:
    return Sandbox(evaluate, address, corpus_ros1.SCENARIOS)


@pytest.fixture(scope="module")
def ros2(evaluate: Evaluate, address: str) -> Sandbox:
    return Sandbox(evaluate, address, corpus_ros2.SCENARIOS)


@each(corpus_ros1.SCENARIO_LIST)
def test_scenario(ros1: Sandbox, scenario: Scenario) -> None:
    check(ros1, scenario)


@each(corpus_ros2.SCENARIO_LIST)
def test_scenario_of_ros2(ros2: Sandbox, scenario: Scenario) -> None:
    check(ros2, scenario)
