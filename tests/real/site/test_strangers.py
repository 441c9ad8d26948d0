"""What make and pytest let through of a stranger's environment. `.ci/run` types the commands whole, in such a place."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.helpers.surroundings import clean
from tests.helpers.tree import ROOT

# What stands in people's .bashrc: ROS's variables, Python's, the language's, the terminal's, the tools'.
BASHRC = {
    "RCUTILS_CONSOLE_OUTPUT_FORMAT": "[{severity}] {message}",
    "ROSCONSOLE_FORMAT": "${time} ${message}",
    "ROS_NAMESPACE": "/mine",
    "ROS_DOMAIN_ID": "7",
    "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
    "COLCON_PREFIX_PATH": "/opt",
    "PYTHONWARNINGS": "error",
    "PYTHONOPTIMIZE": "2",
    "PYTHONHOME": "/nowhere",
    "LC_ALL": "tr_TR",
    "LANGUAGE": "de",
    "TERM": "dumb",
    "COLUMNS": "40",
    "NO_COLOR": "1",
    "MPLBACKEND": "TkAgg",
    "NODE_OPTIONS": "--throw-deprecation",
    "NODE_ENV": "production",
    "MAKEFLAGS": "k",
    "GIT_DIR": "/nowhere",
    "CDPATH": "/tmp",
    "PIP_TARGET": "/nowhere",
    "SOURCE_DATE_EPOCH": "1",
    "with.a.point": "1",
}
SOURCED = {"AMENT_PREFIX_PATH": "/opt/ros/jazzy", "PYTHONPATH": "/opt/ros/jazzy/lib"}
LET_THROUGH = {"PIP_INDEX_URL": "https://index.example", "SSL_CERT_FILE": "/a cert", "ROSSPIN_SEED": "3"}


@pytest.mark.parametrize("name", ["Übung 1", "it's", 'the "best" $HOME', "a; b & c"])
def test_make(tmp_path: Path, name: str) -> None:
    seen = seen_by_make(tmp_path / name, BASHRC | SOURCED | LET_THROUGH)
    assert not seen.keys() & (BASHRC.keys() | SOURCED.keys())
    assert seen.items() >= LET_THROUGH.items()
    places = [seen[name] for name in ("npm_config_cache", "XDG_CACHE_HOME", "IPYTHONDIR", "MPLCONFIGDIR")]
    assert all(Path(place).is_relative_to(tmp_path / name) for place in places)


def test_a_ros_that_was_sourced_is_let_through_where_rclcpp_is_asked_for(tmp_path: Path) -> None:
    seen = seen_by_make(tmp_path / "folder", BASHRC | SOURCED | {"ROSSPIN_REQUIRE": "ros2,rclcpp"})
    assert not seen.keys() & BASHRC.keys()
    assert seen.items() >= SOURCED.items()


def seen_by_make(folder: Path, environment: dict[str, str]) -> dict[str, str]:
    """The environment of a command in a Makefile like ours, which stands alone in the folder."""
    folder.mkdir()
    shutil.copy(ROOT / "Makefile", folder)
    (folder / "show.mk").write_text("include Makefile\nshow:\n\t@env -0\n")
    command = ["make", "-f", "show.mk", "show"]
    run = subprocess.run(command, cwd=folder, env=os.environ | environment, capture_output=True, check=True)
    return dict(entry.split("=", 1) for entry in run.stdout.decode().split("\0") if entry)


def test_pytest_started_by_hand() -> None:
    environment = BASHRC | SOURCED | LET_THROUGH
    clean(environment)
    assert environment.pop("LC_CTYPE").endswith("UTF-8")
    assert environment == SOURCED | LET_THROUGH
