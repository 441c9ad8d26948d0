"""Launch files are held to the real roslaunch: the same files and nodes there, and in one simulated run.

Each line names its node. Lines of different nodes come in any order on a real machine, so what is compared is what each
node prints, in its order, and what roslaunch says of each.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest
from lacking import LACKS
from outcomes import watching
from tree import TESTS

from rosspin import ros1, simulate

PACKAGE = TESTS / "launched"
FILES = sorted(path.stem for path in (PACKAGE / "launch").glob("*.launch"))

ARGS = {"arguments": ["name:=other", "number:=8"]}
SECONDS = 8.0  # when Ctrl-C comes; all is done by then, so that it does not matter when the processes have started
LONGER = {"queue_size_none": 14.0, "queue_size_3": 10.0, "respawn": 12.0}
AT_ONCE = 4
TRIES = 5

# A race of the real one: a node ends while another one connects to it.
_ENDED_MEANWHILE = r"\[WARN\] \[[\d.]+\]: Inbound TCP/IP connection failed: connection from sender terminated before"

# What roslaunch says of itself, and what the simulation says instead.
_OF_ROSLAUNCH = re.compile(
    r"^(?:\.\.\. |log file: |shutting down processing monitor|done|started core service|process\[.*started with pid"
    r"|setting /run_id|INFO: cannot create a symlink|rosspin: |@stall|" + _ENDED_MEANWHILE + r").*\n",
    re.MULTILINE,
)


def _outcome(console: str) -> dict[str, list[str]]:
    """The lines of a console by who has printed them."""
    text = re.sub(r"\x1b\[\d*m", "", console)
    text = _OF_ROSLAUNCH.sub("", text)
    text = re.sub(r"pid \d+, |, pid \d+| __log:=[^]\s]+", "", text)
    text = re.sub(r"\S*/launched/nodes/", "", text)
    text = re.sub(r"\[\d+\.\d{6}\]", "[STAMP]", text)
    text = re.sub(r'^  File "(\w+\.py)", (line \d+.*)\n(?:    .*\n)*', r"  \1, \2\n", text, flags=re.MULTILINE)
    found: dict[str, list[str]] = {}
    for line in text.splitlines():
        speaker = re.match(r"(/[\w/]+:)|\[([\w/]+-\d+)\]", line)
        found.setdefault(speaker[0] if speaker else "", []).append(line)
    return {speaker: lines if speaker else sorted(filter(None, lines)) for speaker, lines in found.items()}


def _seconds(name: str) -> float:
    return LONGER.get(name, SECONDS)


def _on_roslaunch(package: Path, name: str) -> tuple[int, dict[str, list[str]], bool]:
    with ros1.Workspace() as workspace:
        workspace.start_master()
        file = str(package / "launch" / f"{name}.launch")
        command = ["roslaunch", "--disable-title", "--skip-log-check", "--no-summary", file, *ARGS.get(name, [])]
        begins = re.compile(r"process\[.*started with pid")
        with watching() as stalled:
            output = workspace.run(command, _seconds(name), begins=begins, patience=ros1._LAUNCH_PATIENCE)
    console = output.console.partition("ROS_MASTER_URI=")[2].partition("\n")[2]
    return output.status, _outcome(console), stalled.is_set() or "@stall" in console


def _simulated(name: str) -> dict[str, list[str]]:
    run = simulate(PACKAGE / "launch" / f"{name}.launch", _seconds(name), ARGS.get(name, []))
    assert run.status == 0
    return _outcome(run.console)


@pytest.fixture(scope="module")
def real(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Future[list[str]]]]:
    """For each file, how the real outcome differs from the simulated one."""
    if LACKS["ros1"]():
        yield {}
        return
    package = tmp_path_factory.mktemp("src") / "launched"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    with pytest.MonkeyPatch.context() as patch, ThreadPoolExecutor(AT_ONCE) as pool:
        patch.setenv("ROS_PACKAGE_PATH", f"{package.parent}:{os.environ.get('ROS_PACKAGE_PATH', '/usr/share')}")

        def differences(name: str, exact: dict[str, list[str]]) -> list[str]:
            for _ in range(TRIES):
                status, outcome, stalled = _on_roslaunch(package, name)
                speakers = sorted({**outcome, **exact})
                found = [f"status {status}"] if status else []
                found += [
                    f"{speaker}: {outcome.get(speaker)} for {exact.get(speaker)}"
                    for speaker in speakers
                    if outcome.get(speaker, []) != exact.get(speaker, [])
                ]
                if not found or not stalled:
                    break
            return found

        try:
            yield {name: pool.submit(differences, name, _simulated(name)) for name in FILES}
        finally:
            pool.shutdown(cancel_futures=True)


@pytest.mark.parametrize("name", FILES)
def test_a_launch_file_runs_as_on_roslaunch(
    real: dict[str, Future[list[str]]], require: Callable[[str], None], name: str
) -> None:
    require("ros1")
    assert "\n".join(real[name].result()) == ""
