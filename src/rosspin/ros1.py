"""Run nodes on the real ROS 1: build their package in a temporary workspace, launch them and collect the run.

Every run has its own master, on a free port of the loopback interface, and its own folder for what ROS writes. All of
it is gone when the run is over, however it ends.
"""

from __future__ import annotations

import math
import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple, TextIO

from .console import read_ticks
from .ticks import Run

__all__ = ["APT", "BuildFailed", "Ros1Missing", "Workspace", "launch", "missing"]

# What to install on Debian and Ubuntu.
APT = "build-essential catkin libroscpp-dev python3-roslaunch python3-rosmaster python3-rospy rosbash"

# Signals that ask a process to end, and how long (s) each is given to be heeded.
Patience = Sequence[tuple[signal.Signals, float]]

# As roslaunch does it: for a node.
_PATIENCE = ((signal.SIGINT, 15.0), (signal.SIGTERM, 2.0), (signal.SIGKILL, 5.0))

# roslaunch itself may take that long and a little more, for the nodes and then for its master.
_LAUNCH_PATIENCE = ((signal.SIGINT, 25.0), (signal.SIGTERM, 2.0), (signal.SIGKILL, 5.0))

# So long (s) may a master or roslaunch take to get going on a busy machine.
_START_PATIENCE = 60.0

# What in the caller's environment would change the run or its console.
_UNWANTED = ("PYTHONHOME", "ROSCONSOLE_CONFIG_FILE", "ROSCONSOLE_FORMAT", "ROS_IP", "ROS_IPV6", "ROS_NAMESPACE")

# roslaunch writes titles for the terminal's window even where there is none.
_TITLE = re.compile(r"\x1b]2;[^\x07]*\x07")

_STARTED = re.compile(r"process\[(?!master|rosout)[^]]*\]: started with pid")
_DIED = re.compile(r"\[([^][]+)\] process has died \[pid \d+, exit code (-?\d+)")
_STOPPED = re.compile(r"process\[([^]]+)\]: SIG\w+ killed with return value (-?\d+)")
_KILLED = re.compile(r"process\[([^]]+)\]: sent SIGKILL")

# A package of loose node files; what the tutorial adds for a node, for each.
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


class Output(NamedTuple):
    """What a process did: console text, exit status as a shell has it, start (s since the epoch)."""

    console: str
    status: int
    start: float


