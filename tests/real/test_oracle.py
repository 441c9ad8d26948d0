"""Random nodes do the same on the stand-ins and on the real ones' own Python; `make judge` draws more of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings

from tests.helpers import random_rclpy_nodes, random_rospy_nodes

FEW = settings().max_examples // 2  # 50, and for `make judge` 500

several = settings(max_examples=FEW, deadline=None, suppress_health_check=list(HealthCheck))


@pytest.fixture(scope="module")
def rospy_folder(require: Callable[[str], None]) -> Path:
    return random_rospy_nodes.rospy_folder(require)


@pytest.fixture(scope="module")
def rclpy_folder(require: Callable[[str], None]) -> Path:
    return random_rclpy_nodes.rclpy_folder(require)


@pytest.mark.filterwarnings("ignore:notifyAll:DeprecationWarning")
@several
@given(random_rospy_nodes.specs)
def test_nodes_of_ros1(rospy_folder: Path, spec: dict[str, Any]) -> None:
    random_rospy_nodes.do_the_same(rospy_folder, spec)


# Executors and methods that are gone when a run has ended are collected at some later time.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@several
@given(random_rclpy_nodes.specs)
def test_nodes_of_ros2(rclpy_folder: Path, spec: dict[str, Any]) -> None:
    random_rclpy_nodes.do_the_same(rclpy_folder, spec)
