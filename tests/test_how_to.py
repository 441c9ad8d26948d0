"""The how-to pages: what they tell a reader to do works."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from conftest import ROOT

from rosspin import simulate
from rosspin.console import read_ticks
from rosspin.ros1 import Workspace

PAGES = ROOT / "docs" / "how-to"
PACKAGE = ROOT / "examples" / "my_robotics_pkg"


def _pytest(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def test_the_example_test_passes_by_the_commands_on_the_page(tmp_path: Path) -> None:
    page = (PAGES / "test-timing.rst").read_text(encoding="utf-8")
    *elsewhere, here = re.findall(r"^ +\$ (.*)", page, re.MULTILINE)
    run = _pytest(ROOT, *shlex.split(here.removeprefix(".venv/bin/python -m pytest")))
    assert run.returncode == 0, run.stdout
    assert "7 passed" in run.stdout

    # In a package of the reader's own, which knows nothing of this environment.
    shutil.copytree(PACKAGE, tmp_path, dirs_exist_ok=True)
    (tmp_path / "rosspin").symlink_to(ROOT)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    for command in elsewhere:
        run = subprocess.run(command, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True)
        if "NewConnectionError" in run.stderr:
            pytest.skip("pip can reach no package index")
        assert run.returncode == 0, run.stdout + run.stderr
    assert "7 passed" in run.stdout


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("spinner_py_node.py", "in_seconds = 0.5", "in_seconds = 0.6"),
        ("spinner_py_node.py", "rospy.spin()", "1 / 0"),
        ("spinner_param_py_node.py", '"~frequency"', '"frequency"'),
        ("spinner_param_py_node.py", "frequency_in_hz <= 0", "frequency_in_hz < 0"),
    ],
)
def test_the_example_test_fails_for_a_node_that_is_wrong(tmp_path: Path, file: str, old: str, new: str) -> None:
    shutil.copytree(PACKAGE, tmp_path, dirs_exist_ok=True)
    node = tmp_path / "src" / file
    assert old in node.read_text()
    node.write_text(node.read_text().replace(old, new))
    assert _pytest(tmp_path, "test").returncode == 1


class _AsInAPipe(Workspace):
    """Without the variables by which rosspin itself has lines shown at once."""

    @property
    def environment(self) -> dict[str, str]:
        ours = ("PYTHONUNBUFFERED", "ROSCONSOLE_STDOUT_LINE_BUFFERED")
        return {name: value for name, value in super().environment.items() if name not in ours}


@pytest.fixture(scope="module")
def ros1(require: Callable[[str], None]) -> Iterator[Workspace]:
    """A workspace on the real ROS with the package built, and a master."""
    require("ros1")
    with _AsInAPipe() as workspace:
        workspace.add_package(PACKAGE)
        workspace.build()
        workspace.start_master()
        yield workspace


@pytest.mark.parametrize("name", ["spinner_param_py_node.py", "spinner_param_cpp_node"])
def test_the_frequency_is_a_parameter_on_the_real_ros(ros1: Workspace, name: str) -> None:
    node = PACKAGE / "src" / name if name.endswith(".py") else next(ros1.folder.glob(f"devel/lib/*/{name}"))
    run = ros1.run([str(node), "_frequency:=5"], 2.0)
    stamps = [tick.real for tick in read_ticks(run.console)]
    assert run.status == 0
    assert min(later - earlier for earlier, later in pairwise(stamps)) < 0.35
    refused = ros1.run([str(node), "_frequency:=0"], 60.0)
    assert refused.status == 1
    assert "frequency must be above 0" in refused.console


def test_the_uneven_node_on_the_real_ros(ros1: Workspace) -> None:
    """The sixth call tells of the one that took long, as in simulated time."""
    node = ROOT / "examples" / "how-to" / "uneven_py_node.py"
    for console in (simulate(node, 0.9).console, ros1.run([str(node)], 2.0).console):
        assert re.search(r"counter = 6, [\d.]+ s after a call that took 0\.[2-9]", console)


class _UntilBothCount:
    """A console that presses Ctrl-C as soon as both nodes have been heard."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._heard: set[str] = set()

    def write(self, text: str) -> None:
        self._heard |= {tick.source for tick in read_ticks(text)}
        if len(self._heard) == 2:
            os.kill(self._workspace._children[-1].pid, signal.SIGINT)

    def flush(self) -> None:
        pass


def test_the_launch_file_shows_lines_at_once(ros1: Workspace) -> None:
    """Lines that came only at the end could not end the run: it would go on until the time is up."""
    file = PACKAGE / "launch" / "spinner_at_once.launch"
    command = [str(ros1.folder / "devel/env.sh"), "roslaunch", "-p", str(ros1.port), str(file)]
    run = ros1.run(command, 60.0, _UntilBothCount(ros1))  # type: ignore[arg-type]
    assert max(tick.number for tick in read_ticks(run.console)) < 60  # after 60 s it would be 120
