"""The how-to pages: what they tell a reader to do works."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import pytest
from bs4 import BeautifulSoup

from rosspin import simulate
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

PACKAGE = ROOT / "examples" / "my_robotics_pkg"
PACKAGE_ROS2 = ROOT / "examples" / "my_robotics_pkg_ros2"
CONTROLLER = ROOT / "examples" / "controller"
CONTROLLER_ROS2 = ROOT / "examples" / "controller_ros2"


def _pytest(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def test_the_example_test_passes_by_the_command_on_the_page() -> None:
    text = (ROOT / "docs/how-to/test-timing.rst").read_text(encoding="utf-8")
    *_, here = re.findall(r"^ *\$ (.*)", text, re.MULTILINE)  # the others are typed in tests/real
    run = _pytest(ROOT, *shlex.split(here.removeprefix(".venv/bin/python -m pytest")))
    assert run.returncode == 0, run.stdout
    assert "2 passed" in run.stdout


def test_the_controller_s_test_reads_in_15_lines() -> None:
    text = (CONTROLLER / "test/test_controller.py").read_text(encoding="utf-8")
    assert sum(bool(line.strip()) for line in text.splitlines()) <= 15


def test_the_controller_of_ros_2_passes_the_same_test() -> None:
    one, two = ((folder / "test/test_controller.py").read_text() for folder in (CONTROLLER, CONTROLLER_ROS2))
    assert two == one.replace("../src/", "../controller/")


class Changed(NamedTuple):
    """A package in whose node something is written in place of something else."""

    package: Path
    node: str
    old: str = ""
    new: str = ""

    def copy(self, folder: Path) -> None:
        shutil.copytree(self.package, folder, dirs_exist_ok=True)
        node = folder / self.node
        text = node.read_text(encoding="utf-8")
        assert self.old in text
        node.write_text(text.replace(self.old, self.new), encoding="utf-8")


CONTROLLER_NODE = CONTROLLER, "src/controller_py_node.py"
CONTROLLER_NODE_ROS2 = CONTROLLER_ROS2, "controller/controller_py_node.py"
SPINNER = PACKAGE, "src/spinner_py_node.py"
SPINNER_PARAM = PACKAGE, "src/spinner_param_py_node.py"
SPINNER_ROS2 = PACKAGE_ROS2, "my_robotics_pkg/spinner_py_node.py"

AS_THEY_ARE = {Changed(*CONTROLLER_NODE): 2, Changed(*CONTROLLER_NODE_ROS2): 2}
AS_THEY_ARE |= {Changed(*SPINNER): 7, Changed(*SPINNER_ROS2): 10}

IGNORES_SILENCE = Changed(*CONTROLLER_NODE_ROS2, "return silence < Duration(seconds=0.2)", "return True")
MISSPELT = Changed(*CONTROLLER_NODE_ROS2, "message.range", "message.rang")
WRONG = [
    IGNORES_SILENCE,
    MISSPELT,
    Changed(*CONTROLLER_NODE, "return rospy.Time.now() - self.last_heard < rospy.Duration(0.2)", "return True"),
    Changed(*CONTROLLER_NODE, "message.range", "message.rang"),
    Changed(*CONTROLLER_NODE, "rospy.Duration(0.02)", "rospy.Duration(0.025)"),
    Changed(*CONTROLLER_NODE, "rospy.Duration(0.02)", "rospy.Duration(0.01)"),
    Changed(*CONTROLLER_NODE, "rospy.Duration(0.2)", "rospy.Duration(0.25)"),
    Changed(*CONTROLLER_NODE, "rospy.Duration(0.2)", "rospy.Duration(0.1)"),
    Changed(*CONTROLLER_NODE, "linear.x = 0.5", "linear.x = 1.0"),
    Changed(*CONTROLLER_NODE, "rospy.spin()", "while True: rospy.sleep(1)"),
    Changed(*CONTROLLER_NODE_ROS2, "timer(0.02,", "timer(0.025,"),
    Changed(*SPINNER, "in_seconds = 0.5", "in_seconds = 0.6"),
    Changed(*SPINNER, "rospy.spin()", "1 / 0"),
    Changed(*SPINNER_PARAM, '"~frequency"', '"frequency"'),
    Changed(*SPINNER_PARAM, "frequency_in_hz <= 0", "frequency_in_hz < 0"),
    Changed(*SPINNER_ROS2, "in_seconds = 0.5", "in_seconds = 0.6"),
    Changed(*SPINNER_ROS2, "(KeyboardInterrupt, ExternalShutdownException)", "ValueError"),
]


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory: pytest.TempPathFactory) -> dict[Changed, Counter[str]]:
    """What became of the tests of each package, all in one go, for pytest takes a second to begin."""
    folder = tmp_path_factory.mktemp("packages")
    packages = {str(number): package for number, package in enumerate([*AS_THEY_ARE, *WRONG])}
    for name, package in packages.items():
        package.copy(folder / name)
    tests = [f"{name}/test" for name in packages]
    said = _pytest(folder, "--import-mode=importlib", "-rA", "--tb=no", "--show-capture=no", *tests).stdout
    found: dict[Changed, Counter[str]] = {package: Counter() for package in packages.values()}
    for what, name in re.findall(r"^(PASSED|FAILED|ERROR) (\d+)/", said, re.MULTILINE):
        found[packages[name]][what] += 1
    return found


@pytest.mark.parametrize("package", AS_THEY_ARE)
def test_the_tests_of_the_page_pass(outcomes: dict[Changed, Counter[str]], package: Changed) -> None:
    assert outcomes[package] == {"PASSED": AS_THEY_ARE[package]}


@pytest.mark.parametrize("package", WRONG)
def test_they_fail_for_a_node_that_is_wrong(outcomes: dict[Changed, Counter[str]], package: Changed) -> None:
    assert outcomes[package]["FAILED"] + outcomes[package]["ERROR"] > 0


@pytest.mark.parametrize(("number", "package"), [(0, IGNORES_SILENCE), (1, MISSPELT)])
def test_pytest_says_what_the_page_shows(
    site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, package: Changed
) -> None:
    page = BeautifulSoup((site / "docs/how-to/test-timing.html").read_text(encoding="utf-8"), "html.parser")
    shown = page.select("#see-it-fail .highlight-text pre")[number].get_text()
    monkeypatch.setenv("COLUMNS", "80")
    package.copy(tmp_path)
    assert _without_carets(shown) in _without_carets(_pytest(tmp_path, "--tb=short", "test").stdout)


def _without_carets(text: str) -> str:
    """A traceback without the marks below its lines, and the guess at its end, which not every Python has."""
    lines = [re.sub(r"\. Did you mean: '.*'\?$", "", line.rstrip()) for line in text.strip().splitlines()]
    return "\n".join(line for line in lines if line.strip(" ^"))


def test_timer_beside_rate_shows_a_run() -> None:
    """The dots of the picture are the ticks of a run, the bars their work, and its lines are half a second apart."""

    def node() -> None:
        import rospy  # type: ignore[import-not-found]

        rospy.init_node("beside")
        rospy.Timer(rospy.Duration(0.5), lambda event: rospy.sleep(0.2))
        rate = rospy.Rate(2)
        while not rospy.is_shutdown():
            rospy.sleep(0.2)
            rate.sleep()

    picture = BeautifulSoup((ROOT / "docs/_static/timer-beside-rate.svg").read_text(encoding="utf-8"), "html.parser")
    parts = picture.select("text, rect, circle")
    for tag, name in ((tag, name) for tag in parts for name in ("x", "cx", "width") if tag.get(name)):
        tag[name] = str(tag[name]).removesuffix("%")
    labels = {str(tag.string): float(str(tag["x"])) for tag in picture.select("text")}
    zero, second = labels["0 s"], labels["1 s"] - labels["0 s"]
    ticks = simulate(node, 2.0).ticks
    for name, source in (("timer", "<lambda>"), ("rate", "Rate")):
        drawn = [(float(str(dot["cx"])) - zero) / second for dot in picture.select(f"#beside-{name} circle")]
        assert drawn == pytest.approx([tick.real for tick in ticks if tick.source == source], abs=1e-3)
        bars = [float(str(bar["width"])) / second for bar in picture.select(f"#beside-{name} rect")]
        assert bars[:-1] == pytest.approx([0.2] * (len(bars) - 1), abs=1e-3)
