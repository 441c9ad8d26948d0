"""The stand-ins are the same in the page: scenarios print in Chromium what they print in simulated time elsewhere.

Here a twentieth of them, and the examples; `make judge` runs all, in Firefox too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

from rosspin import Node, simulate
from tests.helpers import corpus_pairs, corpus_ros1, corpus_ros2
from tests.helpers.corpus import Scenario
from tests.helpers.corpus_checks import each
from tests.helpers.corpus_pairs import PAIR_LIST, Pair
from tests.helpers.ledger import SHARES
from tests.helpers.listings_in_page import lines_of
from tests.helpers.looks import faults
from tests.helpers.readers import reader
from tests.helpers.sandboxes import Sandbox, check
from tests.helpers.shares import SHARE, is_in
from tests.helpers.tree import ROOT


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    with reader(browser) as context:
        page = context.new_page()
        wrong = faults(page, address)
        page.goto(address + "docs/tutorial.html")
        yield page
        assert not wrong


@pytest.fixture(scope="module")
def in_page(page: Page, address: str) -> Sandbox:
    return Sandbox(page.evaluate, address, corpus_ros1.SCENARIOS)


@pytest.fixture(scope="module")
def ros2_in_page(page: Page, address: str) -> Sandbox:
    return Sandbox(page.evaluate, address, corpus_ros2.SCENARIOS)


def share(scenarios: Sequence[Scenario]) -> list[Scenario]:
    return [scenario for scenario in scenarios if is_in(scenario.name, SHARES, SHARE)]


@each(share(corpus_ros1.SCENARIO_LIST))
def test_scenario(in_page: Sandbox, scenario: Scenario) -> None:
    check(in_page, scenario)


@each(share(corpus_ros2.SCENARIO_LIST))
def test_scenario_of_ros2(ros2_in_page: Sandbox, scenario: Scenario) -> None:
    check(ros2_in_page, scenario)


@pytest.fixture(scope="module")
def pairs_in_page(page: Page, address: str) -> Sandbox:
    return Sandbox(page.evaluate, address, corpus_pairs.PAIRS)


@pytest.mark.parametrize("pair", PAIR_LIST, ids=lambda pair: pair.name)
def test_scenario_of_several_processes(pairs_in_page: Sandbox, pair: Pair) -> None:
    files = list(zip(pair.sources, pair.args, strict=True))
    run = simulate([Node(file, args) for file, args in files], 20)
    (text, name, args), *beside = [(file.read_text(encoding="utf-8"), file.name, args) for file, args in files]
    console, result = pairs_in_page.run(text, name, 20, args, beside)
    assert (lines_of(console), result["status"]) == (lines_of(run.console), run.status)
    assert result["ticks"] == [list(tick) for tick in run.ticks]


# Suspended threads, each deep in calls from C and back, and cyclic garbage that Python would collect meanwhile.
GARBAGE = """
import threading

import rospy


class Nested:
    def __init__(self, depth):
        self.depth = depth

    def __getattr__(self, name):
        if self.depth:
            return getattr(Nested(self.depth - 1), name)
        rospy.sleep(1)
        return name


rospy.init_node("collected")
for _ in range(2):
    threads = [threading.Thread(target=getattr, args=(Nested(20 * depth), "x")) for depth in range(5)]
    for thread in threads:
        thread.start()
    rospy.sleep(0.5)
    for _ in range(30_000):
        cycle = []
        cycle.append(cycle)
    for thread in threads:
        thread.join()
print("ended")
"""


def test_garbage_is_not_collected_while_stacks_are_suspended(in_page: Sandbox) -> None:
    assert in_page.run(GARBAGE, "garbage.py", 20, ())[0] == "ended\n"


NODES = [path for name in ("spinner", "pub", "eager", "slow") for path in sorted(ROOT.glob(f"examples/**/{name}*.py"))]


@pytest.mark.parametrize("path", NODES, ids=lambda path: path.name)
def test_example(in_page: Sandbox, path: Any) -> None:
    text = path.read_text(encoding="utf-8")
    args = ("--ros-args", "-r", "__ns:=/mrp") if "rclpy" in text else ("__ns:=/mrp",)
    run = simulate(path, 60, args)
    console, result = in_page.run(text, path.name, 60, args)
    assert console == run.console
    assert result["ticks"] == [list(tick) for tick in run.ticks]
