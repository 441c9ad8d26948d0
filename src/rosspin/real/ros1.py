"""Run nodes on the real ROS 1: build their package in a temporary workspace, launch them and collect the run.

Every run has its own master, on a free port of the loopback interface, and its own folder for what ROS writes. All of
it is gone when the run is over, however it ends.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TextIO

from ..clocks.ctrl_c import Ending
from ..results.console import read_ticks
from ..results.ticks import Run
from .children import SITECUSTOMIZE, START_PATIENCE, Children, Output, check_seconds, say_deaths, shell_status

__all__ = ["APT", "BuildFailed", "Ros1Missing", "Workspace", "launch", "missing"]

# What to install on Debian and Ubuntu.
APT = "build-essential catkin libroscpp-dev python3-roslaunch python3-rosmaster python3-rospy rosbash"

# roslaunch gives its nodes the usual time to end, and then its master a little more.
_LAUNCH = Ending(((signal.SIGINT, 25.0), (signal.SIGTERM, 2.0)))

# What in the caller's environment would change the run or its console.
_UNWANTED = ("PYTHONHOME", "ROSCONSOLE_CONFIG_FILE", "ROSCONSOLE_FORMAT", "ROS_IP", "ROS_IPV6", "ROS_NAMESPACE")

# roslaunch writes titles for the terminal's window even where there is none.
_TITLE = re.compile(r"\x1b]2;[^\x07]*\x07")

_STARTED = re.compile(r"process\[(?!master|rosout)[^]]*\]: started with pid")
_DIED = re.compile(r"\[([^][]+)\] process has died \[pid \d+, exit code (-?\d+)")
_STOPPED = re.compile(r"process\[([^]]+)\]: SIG\w+ killed with return value (-?\d+)")
_KILLED = re.compile(r"process\[([^]]+)\]: sent SIGKILL")

# A package of loose node files, with the lines that the tutorial adds for each node.
_PACKAGE_XML = """<package format="2">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>Loose node files</description>
  <maintainer email="maintainer@example.org">nobody</maintainer>
  <license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
</package>
"""
_CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project({name})
find_package(catkin REQUIRED COMPONENTS roscpp)
catkin_package()
include_directories(${{catkin_INCLUDE_DIRS}})
"""
_CMAKE_NODE = """add_executable({node} {file})
add_dependencies({node} ${{catkin_EXPORTED_TARGETS}})
target_link_libraries({node} ${{catkin_LIBRARIES}})
"""


class Ros1Missing(RuntimeError):
    """ROS 1 is not installed; the message says what to install."""

    def __init__(self, lacking: Sequence[str]) -> None:
        super().__init__(
            f"ROS 1 is not installed (no {', '.join(lacking)}). On Debian and Ubuntu: sudo apt-get install {APT}"
        )


class BuildFailed(RuntimeError):
    """The package could not be built; the message is the compiler's or CMake's."""


def missing(cpp: bool = True) -> list[str]:
    """List what this machine lacks to run ROS 1 nodes: with ``cpp`` also those in C++. Empty if nothing is missing."""
    path = _path()
    commands = ["roslaunch", "rosmaster", *(["catkin_make", "c++", "make"] if cpp else [])]
    lacking = [command for command in commands if not shutil.which(command, path=path)]
    python = shutil.which("python3", path=path)
    probe = [python or "", "-c", "import rospy"]
    if (
        not python
        or subprocess.run(probe, env=_ros_environment(os.environ), stderr=subprocess.DEVNULL, cwd="/").returncode
    ):
        lacking.append("rospy")
    prefixes = ["/usr", *filter(None, os.environ.get("CMAKE_PREFIX_PATH", "").split(":"))]
    if cpp and not any(Path(prefix, "include/ros/ros.h").exists() for prefix in prefixes):
        lacking.append("roscpp")
    return lacking


def launch(
    node: str | os.PathLike[str],
    seconds: float | None = None,
    args: Sequence[str] = (),
    onward: TextIO | None = None,
) -> Run:
    """Run a launch file of a catkin package, or one node file (``.py`` or ``.cpp``), on the real ROS 1.

    Ctrl-C is pressed ``seconds`` after the first node has started; without ``seconds``, the run ends at a real Ctrl-C
    or when its nodes end. A node that does not end is killed when roslaunch would. ``args`` are the launch file's
    (``"name:=value"``) or the node's (``"__ns:=/mrp"``). The console is also written to ``onward``, as it comes. If a
    node dies or is killed, the last lines of the console name it, and the run has its exit status.

    Raises :class:`Ros1Missing`, :class:`BuildFailed`, OSError if the file cannot be read, ValueError if it cannot be
    run or ``seconds`` is negative, RuntimeError if ROS does not start, and KeyboardInterrupt if Ctrl-C is pressed
    before ``seconds`` are over.
    """
    check_seconds(seconds)
    path = Path(node)
    with open(path, "rb"):
        pass
    if path.suffix not in (".py", ".cpp", ".launch"):
        raise ValueError(f"{path}: neither a node file (.py, .cpp) nor a launch file (.launch)")
    if path.suffix == ".launch" and _package_of(path) is None:
        raise ValueError(f"{path}: not in a catkin package (no package.xml in a folder above it)")
    if lacking := missing(cpp=path.suffix != ".py"):
        raise Ros1Missing(lacking)
    with Workspace() as workspace:
        if path.suffix == ".launch":
            output, deaths = workspace.roslaunch(path, seconds, args, onward)
        else:
            command = [str(workspace.executable(path))] if path.suffix == ".cpp" else ["python3", str(path)]
            workspace.start_master()
            output = workspace.run([*command, *args], seconds, onward)
            deaths = {path.name: output.status} if output.status else {}
    return Run(
        output.console + say_deaths(deaths, onward),
        read_ticks(output.console, start=output.start),
        next(iter(deaths.values()), 0),
        "ros1",
        time.time() - output.start if seconds is None else seconds,
        output.start,
    )


