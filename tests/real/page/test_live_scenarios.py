"""The stand-ins are the same in the page: scenarios print in Chromium what they print in simulated time elsewhere."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest import mock

import corpus_ros1
import corpus_ros2
import pytest
from listings_in_page import lines_of
from looks import faults
from playwright.sync_api import Browser
from tree import ROOT

from rosspin import simulate

# Jobs for one sandbox of those that the page's cells use; what one prints and how it ended.
RUN_JOBS = """async address => {
    const { Sandbox } = await import(address)
    const sandbox = new Sandbox()
    await sandbox.started
    window.runJob = job => new Promise(resolve => {
        let console = ""
        sandbox.do({ kind: "run", ...job }, message => {
            if (message.kind === "batch") console += message.chunks.map(([, text]) => text).join("")
            if (message.kind === "end") resolve([console, message.result])
            if (message.kind === "failed") resolve([message.reason, null])
        })
    })
}"""

# Beside the scenarios stand modules that they share, and files.
PRELUDE = """
import pathlib
for name, text in {files}.items():
    path = pathlib.Path(name)
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
"""

# What cannot be the same in a page, and why.
LEFT_OUT = {
    "values_anonymous": "an anonymous name is made from the number of the process",
    "threads_idents": "threads have no native ident there",
    "ctrl_c_threads_no_signals_join": "an interrupted join marks a thread as ended before Python 3.13",
}

RunInPage = Callable[[str, str, float, Sequence[str]], tuple[str, dict[str, Any]]]


@contextmanager
def a_sandbox(browser: Browser, address: str, folder: Path, *beside: str) -> Iterator[RunInPage]:
    """Run texts as nodes in the page, each with its file name, seconds and args: their consoles and results.

    All runs share one sandbox, in which nodes find the files of a folder that match one of the patterns ``beside``.
    """
    paths = [path for pattern in beside for path in folder.glob(pattern)]
    files = {str(path.relative_to(folder)): path.read_text(encoding="utf-8") for path in paths}
    with browser.new_context() as context:
        page = context.new_page()
        wrong = faults(page, address)
        page.goto(address + "docs/tutorial.html")

        def begin() -> None:
            page.evaluate(RUN_JOBS, f"{address}_static/live/runs.js")
            run(PRELUDE.format(files=files), "prelude.py", 1, ())

        def run(source: str, name: str, seconds: float, args: Sequence[str]) -> tuple[str, dict[str, Any]]:
            job = {"source": source, "filename": name, "seconds": seconds, "args": shlex.join(args), "speed": 0}
            console, result = page.evaluate("job => runJob(job)", job)
            if result is None:  # Python broke down; the next run needs another
                begin()
            return console, result or {}

        begin()
        yield run
        assert not wrong


@pytest.fixture(scope="module")
def run_in_page(browser: Browser, address: str) -> Iterator[RunInPage]:
    with a_sandbox(browser, address, corpus_ros1.SCENARIOS, "scenario.py", "robot/*.py") as run:
        yield run


@pytest.fixture(scope="module")
def run_ros2_in_page(browser: Browser, address: str) -> Iterator[RunInPage]:
    with a_sandbox(browser, address, corpus_ros2.SCENARIOS, "scenario.py", "*.yaml") as run:
        yield run


def chosen(scenarios: Sequence[Any]) -> pytest.MarkDecorator:
    """The scenarios that can be the same in the page."""
    found = [scenario for scenario in scenarios if scenario.file not in LEFT_OUT]
    return pytest.mark.parametrize("scenario", found, ids=lambda scenario: scenario.name)


def is_the_same(run_in_page: RunInPage, path: Path, seconds: float, args: Sequence[str]) -> None:
    """A node prints the same in the page, has the same ticks and ends with the same status."""
    with mock.patch.dict(os.environ):
        run = simulate(path, seconds, args)
    console, result = run_in_page(path.read_text(encoding="utf-8"), path.name, seconds, args)
    assert lines_of(console) == lines_of(run.console)
    assert result["status"] == run.status
    assert [tick[:4] for tick in result.get("ticks", ())] == [list(tick[:4]) for tick in run.ticks]


@chosen(corpus_ros1.SCENARIO_LIST)
def test_scenario(run_in_page: RunInPage, scenario: corpus_ros1.Scenario) -> None:
    path = corpus_ros1.SCENARIOS / f"{scenario.file}.py"
    is_the_same(run_in_page, path, scenario.end or corpus_ros1.LONGEST, scenario.args)


@chosen(corpus_ros2.SCENARIO_LIST)
def test_scenario_of_ros2(run_ros2_in_page: RunInPage, scenario: corpus_ros2.Scenario) -> None:
    is_the_same(run_ros2_in_page, scenario.path, scenario.end or corpus_ros2.LONGEST, scenario.args)


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


def test_garbage_is_not_collected_while_stacks_are_suspended(run_in_page: RunInPage) -> None:
    assert run_in_page(GARBAGE, "garbage.py", 20, ())[0] == "ended\n"


NODES = [path for name in ("spinner", "pub", "eager", "slow") for path in sorted(ROOT.glob(f"examples/**/{name}*.py"))]


@pytest.mark.parametrize("path", NODES, ids=lambda path: path.name)
def test_example(run_in_page: RunInPage, path: Any) -> None:
    text = path.read_text(encoding="utf-8")
    args = ("--ros-args", "-r", "__ns:=/mrp") if "rclpy" in text else ("__ns:=/mrp",)
    run = simulate(path, 60, args)
    console, result = run_in_page(text, path.name, 60, args)
    assert console == run.console
    assert result["ticks"] == [list(tick) for tick in run.ticks]
