"""The how-to pages on a real ROS, and where output comes at once: what they tell a reader to do works."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup

from rosspin import simulate
from rosspin.real import ros2
from rosspin.real.ros1 import Workspace
from rosspin.results.console import read_ticks
from tests.helpers.cpp_nodes import CppNodes
from tests.helpers.launches import NEVER, Until, launch, launch_past
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(10)

PACKAGE = ROOT / "examples" / "my_robotics_pkg"
PACKAGE_ROS2 = ROOT / "examples" / "my_robotics_pkg_ros2"


def test_the_example_test_passes_in_a_package_of_the_reader_s_own(site: Path, tmp_path: Path) -> None:
    """By the commands on the page; the package knows nothing of this environment."""
    page = BeautifulSoup((site / "docs/how-to/test-timing.html").read_text(encoding="utf-8"), "html.parser")
    shown = "\n".join(tag.get_text() for tag in page.select(".highlight-console pre"))
    *elsewhere, _ = re.findall(r"^\$ (.*)", shown, re.MULTILINE)
    shutil.copytree(ROOT / "examples" / "controller", tmp_path, dirs_exist_ok=True)
    (tmp_path / "rosspin").symlink_to(ROOT)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    for command in elsewhere:
        run = subprocess.run(command, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True)
        if "NewConnectionError" in run.stderr:
            pytest.skip("pip can reach no package index")
        assert run.returncode == 0, run.stdout + run.stderr
    assert "2 passed" in run.stdout
    # So the wheel, with what it asks for from a package index, also runs a node in a folder with nothing else.
    shutil.copy(PACKAGE / "src" / "spinner_py_node.py", tmp_path / "test")
    command = [tmp_path / ".venv/bin/rosspin", "run", "spinner_py_node.py", "--simulated", "--seconds", "1"]
    run = subprocess.run(command, cwd=tmp_path / "test", env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert [line[-11:] for line in run.stdout.splitlines()[1:]] == ["counter = 1", "counter = 2"]


class _AsInAPipe(Workspace):
    """Without the variables by which rosspin itself has lines shown at once."""

    @property
    def environment(self) -> dict[str, str]:
        ours = ("PYTHONUNBUFFERED", "ROSCONSOLE_STDOUT_LINE_BUFFERED")
        return {name: value for name, value in super().environment.items() if name not in ours}


@pytest.fixture(scope="module")
def ros1(require: Callable[[str], None]) -> Iterator[Workspace]:
    """A workspace on the real ROS, and a master."""
    require("ros1")
    with _AsInAPipe() as workspace:
        workspace.start_master()
        yield workspace


@pytest.mark.parametrize("name", ["spinner_param_py_node.py", "spinner_param_cpp_node"])
def test_the_frequency_is_a_parameter_on_the_real_ros(ros1: Workspace, cpp_nodes: CppNodes, name: str) -> None:
    node = str(PACKAGE / "src" / name) if name.endswith(".py") else cpp_nodes.program(name)
    with control(bears=0.1):
        run = ros1.run([node, "_frequency:=5"], NEVER, Until("counter = 10"))
        stamps = [tick.real for tick in read_ticks(run.console)]
        assert min(later - earlier for earlier, later in pairwise(stamps)) < 0.35
    assert run.status == 0
    refused = ros1.run([node, "_frequency:=0"], NEVER)
    assert refused.status == 1
    assert "frequency must be above 0" in refused.console


def test_the_uneven_node_on_the_real_ros(ros1: Workspace) -> None:
    """The sixth call tells of the one that took long, as in simulated time."""
    node = ROOT / "examples" / "how-to" / "uneven_py_node.py"
    told = re.compile(r"counter = 6, [\d.]+ s after a call that took 0\.[2-9]")
    assert told.search(simulate(node, 0.9).console)
    with control(bears=0.1):
        assert told.search(ros1.run([str(node)], NEVER, Until("counter = 6")).console)


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


def test_the_launch_file_shows_lines_at_once(ros1: Workspace, cpp_nodes: CppNodes) -> None:
    """Lines that came only at the end could not end the run: it would continue until the time is up."""
    command = cpp_nodes.roslaunch(ros1, "spinner_at_once.launch")
    onward: Any = _UntilBothCount(ros1)
    run = ros1.run(command, NEVER, onward, more=cpp_nodes.environment)
    assert max(tick.number for tick in read_ticks(run.console)) < NEVER  # when the time is up it would be twice that


CHATTY = """import rospy

rospy.init_node("chatty")
while True:
    rospy.loginfo("a line")
    rospy.sleep(0.01)