class Workspace(Children):
    """A temporary catkin workspace and a port for a master. Leaving it ends what was started there and removes it."""

    def __init__(self) -> None:
        super().__init__()
        self.source = self.folder / "src"
        self.source.mkdir()
        (self.folder / "sitecustomize.py").write_text(SITECUSTOMIZE)
        self.port = _free_port()
        self._sources: dict[Path, Path] = {}  # the original of each copy here

    @property
    def environment(self) -> dict[str, str]:
        """The environment of whatever runs here."""
        environment = _ros_environment(super().environment)
        return {
            **environment,
            "PYTHONPATH": os.pathsep.join(filter(None, (str(self.folder), environment.get("PYTHONPATH")))),
            "ROS_MASTER_URI": f"http://localhost:{self.port}",
            "ROS_HOSTNAME": "localhost",
            "ROSCONSOLE_STDOUT_LINE_BUFFERED": "1",
        }

    def add_package(self, package: Path) -> None:
        """Copy a catkin package here."""
        copy = self.source / package.resolve().name
        shutil.copytree(package, copy, ignore=shutil.ignore_patterns("__pycache__"))
        self._sources[copy] = package

    def add_nodes(self, name: str, *sources: Path) -> None:
        """Make a package of loose C++ node files, with the three lines for each that the tutorial adds."""
        package = self.source / name
        package.mkdir()
        package.joinpath("package.xml").write_text(_PACKAGE_XML.format(name=name))
        lines = [_CMAKE.format(name=name)]
        for source in sources:
            shutil.copy(source, package)
            self._sources[package / source.name] = source
            lines.append(_CMAKE_NODE.format(node=source.stem, file=source.name))
        package.joinpath("CMakeLists.txt").write_text("".join(lines))

    def build(self, *options: str) -> str:
        """Build all packages that are here, with options for CMake; the build's console. Raises BuildFailed."""
        command = ["catkin_make", "-C", str(self.folder), "--no-color", f"-j{os.cpu_count() or 1}", *options]
        build = self.start(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = (text.decode(errors="replace") for text in build.communicate())
        for copy, source in self._sources.items():
            out, err = out.replace(str(copy), str(source)), err.replace(str(copy), str(source))
        if build.returncode:
            raise BuildFailed(err.strip() or out.strip())
        return out + err

    def executable(self, source: Path) -> Path:
        """Build the program of a C++ node file, with its package or with one made for it alone, and return its path."""
        package = _package_of(source)
        if package is None:
            self.add_nodes("loose_nodes", source)
        else:
            self.add_package(package)
        self.build()
        for program in self.folder.glob(f"devel/lib/*/{source.stem}"):
            return program
        raise ValueError(f"{source}: its package does not build a program called {source.stem}")

    def start_master(self) -> None:
        """Start the master for nodes that are run one by one. Raises RuntimeError if it does not start."""
        master = self.start(["rosmaster", "--core", "-p", str(self.port)], stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + START_PATIENCE
        while master.poll() is None and time.monotonic() < deadline:
            with socket.socket() as probe:
                if probe.connect_ex(("localhost", self.port)) == 0:
                    return
            time.sleep(0.02)
        raise RuntimeError(f"rosmaster did not start on port {self.port}")

    def roslaunch(
        self, file: Path, seconds: float | None, args: Sequence[str] = (), onward: TextIO | None = None
    ) -> tuple[Output, dict[str, int]]:
        """Build and launch the package of a launch file. Also returns the statuses of nodes that did not end with 0."""
        package = _package_of(file)
        assert package is not None
        self.add_package(package)
        self.build()
        copy = self.source / package.resolve().name / file.resolve().relative_to(package.resolve())
        command = [str(self.folder / "devel/env.sh"), "roslaunch", "-p", str(self.port), str(copy), *args]
        output = self.run(command, seconds, onward, _STARTED, _LAUNCH, lambda line: _TITLE.sub("", line))
        # What nodes did at Ctrl-C is only in roslaunch's log.
        log = "".join(path.read_text() for path in self.folder.glob("log/*/roslaunch-*.log"))
        deaths = [(name, int(code)) for name, code in _DIED.findall(output.console) + _STOPPED.findall(log)]
        deaths += [(name, -signal.SIGKILL) for name in _KILLED.findall(log)]
        if output.status and not deaths:
            deaths = [("roslaunch", output.status)]
        statuses = {name: shell_status(code) for name, code in deaths if code}
        return output, {name: status for name, status in statuses.items() if not re.match("master|rosout", name)}


def _package_of(file: Path) -> Path | None:
    """Return the folder of the catkin package that a file is in."""
    return next((folder for folder in file.resolve().parents if (folder / "package.xml").exists()), None)


def _path() -> str:
    # ROS is made for the system's Python: another one before it on the path lacks ROS's modules.
    return "/usr/bin:/bin:" + os.environ.get("PATH", "")


def _ros_environment(environment: Mapping[str, str]) -> dict[str, str]:
    return {**{name: value for name, value in environment.items() if name not in _UNWANTED}, "PATH": _path()}


def _free_port() -> int:
    """Find a free port of the loopback interface, but none that Linux would give to a node that asks for any port."""
    draw = random.SystemRandom()  # whose numbers no seed repeats in another process
    while True:
        port = draw.randrange(20_000, 32_768)
        with socket.socket() as probe:
            try:
                probe.bind(("localhost", port))
            except OSError:
                continue
            return port