def missing(cpp: bool = True) -> list[str]:
    """List what this machine lacks to run ROS 1 nodes: with ``cpp`` also those in C++. Empty if nothing is missing."""
    path = _path()
    commands = ["roslaunch", "rosmaster", *(["catkin_make", "c++", "make"] if cpp else [])]
    lacking = [command for command in commands if not shutil.which(command, path=path)]
    python = shutil.which("python3", path=path)
    probe = [python or "", "-c", "import rospy"]
    if not python or subprocess.run(probe, env=_environment(), stderr=subprocess.DEVNULL).returncode:
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
    or when its nodes end. What does not end is killed, when roslaunch would do so. ``args`` are the launch file's
    (``"name:=value"``) or the node's (``"__ns:=/mrp"``). The console is also written to ``onward``, as it comes. If a
    node dies or is killed, the last lines of the console name it, and the run has its exit status.

    Raises :class:`Ros1Missing`, :class:`BuildFailed`, OSError if the file cannot be read, ValueError if it cannot be
    run or ``seconds`` is negative, RuntimeError if ROS does not start, and KeyboardInterrupt if Ctrl-C is pressed
    before ``seconds`` are over.
    """
    if seconds is not None and not 0 <= seconds < math.inf:
        raise ValueError(f"seconds must be a number of at least 0, not {seconds!r}")
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
    last_words = "".join(f"rosspin: {name} ended with status {_named(status)}\n" for name, status in deaths.items())
    if onward is not None and last_words:
        onward.write(last_words)
    return Run(
        output.console + last_words,
        read_ticks(output.console, start=output.start),
        next(iter(deaths.values()), 0),
        "ros1",
        time.time() - output.start if seconds is None else seconds,
        output.start,
    )


class Workspace:
    """A temporary catkin workspace and a port for a master. Leaving it ends what was started there and removes it."""

    def __init__(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="rosspin-"))
        self.source = self.folder / "src"
        self.source.mkdir()
        self.port = _free_port()
        self._mark = f"ROS_HOME={self.folder}".encode()
        self._children: list[subprocess.Popen[bytes]] = []
        self._sources: dict[Path, Path] = {}  # what was copied here, by its copy

    def __enter__(self) -> Workspace:
        return self

    def __exit__(self, *error: object) -> None:
        try:
            for number in (signal.SIGINT, signal.SIGTERM):
                _signal_all(self._processes, number, 3.0)
        finally:
            _signal_all(self._processes, signal.SIGKILL, 5.0)
            for child in self._children:
                child.wait()
            shutil.rmtree(self.folder, ignore_errors=True)

    @property
    def environment(self) -> dict[str, str]:
        """The environment of whatever runs here."""
        return {
            **_environment(),
            "ROS_MASTER_URI": f"http://localhost:{self.port}",
            "ROS_HOSTNAME": "localhost",
            "ROS_HOME": str(self.folder),
            "ROS_LOG_DIR": str(self.folder / "log"),
            # Through a pipe both languages would keep their lines back until they have many.
            "PYTHONUNBUFFERED": "1",
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
        build = self._start(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = (text.decode(errors="replace") for text in build.communicate())
        for copy, source in self._sources.items():
            out, err = out.replace(str(copy), str(source)), err.replace(str(copy), str(source))
        if build.returncode:
            raise BuildFailed(err.strip() or out.strip())
        return out + err

    def executable(self, source: Path) -> Path:
        """The program that comes of a C++ node file: built with its package, or with one made for it alone."""
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
        master = self._start(["rosmaster", "--core", "-p", str(self.port)], stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + _START_PATIENCE
        while master.poll() is None and time.monotonic() < deadline:
            with socket.socket() as probe:
                if probe.connect_ex(("localhost", self.port)) == 0:
                    return
            time.sleep(0.02)
        raise RuntimeError(f"rosmaster did not start on port {self.port}")

    def roslaunch(
        self, file: Path, seconds: float | None, args: Sequence[str] = (), onward: TextIO | None = None
    ) -> tuple[Output, dict[str, int]]:
        """Build the package of a launch file and launch it; also the statuses of nodes that did not end with 0."""
        package = _package_of(file)
        assert package is not None
        self.add_package(package)
        self.build()
        copy = self.source / package.resolve().name / file.resolve().relative_to(package.resolve())
        command = [str(self.folder / "devel/env.sh"), "roslaunch", "-p", str(self.port), str(copy), *args]
        output = self.run(command, seconds, onward, _STARTED, _LAUNCH_PATIENCE)
        # What nodes did at Ctrl-C is only in roslaunch's log.
        log = "".join(path.read_text() for path in self.folder.glob("log/*/roslaunch-*.log"))
        deaths = [(name, int(code)) for name, code in _DIED.findall(output.console) + _STOPPED.findall(log)]
        deaths += [(name, -signal.SIGKILL) for name in _KILLED.findall(log)]
        if output.status and not deaths:
            deaths = [("roslaunch", output.status)]
        return output, {name: _status(code) for name, code in deaths if code and not re.match("master|rosout", name)}

    def run(
        self,
        command: Sequence[str],
        seconds: float | None,
        onward: TextIO | None = None,
        begins: re.Pattern[str] | None = None,
        patience: Patience | None = None,
    ) -> Output:
        """Run a command until it ends or ``seconds`` are over, then press Ctrl-C; ``patience`` says what comes after.

        The seconds count from the first line of the console that matches ``begins``, or else from the start. A real
        Ctrl-C ends the command in the same way; one that cuts ``seconds`` short goes on to the caller after that.
        """
        patience = patience or _PATIENCE
        process = self._start(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        console = _Reader(process, onward, begins, patience)
        try:
            if begins is not None and not console.begun.wait(_START_PATIENCE):
                raise RuntimeError(f"{command[0]} did not start anything:\n{console.text()}")
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            _end(process, patience)
        except KeyboardInterrupt:
            _end(process, patience)
            if seconds is not None:
                raise
        return Output(console.text(), _status(process.wait()), console.start)

    def _start(self, command: Sequence[str], stdout: int, stderr: int | None = None) -> subprocess.Popen[bytes]:
        # In a session of its own: a Ctrl-C on the terminal is ours to pass on.
        process = subprocess.Popen(
            command,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            start_new_session=True,
        )
        self._children.append(process)
        return process

    def _processes(self) -> Iterator[int]:
        """All that was started here, by whomever: roslaunch gives its nodes sessions of their own."""
        for entry in Path("/proc").glob("[0-9]*/environ"):
            try:
                if self._mark in entry.read_bytes().split(b"\0"):
                    yield int(entry.parent.name)
            except OSError:
                pass
        for child in self._children:
            child.poll()


class _Reader:
    """Collects what a process prints, and passes it on, in a thread."""

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        onward: TextIO | None,
        begins: re.Pattern[str] | None,
        patience: Patience,
    ) -> None:
        assert process.stdout is not None
        self.start = time.time()
        self.begun = threading.Event()
        self._process = process
        self._pipe = process.stdout
        self._onward = onward
        self._begins = begins
        self._patience = patience
        self._lines: list[str] = []
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def text(self) -> str:
        """All that has come; waits a little for what is still on its way."""
        self._thread.join(1.0)
        return "".join(self._lines)

    def _read(self) -> None:
        with self._pipe:
            for raw in self._pipe:
                line = _TITLE.sub("", raw.decode(errors="replace"))
                if self._begins is not None and not self.begun.is_set() and self._begins.search(line):
                    self.start = time.time()
                    self.begun.set()
                self._lines.append(line)
                if self._onward is not None:
                    self._pass_on(line)
        self.begun.set()  # nothing more can begin

    def _pass_on(self, line: str) -> None:
        assert self._onward is not None
        try:
            self._onward.write(line)
            self._onward.flush()
        except OSError:  # nobody listens any more, as after `| head`
            self._onward = None
            threading.Thread(target=_end, args=(self._process, self._patience), daemon=True).start()


def _end(process: subprocess.Popen[bytes], patience: Patience) -> None:
    """End a process with one signal after another, each given its time (s)."""
    for number, wait in patience:
        process.send_signal(number)
        try:
            process.wait(wait)
            return
        except subprocess.TimeoutExpired:
            pass


def _signal_all(processes: Callable[[], Iterator[int]], number: signal.Signals, patience: float) -> None:
    """Send a signal to processes, if there are any, and give them ``patience`` seconds to end."""
    for pid in processes():
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass
    deadline = time.monotonic() + patience
    while any(processes()) and time.monotonic() < deadline:
        time.sleep(0.05)


def _package_of(file: Path) -> Path | None:
    """The folder of the catkin package that a file is in."""
    return next((folder for folder in file.resolve().parents if (folder / "package.xml").exists()), None)


def _path() -> str:
    # ROS is made for the system's Python: another one before it on the path lacks ROS's modules.
    return "/usr/bin:/bin:" + os.environ.get("PATH", "")


def _environment() -> dict[str, str]:
    environment = {name: value for name, value in os.environ.items() if name not in _UNWANTED}
    return {**environment, "PATH": _path()}


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return int(probe.getsockname()[1])


def _status(code: int) -> int:
    """An exit status as a shell has it: 128 + number for a signal."""
    return 128 - code if code < 0 else code


def _named(status: int) -> str:
    return f"{status} ({signal.Signals(status - 128).name})" if 128 < status < 160 else str(status)
