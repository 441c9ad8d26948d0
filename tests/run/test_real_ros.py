"""What is said of a run on a real ROS that does not begin."""

from __future__ import annotations

import os
import platform
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from rosspin.real import ros1, ros2
from tests.helpers.tree import ROOT

LAUNCH_FILE = ROOT / "examples/my_robotics_pkg/launch/spinner.launch"
PACKAGE_ROS2 = ROOT / "examples/my_robotics_pkg_ros2"
NODE_ROS2 = PACKAGE_ROS2 / "my_robotics_pkg/spinner_py_node.py"

LAUNCHES = [(ros1.launch, LAUNCH_FILE), (ros2.launch, NODE_ROS2)]


@pytest.mark.parametrize(
    ("launch", "name"),
    [
        *((ros1.launch, name) for name in ("lone.launch", "lone.txt")),
        *((ros2.launch, name) for name in ("node.cpp", "node.launch", "node.txt")),
    ],
)
def test_a_file_that_cannot_be_run(tmp_path: Path, launch: Callable[..., object], name: str) -> None:
    (tmp_path / name).write_text("")
    with pytest.raises(ValueError, match=name):
        launch(tmp_path / name, 1.0)


@pytest.mark.parametrize(("launch", "node"), LAUNCHES)
@pytest.mark.parametrize("seconds", [-1, float("nan"), float("inf")])
def test_seconds_that_are_none(launch: Callable[..., object], node: Path, seconds: float) -> None:
    with pytest.raises(ValueError, match="at least 0"):
        launch(node, seconds)


@pytest.mark.parametrize(("launch", "node"), LAUNCHES)
def test_a_missing_file(launch: Callable[..., object], node: Path) -> None:
    with pytest.raises(FileNotFoundError):
        launch(node.with_stem("nonsuch"), 1.0)


def test_ros_1_is_missing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(ros1, "_path", lambda: str(tmp_path))
    with pytest.raises(ros1.Ros1Missing, match="sudo apt-get install .*libroscpp-dev.*python3-rospy"):
        ros1.launch(LAUNCH_FILE, 1.0)


def test_make_ros1_installs_what_the_error_names() -> None:
    assert f"ROS1 := {ros1.APT}\n" in ROOT.joinpath("Makefile").read_text()


@pytest.fixture
def forgetful() -> Iterator[None]:
    """ROS 2 is looked for again, and again after the test."""
    caches: Any = (ros2.python, ros2.version)
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


@pytest.mark.parametrize(
    ("system", "machine", "version", "says"),
    [
        ("Linux", "x86_64", (3, 12), r"\(no rclpy\): make ros2$"),
        ("Linux", "aarch64", (3, 12), r"for Linux on x86_64 with Python 3.10 to 3.14; this is Linux on aarch64"),
        ("Darwin", "arm64", (3, 12), r"this is Darwin on arm64 with Python 3.12$"),
        ("Windows", "AMD64", (3, 12), r"this is Windows on AMD64 with Python 3.12$"),
        ("Linux", "x86_64", (3, 15), r"this is Linux on x86_64 with Python 3.15$"),
    ],
)
def test_ros_2_is_missing(
    forgetful: None,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    system: str,
    machine: str,
    version: tuple[int, int],
    says: str,
) -> None:
    monkeypatch.setattr(ros2, "_MADE", tmp_path / "nowhere")
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    monkeypatch.setattr(platform, "system", lambda: system)
    monkeypatch.setattr(platform, "machine", lambda: machine)
    monkeypatch.setattr(sys, "version_info", version)
    with pytest.raises(ros2.Ros2Missing, match=says):
        ros2.launch(NODE_ROS2, 1.0)


def test_the_package_of_ros_2_is_told_of_all_its_nodes() -> None:
    setup = re.sub(r"'\n +'", "", (PACKAGE_ROS2 / "setup.py").read_text())
    for node in NODE_ROS2.parent.glob("*_node.py"):
        assert f"'{node.stem} = my_robotics_pkg.{node.stem}:main'" in setup
        assert os.access(node, os.X_OK)
