"""The stand-in is the same in the page: each scenario prints in Chromium what it prints in simulated time elsewhere."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Iterator
from typing import Any
from unittest import mock

import pytest
from conftest import ROOT, faults
from playwright.sync_api import Browser
from test_ros1_differential import LONGEST, SCENARIO_LIST, SCENARIOS, Scenario

from rosspin import simulate

# Jobs for the worker that the page's cells use; what one prints and how it ended.
RUN_JOBS = """address => {
    const worker = new Worker(address, { type: "module" })
    window.runJob = job => new Promise(resolve => {
        let console = ""
        worker.onmessage = ({ data }) => {
            if (data.kind === "batch") console += data.chunks.map(([, text]) => text).join("")
            if (data.kind === "end") resolve([console, data.result])
            if (data.kind === "failed") resolve([data.reason, null])
        }
        worker.postMessage(job)
    })
}"""

# Beside the scenarios stands a module that they share, and a package.
PRELUDE = """
import pathlib, site
for name, text in {files}.items():
    path = pathlib.Path(site.getsitepackages()[0], name)
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
"""
FILES = {
    str(path.relative_to(SCENARIOS)): path.read_text(encoding="utf-8")
    for path in (SCENARIOS / "scenario.py", *SCENARIOS.glob("robot/*.py"))
}

# An anonymous name is made from the number of the process; threads have no native ident in a page; an interrupted join
# marks a thread as ended before Python 3.13.
LEFT_OUT = {"values_anonymous", "threads_idents", "ctrl_c_threads_no_signals_join"}
CHOSEN = [scenario for scenario in SCENARIO_LIST if scenario.file not in LEFT_OUT]


@pytest.fixture(scope="module")
def run_in_page(browser: Browser, address: str) -> Iterator[Callable[..., tuple[str, dict[str, Any]]]]:
    """Run a text as a node in the page: its console and its result. All runs share one worker."""
    with browser.new_context() as context:
        page = context.new_page()
        wrong = faults(page, address)
        page.goto(address + "docs/tutorial.html")

        def begin() -> None:
            page.evaluate(RUN_JOBS, f"{address}_static/live/worker.js")
            run(PRELUDE.format(files=FILES), "prelude.py", 1)

        def run(source: str, name: str, seconds: float, args: tuple[str, ...] = ()) -> tuple[str, dict[str, Any]]:
            job = {"source": source, "filename": name, "seconds": seconds, "args": shlex.join(args), "speed": 0}
            console, result = page.evaluate("job => runJob(job)", job)
            if result is None:  # Python broke down; the next run needs another
                begin()
            return console, result or {}

        begin()
        yield run
        assert not wrong


# What the page adds at the end, for a reader who does not know what the error means.
HINTS = (
    "Nothing can have a frequency",
    "The period of a rospy.Timer is a Duration",
    "Pass a timer the callback",
    "A subscriber passes",
    "Pass a sub",
)


def lines_of(console: str) -> list[str]:
    """The lines of a console, without what depends on Python's version: code in tracebacks, one message."""
    text = re.sub(r'^(  File ").*?([^/"]+", line .*)\n(?:    .*\n)*', r"\1\2\n", console, flags=re.MULTILINE)
    text = re.sub(r'^  File "threading\.py", .*\n', "", text, flags=re.M)
    text = re.sub(r"^(rosspin: .*?) (was at|had done) .*", r"\1", text, flags=re.M)  # the page has no neighbours there
    text = text.replace("float division by zero", "division by zero")
    return [line for line in text.splitlines() if not line.startswith(HINTS)]


@pytest.mark.parametrize("scenario", CHOSEN, ids=lambda scenario: scenario.name)
def test_scenario(run_in_page: Callable[..., tuple[str, dict[str, Any]]], scenario: Scenario) -> None:
    path = SCENARIOS / f"{scenario.file}.py"
    seconds = scenario.end or LONGEST
    with mock.patch.dict(os.environ):
        run = simulate(path, seconds, scenario.args)
    console, result = run_in_page(path.read_text(encoding="utf-8"), path.name, seconds, scenario.args)
    assert lines_of(console) == lines_of(run.console)
    assert result["status"] == run.status
    ticks = [list(tick[:4]) for tick in run.ticks]
    assert [tick[:4] for tick in result.get("ticks", ())] == ticks


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


def test_garbage_is_not_collected_while_stacks_are_suspended(
    run_in_page: Callable[..., tuple[str, dict[str, Any]]],
) -> None:
    assert run_in_page(GARBAGE, "garbage.py", 20)[0] == "ended\n"


NODES = [path for name in ("spinner", "pub", "eager", "slow") for path in sorted(ROOT.glob(f"examples/**/{name}*.py"))]


@pytest.mark.parametrize("path", NODES, ids=lambda path: path.name)
def test_example(run_in_page: Callable[..., tuple[str, dict[str, Any]]], path: Any) -> None:
    run = simulate(path, 60, ["__ns:=/mrp"])
    console, result = run_in_page(path.read_text(encoding="utf-8"), path.name, 60, ("__ns:=/mrp",))
    assert console == run.console
    assert result["ticks"] == [list(tick) for tick in run.ticks]
