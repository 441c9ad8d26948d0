"""Launch files on the real roslaunch, and the same files and nodes in one simulated run.

Each line names its node. Lines of different nodes come in any order on a real machine, so what is compared is what each
node prints, in its order, and what roslaunch says of each.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Collection, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from unittest import mock

from rosspin import simulate
from rosspin.real import ros1

from . import expectations
from .admission import Admission
from .tree import TESTS
from .verdicts import inconclusive

PACKAGE = TESTS / "launched"
FILES = sorted(path.stem for path in (PACKAGE / "launch").glob("*.launch"))

ARGS = {"arguments": ["name:=other", "number:=8"]}
SECONDS = 8.0  # when Ctrl-C comes; all is done by then, so that it does not matter when the processes have started
LONGER = {"queue_size_none": 14.0, "queue_size_3": 10.0, "respawn": 12.0}
AT_MOST = 4

# What roslaunch says of itself, and what the simulation says instead.
_OF_ROSLAUNCH = re.compile(
    r"^(?:\.\.\. |log file: |shutting down processing monitor|done|started core service|process\[.*started with pid"
    r"|setting /run_id|INFO: cannot create a symlink|rosspin: |@stall|"
    rf"{expectations.mishaps('roslaunch').pattern}).*\n",
    re.MULTILINE,
)

Said = dict[str, list[str]]


class Real:
    """The consoles of launch files on roslaunch, with its status. Those named at first are run ahead."""

    def __init__(self, package: Path, names: Collection[str], pool: ThreadPoolExecutor, patience: float) -> None:
        self._package = package
        self._admission = Admission(patience)
        self._begun = {name: pool.submit(self._run, name) for name in names}

    def console(self, name: str) -> tuple[int, str]:
        """The exit status of roslaunch, and what was printed."""
        return self._begun.pop(name).result() if name in self._begun else self._run(name)

    def _run(self, name: str) -> tuple[int, str]:
        self._admission.wait()
        with ros1.Workspace() as workspace:
            workspace.start_master()
            file = str(self._package / "launch" / f"{name}.launch")
            command = ["roslaunch", "--disable-title", "--skip-log-check", "--no-summary", file, *ARGS.get(name, [])]
            begins = re.compile(r"process\[.*started with pid")
            output = workspace.run(command, _seconds(name), begins=begins, ending=ros1._LAUNCH)
        return output.status, output.console.partition("ROS_MASTER_URI=")[2].partition("\n")[2]


@contextmanager
def on_roslaunch(folder: Path, names: Collection[str], patience: float = 0.0) -> Iterator[Real]:
    """Launch files run there; no more wait for a free processor than ``patience`` (s) together."""
    package = folder / "launched"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    path = f"{folder}:{os.environ.get('ROS_PACKAGE_PATH', '/usr/share')}"
    given = {"ROS_PACKAGE_PATH": path, "PYTHONUNBUFFERED": "1"}  # which a launch file asks for
    with mock.patch.dict(os.environ, given), ThreadPoolExecutor(AT_MOST) as pool:
        try:
            yield Real(package, names, pool, patience)
        finally:
            pool.shutdown(cancel_futures=True)


def check(real: Real, name: str) -> None:
    """A launch file did there what it does in simulated time."""
    status, console = real.console(name)
    run = simulate(PACKAGE / "launch" / f"{name}.launch", _seconds(name), ARGS.get(name, []))
    assert run.status == 0
    said, exact = _said(console), _said(run.console)
    found = [f"status {status}"] if status else []
    found += [
        f"{speaker}: {said.get(speaker)} for {exact.get(speaker)}"
        for speaker in sorted({**said, **exact})
        if said.get(speaker, []) != exact.get(speaker, [])
    ]
    if found and "@stall" in console:
        inconclusive(f"a node of {name}.launch stood still: {found}")
    assert not found, "\n".join(found)


def _seconds(name: str) -> float:
    return LONGER.get(name, SECONDS)


def _said(console: str) -> Said:
    """The lines of a console by who has printed them."""
    text = re.sub(r"\x1b\[\d*m", "", console)
    text = _OF_ROSLAUNCH.sub("", text)
    text = re.sub(r"pid \d+, |, pid \d+| __log:=[^]\s]+", "", text)
    text = re.sub(r"\S*/launched/nodes/", "", text)
    text = re.sub(r"\[\d+\.\d{6}\]", "[STAMP]", text)
    text = re.sub(r'^  File "(\w+\.py)", (line \d+.*)\n(?:    .*\n)*', r"  \1, \2\n", text, flags=re.MULTILINE)
    found: Said = {}
    for line in text.splitlines():
        speaker = re.match(r"(/[\w/]+:)|\[([\w/]+-\d+)\]", line)
        found.setdefault(speaker[0] if speaker else "", []).append(line)
    return {speaker: lines if speaker else sorted(filter(None, lines)) for speaker, lines in found.items()}
