"""Callbacks that share data, on a real ROS: without the lock a report shows half a reading, with it none does."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest

from rosspin.real import ros2
from rosspin.real.ros1 import Workspace
from tests.helpers.cpp_nodes import CppNodes
from tests.helpers.launches import NEVER, Until
from tests.helpers.tree import EXAMPLES
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(10)

THREADS = EXAMPLES / "threads"
REPORT = "left = "


@pytest.fixture
def ros1(require: Callable[[str], None]) -> Iterator[Workspace]:
    """A workspace on the real ROS, and a master."""
    require("ros1")
    with Workspace() as workspace:
        workspace.start_master()
        yield workspace


def _wheels(console: str) -> list[tuple[str, str]]:
    """What an odometer node reported: pairs that should be equal."""
    return re.findall(r"left = (\d+), right = (\d+)", console)


@pytest.mark.parametrize("language", ["py", "cpp"])
def test_on_ros_1(ros1: Workspace, cpp_nodes: CppNodes, language: str) -> None:
    torn, locked = (
        str(THREADS / f"{name}_py_node.py") if language == "py" else cpp_nodes.program(f"{name}_cpp_node")
        for name in ("torn", "locked")
    )
    with control(bears=0.05):  # late reports may miss all readings
        wrong = _wheels(ros1.run([torn], NEVER, Until(REPORT, times=5)).console)
        assert any(left != right for left, right in wrong)
    right = _wheels(ros1.run([locked], NEVER, Until(REPORT, times=5)).console)
    assert right and all(left == right for left, right in right)


def test_on_ros_2(require: Callable[[str], None]) -> None:
    require("ros2")
    with control(bears=0.05):
        wrong = _wheels(ros2.launch(THREADS / "ros2/torn_py_node.py", NEVER, (), Until(REPORT, times=5)).console)
        assert any(left != right for left, right in wrong)
    right = _wheels(ros2.launch(THREADS / "ros2/locked_py_node.py", NEVER, (), Until(REPORT, times=5)).console)
    assert right and all(left == right for left, right in right)


def test_a_roscpp_node_needs_no_lock_under_spin(ros1: Workspace, cpp_nodes: CppNodes) -> None:
    found = _wheels(ros1.run([cpp_nodes.program("spun_cpp_node")], NEVER, Until(REPORT, times=5)).console)
    assert found and all(left == right for left, right in found)
