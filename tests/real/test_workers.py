"""What others' processes do, on a cluster: exploring, and judging answers."""

from __future__ import annotations

import dataclasses
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup
from distributed import Client, LocalCluster

import rosspin
from benchmarks.planted_orders import PLANTS
from rosspin.__main__ import main
from tests.helpers.answers import CELLS, WRONG, written
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)

BROKEN = "%%answer two-timers\n1 / 0"


@pytest.fixture(scope="module")
def executor() -> Iterator[Executor]:
    """A cluster's, of two processes, of which each does two things at a time."""
    with (
        LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None) as cluster,  # type: ignore[no-untyped-call]
        Client(cluster) as client,  # type: ignore[no-untyped-call]
        client.get_executor() as executor,
    ):
        yield executor


@pytest.mark.parametrize("strategy", ["pct", "random"])
@pytest.mark.parametrize("mended", [False, True])
def test_a_cluster_finds_what_is_found_without(executor: Executor, tmp_path: Path, strategy: str, mended: bool) -> None:
    plant = PLANTS["ros2-who-begins"]
    planted = plant.write(tmp_path, mended=mended)
    arguments: dict[str, Any] = {"schedules": 60, "strategy": strategy}
    alone = rosspin.explore(planted, plant.seconds, plant.check, **arguments)
    found = rosspin.explore(planted, plant.seconds, plant.check, executor=executor, **arguments)
    assert dataclasses.replace(found, orders=None) == dataclasses.replace(alone, orders=None)
    assert bool(found.failure) is not mended


@pytest.mark.parametrize("workers", ["concurrent.futures:ProcessPoolExecutor", "cluster:workers"])
def test_the_verdicts_are_the_same_wherever_answers_are_judged(
    workers: str, tmp_path: Path, require: Callable[[str], None]
) -> None:
    require("bwrap")
    shutil.copy(EXAMPLES / "grading" / "cluster.py", tmp_path)
    wrong = written("slow-timer", WRONG["slow-timer"][0][0])
    for student, answers in {
        "ada": {name: CELLS[name][1].source for name in ("slow-timer", "two-timers")},
        "ben": {"slow-timer": wrong, "two-timers": BROKEN},
    }.items():
        (tmp_path / "class" / student).mkdir(parents=True)
        for name, text in answers.items():
            (tmp_path / "class" / student / f"{name}.py").write_text(text)
    found = []
    for words in ([], ["--workers", workers]):
        command = [sys.executable, "-m", "rosspin", "judge", "class", "--json", *words]
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
        assert run.returncode == 1, run.stderr
        found.append(run.stdout)
    assert found[0] == found[1]
    assert [found[0].count(f'"verdict": "{verdict}"') for verdict in ("solved", "not yet", "not judged")] == [2, 2, 0]


def test_the_program_of_the_page_finds_what_the_page_shows(site: Path) -> None:
    page = BeautifulSoup((site / "docs/how-to/find-the-order.html").read_text(encoding="utf-8"), "html.parser")
    folder = EXAMPLES / "orders" / "ros2"
    run = subprocess.run([sys.executable, "explore_parts.py"], cwd=folder, capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[1].startswith("In the shortest order found, ")
    assert run.stdout.splitlines()[1] in page.get_text()


@pytest.mark.parametrize(
    ("workers", "why"),
    [
        ("json", "write MODULE:NAME, as in concurrent.futures:ProcessPoolExecutor"),
        ("json:nothing", "module 'json' has no attribute 'nothing'"),
        ("nothing_of_this:name", "No module named 'nothing_of_this'"),
        ("os:getpid", "this is no concurrent.futures.Executor, but "),
        ("os:sep", "'str' object is not callable"),
    ],
)
def test_what_is_no_executor_is_refused(
    workers: str, why: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["judge", str(tmp_path), "--workers", workers]) == 1
    assert capsys.readouterr().err.startswith(f"rosspin: --workers {workers}: {why}")
