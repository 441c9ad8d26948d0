"""The how-to pages: what they tell a reader to do works."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from tree import ROOT

from rosspin import simulate

PAGES = ROOT / "docs" / "how-to"
PACKAGE = ROOT / "examples" / "my_robotics_pkg"
PACKAGE_ROS2 = ROOT / "examples" / "my_robotics_pkg_ros2"
CONTROLLER = ROOT / "examples" / "controller"
CONTROLLER_ROS2 = ROOT / "examples" / "controller_ros2"


def _pytest(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def test_the_example_test_passes_by_the_commands_on_the_page(site: Path, tmp_path: Path) -> None:
    page = BeautifulSoup((site / "docs/how-to/test-timing.html").read_text(encoding="utf-8"), "html.parser")
    shown = "\n".join(tag.get_text() for tag in page.select(".highlight-console pre"))
    *elsewhere, here = re.findall(r"^\$ (.*)", shown, re.MULTILINE)
    run = _pytest(ROOT, *shlex.split(here.removeprefix(".venv/bin/python -m pytest")))
    assert run.returncode == 0, run.stdout
    assert "2 passed" in run.stdout

    # In a package of the reader's own, which knows nothing of this environment.
    shutil.copytree(CONTROLLER, tmp_path, dirs_exist_ok=True)
    (tmp_path / "rosspin").symlink_to(ROOT)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    for command in elsewhere:
        run = subprocess.run(command, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True)
        if "NewConnectionError" in run.stderr:
            pytest.skip("pip can reach no package index")
        assert run.returncode == 0, run.stdout + run.stderr
    assert "2 passed" in run.stdout


@pytest.mark.parametrize("package", [PACKAGE, PACKAGE_ROS2], ids=lambda package: package.name)
def test_the_long_run_of_the_page_passes(package: Path) -> None:
    run = _pytest(package, "test")
    assert "7 passed" in run.stdout, run.stdout


def test_the_controller_s_test_reads_in_15_lines() -> None:
    text = (CONTROLLER / "test/test_controller.py").read_text(encoding="utf-8")
    assert sum(bool(line.strip()) for line in text.splitlines()) <= 15


def test_the_controller_of_ros_2_passes_the_same_test() -> None:
    one, two = ((folder / "test/test_controller.py").read_text() for folder in (CONTROLLER, CONTROLLER_ROS2))
    assert two == one.replace("../src/", "../controller/")
    run = _pytest(CONTROLLER_ROS2, "test")
    assert "2 passed" in run.stdout, run.stdout


IGNORES_SILENCE = "return rospy.Time.now() - self.last_heard < rospy.Duration(0.2)", "return True"
MISSPELT = "message.range", "message.rang"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        IGNORES_SILENCE,
        MISSPELT,
        ("rospy.Duration(0.02)", "rospy.Duration(0.025)"),
        ("rospy.Duration(0.02)", "rospy.Duration(0.01)"),
        ("rospy.Duration(0.2)", "rospy.Duration(0.25)"),
        ("rospy.Duration(0.2)", "rospy.Duration(0.1)"),
        ("linear.x = 0.5", "linear.x = 1.0"),
        ("rospy.spin()", "while True: rospy.sleep(1)"),
    ],
)
def test_the_controller_s_test_fails_for_a_controller_that_is_wrong(tmp_path: Path, old: str, new: str) -> None:
    run = _pytest_of_a_changed_controller(tmp_path, old, new)
    assert run.returncode == 1, run.stdout


@pytest.mark.parametrize(
    ("old", "new"),
    [("return silence < Duration(seconds=0.2)", "return True"), ("timer(0.02,", "timer(0.025,")],
)
def test_it_fails_for_a_controller_of_ros_2_that_is_wrong(tmp_path: Path, old: str, new: str) -> None:
    _fails_with_a_wrong_node(CONTROLLER_ROS2, tmp_path, "controller/controller_py_node.py", old, new)


def _pytest_of_a_changed_controller(folder: Path, old: str, new: str) -> subprocess.CompletedProcess[str]:
    shutil.copytree(CONTROLLER, folder, dirs_exist_ok=True)
    node = folder / "src/controller_py_node.py"
    text = node.read_text(encoding="utf-8")
    assert old in text
    node.write_text(text.replace(old, new), encoding="utf-8")
    return _pytest(folder, "--tb=short", "test")


@pytest.mark.parametrize(("number", "change"), [(0, IGNORES_SILENCE), (1, MISSPELT)])
def test_pytest_says_what_the_page_shows(
    site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, change: tuple[str, str]
) -> None:
    page = BeautifulSoup((site / "docs/how-to/test-timing.html").read_text(encoding="utf-8"), "html.parser")
    shown = page.select("#see-it-fail .highlight-text pre")[number].get_text()
    monkeypatch.setenv("COLUMNS", "80")
    said = _pytest_of_a_changed_controller(tmp_path, *change).stdout
    assert _without_carets(shown) in _without_carets(said)


def _without_carets(text: str) -> str:
    """A traceback without the marks below its lines, which not every Python has."""
    return "\n".join(line.rstrip() for line in text.strip().splitlines() if line.strip(" ^"))


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
    _fails_with_a_wrong_node(PACKAGE, tmp_path, f"src/{file}", old, new)


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("spinner_py_node.py", "in_seconds = 0.5", "in_seconds = 0.6"),
        ("spinner_py_node.py", "(KeyboardInterrupt, ExternalShutdownException)", "ValueError"),
    ],
)
def test_that_for_ros_2_does_so_too(tmp_path: Path, file: str, old: str, new: str) -> None:
    _fails_with_a_wrong_node(PACKAGE_ROS2, tmp_path, f"my_robotics_pkg/{file}", old, new)


def _fails_with_a_wrong_node(package: Path, tmp_path: Path, file: str, old: str, new: str) -> None:
    shutil.copytree(package, tmp_path, dirs_exist_ok=True)
    node = tmp_path / file
    assert old in node.read_text()
    node.write_text(node.read_text().replace(old, new))
    assert _pytest(tmp_path, "test").returncode == 1


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
