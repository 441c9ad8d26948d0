"""The names of rospy's and rclpy's modules, and what rospy's helpers make of names and times, are the real ones'."""

from __future__ import annotations

import subprocess
from collections.abc import Callable

from names_of_rclpy import NAMES, names_of
from seeds import SEED
from tree import HELPERS

from rosspin import simulate
from rosspin.real import ros2

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


def test_the_recorded_names_are_those_of_rclpy(require: Callable[[str], None]) -> None:
    require("ros2")
    real, recorded = names_of(ros2.launch(NAMES, 5).console), names_of(NAMES.with_suffix(".txt").read_text())
    for names in (*real.values(), *recorded.values()):
        names.discard("_is_protocol")  # not every Python has it
    assert real == recorded
