"""The names of rospy's and rclpy's modules, and what rospy's helpers make of names and times, are the real ones'."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from rosspin import simulate
from rosspin.real import ros2
from tests.helpers.names_of_rclpy import IMPORTS, NAMES, names_of
from tests.helpers.seeds import SEED
from tests.helpers.tree import HELPERS

PROBE = HELPERS / "names_probe.py"
COUNT = 300


def test_random_names_and_times_give_what_the_real_rospy_gives(require: Callable[[str], None]) -> None:
    require("ros1")
    command = ["/usr/bin/python3", str(PROBE), str(SEED), str(COUNT)]
    real = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    run = simulate(PROBE, 1.0, [str(SEED), str(COUNT)])
    ours = run.console.splitlines()
    assert run.status == 0, run.console[-2000:]
    assert [pair for pair in zip(ours, real, strict=True) if pair[0] != pair[1]] == []


def test_the_recorded_imports_are_those_of_rclpy(require: Callable[[str], None]) -> None:
    require("ros2")
    with ros2.Nodes() as nodes:
        real = nodes.run([ros2.python(), "-W", "ignore", str(IMPORTS)], 120).console
    assert real == IMPORTS.with_suffix(".txt").read_text()


def test_the_real_rclpy_that_is_watched_has_no_more_names(require: Callable[[str], None], tmp_path: Path) -> None:
    require("ros2")
    node = tmp_path / "node.py"
    node.write_text("import rclpy\nprint(*(name for name in sorted(dir(rclpy)) if not name.startswith('__')))\n")
    names = IMPORTS.with_suffix(".txt").read_text().partition("\n")[0].removeprefix("rclpy ")
    assert ros2.launch(node, 5).console == f"{names}\n"


def test_the_recorded_names_are_those_of_rclpy(require: Callable[[str], None]) -> None:
    require("ros2")
    real, recorded = names_of(ros2.launch(NAMES, 5).console), names_of(NAMES.with_suffix(".txt").read_text())
    for names in (*real.values(), *recorded.values()):
        names.discard("_is_protocol")  # not every Python has it
    assert real == recorded