"""


def test_info_lines_come_in_blocks_while_a_chatty_node_of_ros_1_runs(ros1: Workspace, tmp_path: Path) -> None:
    """The node is still running when the first ones are read."""
    node = tmp_path / "chatty.py"
    node.write_text(CHATTY)
    elsewhere = [path for path in ros1.environment["PYTHONPATH"].split(os.pathsep) if path != str(ros1.folder)]
    environment = ros1.environment | {"PYTHONPATH": os.pathsep.join(elsewhere)}
    child = subprocess.Popen(["/usr/bin/python3", node], env=environment, stdout=subprocess.PIPE)
    try:
        assert child.stdout
        block = os.read(child.stdout.fileno(), 2**16)
        assert child.poll() is None
    finally:
        child.kill()  # a node of the real rospy that Ctrl-C meets as it logs does not always end
        child.communicate()
    assert block.count(b"\n") > 100


@pytest.mark.parametrize("runtime", ["wall", "ros2"])
def test_lines_of_ros_2_come_at_once_on_stderr(require: Callable[[str], None], tmp_path: Path, runtime: str) -> None:
    """Lines that came only at the end would never be read: the node continues until one was."""
    node = str(PACKAGE_ROS2 / "my_robotics_pkg" / "spinner_py_node.py")
    command = [sys.executable, "-m", "rosspin", "run", node]
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONUNBUFFERED", "NO_COLOR")}
    if runtime == "ros2":
        require("ros2")
        command = [ros2.python(), node]
        environment |= {"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF", "ROS_LOG_DIR": str(tmp_path)}
    child = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert child.stderr
        line = next(line for line in child.stderr if "counter = 1" in line)
        child.send_signal(signal.SIGINT)
        printed, _ = child.communicate(timeout=NEVER)
    finally:
        child.kill()
    assert re.fullmatch(r"\[INFO\] \[\d+\.\d{9}\] \[spinner_py_node\]: \[SPINNER PY NODE\] counter = 1\n", line)
    assert printed == ""
    # The real one may also end in an error: Ctrl-C on a log line now and then meets rclpy's own shutdown half-way.
    assert runtime == "ros2" or child.returncode == 0


@pytest.mark.parametrize("namespace", ["/", "/mrp"])
def test_the_frequency_is_a_parameter_on_the_real_ros_2(require: Callable[[str], None], namespace: str) -> None:
    """The file's, 10 Hz, in any namespace."""
    require("ros2")
    file = str(PACKAGE_ROS2 / "config" / "spinner.yaml")
    args = ["--ros-args", "-r", f"__ns:={namespace}", "--params-file", file]
    node = PACKAGE_ROS2 / "my_robotics_pkg/spinner_param_py_node.py"
    with control(bears=0.05):
        run = launch_past("counter = 15", node, args)
        assert min(later.expected - earlier.expected for earlier, later in pairwise(run.ticks)) < 0.15
    assert run.status == 0


def test_a_frequency_without_a_point_is_refused_on_the_real_ros_2(require: Callable[[str], None]) -> None:
    require("ros2")
    file = PACKAGE_ROS2 / "my_robotics_pkg/spinner_param_py_node.py"
    run = ros2.launch(file, NEVER, ["--ros-args", "-p", "frequency:=5"])
    assert run.status == 1
    assert "to '5' of type 'INTEGER', expecting type 'DOUBLE'" in run.console


@pytest.mark.parametrize("args", [["-p", "frequency:=5.0"], ["--ros-args", "-p", "frequency_in_hz:=5.0"]])
def test_a_frequency_not_meant_for_the_node_is_ignored_on_the_real_ros_2(
    require: Callable[[str], None], args: list[str]
) -> None:
    """Without --ros-args, or of another name: the node keeps its own, and nothing is said."""
    require("ros2")
    node = PACKAGE_ROS2 / "my_robotics_pkg/spinner_param_py_node.py"
    with control(bears=0.1):
        run = launch_past("counter = 2", node, args)
        assert min(later.expected - earlier.expected for earlier, later in pairwise(run.ticks)) > 0.45
    assert run.status == 0
    assert all("[SPINNER PY NODE] counter = " in line for line in run.console.splitlines())


@pytest.mark.parametrize("node", sorted((ROOT / "examples" / "hangs").glob("*.py")), ids=lambda node: node.stem)
def test_a_node_hangs_or_goes_on_as_the_page_says(node: Path, require: Callable[[str], None]) -> None:
    require("ros2")

    def said(console: str) -> list[str]:
        return [line.partition("]: ")[2] for line in console.splitlines() if line.startswith("[")]

    simulated = simulate(node, 2.8)
    with control(bears=0.1):
        run = launch(node, 2.8)
        assert (said(run.console), run.status) == (said(simulated.console), simulated.status)
