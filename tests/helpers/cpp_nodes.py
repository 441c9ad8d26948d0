"""The C++ nodes of the pages, and what tests change in them, built once for all tests on the real ROS 1."""

from __future__ import annotations

import fcntl
import os
import re
import shutil
import tempfile
from pathlib import Path

from rosspin.real.ros1 import Workspace

from .answers import listings
from .tree import ROOT

EXAMPLES = ROOT / "examples"
PACKAGE = EXAMPLES / "my_robotics_pkg"
PROBES = EXAMPLES / "timing_probes"


def _variants() -> dict[str, str]:
    """The text of each node that is no listing of a page as it stands, by the name of its program."""
    rate = (PACKAGE / "src/spinner_rate_cpp_node.cpp").read_text(encoding="utf-8")
    timer = (PACKAGE / "src/spinner_cpp_node.cpp").read_text(encoding="utf-8")
    include = '#include "ros/ros.h"\n'
    locked = (EXAMPLES / "threads/locked_cpp_node.cpp").read_text(encoding="utf-8")
    torn = re.sub(r".*\b(lock_guard|std::mutex)\b.*\n", "", locked)
    assert torn.count("\n") == locked.count("\n") - 3
    [kept] = listings("cpp-ticks", "cpp")
    variants = {
        # Two lines as the original page has them.
        "while_ros_ok": rate.replace("while (ros::ok())", "while (ros::ok)"),
        "global_timer": timer.replace("  ros::Timer timer_for", "  timer_for").replace(
            include, f"{include}\nros::Timer timer_for_counting;\n"
        ),
        "torn_cpp_node": torn,
        "spun_cpp_node": re.sub(r"  ros::AsyncSpinner(.|\n)*waitForShutdown", "  ros::spin", torn),
        "kept": kept,
        "not_kept": kept.replace("    timer_ =", "    ros::Timer timer_ ="),
    }
    assert variants["global_timer"].count("ros::Timer timer_for_counting") == 1
    assert len({rate, timer, *variants.values()}) == len(variants) + 2
    return variants


class CppNodes:
    """Programs in a folder, and there, as a package that roslaunch finds, the tutorial's.

    ``said`` is what the compiler said of them.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.said = (folder / "said").read_text(encoding="utf-8")
        # So that roslaunch finds the package.
        self.environment = {"ROS_PACKAGE_PATH": f"{folder}:/usr/share"}

    def program(self, name: str) -> str:
        (path,) = self.folder.glob(f"*/{name}")
        return str(path)

    def roslaunch(self, workspace: Workspace, name: str, *args: str) -> list[str]:
        """A command that launches a file of the tutorial's package on a workspace's master."""
        return ["roslaunch", "-p", str(workspace.port), str(self.folder / PACKAGE.name / "launch" / name), *args]


def built(folder: Path) -> CppNodes:
    """The programs of this folder, which the first process that needs them builds."""
    folder.mkdir(exist_ok=True)
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "said").exists():
            _build(folder)
    return CppNodes(folder)


def _build(folder: Path) -> None:
    shutil.copytree(PACKAGE, folder / PACKAGE.name, ignore=shutil.ignore_patterns("__pycache__"))
    with tempfile.TemporaryDirectory() as made, Workspace() as workspace:
        for name, text in _variants().items():
            Path(made, f"{name}.cpp").write_text(text, encoding="utf-8")
        workspace.add_package(PACKAGE)
        workspace.add_package(PROBES)
        workspace.add_nodes("loose", *(path for name in ("steps", "threads", "topics") for path in _cpp(name)))
        workspace.add_nodes("variants", *Path(made).glob("*.cpp"))
        said = workspace.build("-DCMAKE_CXX_FLAGS=-Wall -Wextra")
        for program in workspace.folder.glob("devel/lib/*/*"):
            if program.is_file() and not program.suffix and os.access(program, os.X_OK):
                (folder / program.parent.name).mkdir(exist_ok=True)
                shutil.copy(program, folder / program.parent.name)
    (folder / "said").write_text(said, encoding="utf-8")


def _cpp(name: str) -> list[Path]:
    return sorted((EXAMPLES / name).glob("*.cpp"))
