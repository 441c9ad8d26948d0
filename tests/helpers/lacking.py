"""What a test may ask for, and this machine may lack."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from functools import cache

from benchmarks import rclcpp_nodes
from rosspin import doctor
from rosspin.grading.pool import Pool
from rosspin.grading.sealed import CannotSeal
from rosspin.real import ros2

from .firefox import firefox
from .message_probe import PACKAGES
from .runtimes import KILTED_PYTHON


@cache
def _lacks_ros1() -> str:
    commands = [name for name in ("roslaunch", "rosmaster", "catkin_make") if not shutil.which(name)]
    if commands:
        return f"ROS 1 is not installed (no {', '.join(commands)})"
    importing = f"import {', '.join(f'{name}.msg' for name in PACKAGES)}"
    run = subprocess.run(["/usr/bin/python3", "-c", importing], capture_output=True, text=True)
    return f"ROS 1 is not all installed ({run.stderr.splitlines()[-1]})" if run.returncode else ""


@cache
def _lacks_bwrap() -> str:
    try:
        Pool().close()
    except CannotSeal as error:
        return f"answers cannot be sealed: {error}"
    return ""


# What a test may ask for, and why it is not here ("" if it is).
LACKS: dict[str, Callable[[], str]] = {
    "ros1": _lacks_ros1,
    "ros2": lambda: str(ros2.Ros2Missing()) if ros2.missing() else "",
    "rclcpp": rclcpp_nodes.missing,
    "kilted": lambda: "" if KILTED_PYTHON.exists() else "Kilted is not installed (make ros2 DISTRO=kilted)",
    "browser": lambda: "" if doctor.chromium() else "Chromium is not installed",
    "bwrap": _lacks_bwrap,
    "firefox": lambda: "" if firefox() else "Firefox is not installed",
}
