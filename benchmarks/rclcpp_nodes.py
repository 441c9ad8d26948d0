"""The C++ nodes of ROS 2: built where CMake finds rclcpp, and run as others are on the real ROS 2."""

from __future__ import annotations

import fcntl
import math
import os
import re
import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path

from rosspin import Tick
from rosspin.clocks.ctrl_c import Ending
from rosspin.real import ros2
from rosspin.real.children import Output

__all__ = ["PACKAGE", "PROBES", "Programs", "build", "compiler", "libraries", "missing", "read_ticks"]

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "examples/my_robotics_pkg_ros2_cpp"
PROBES = ROOT / "examples/ros2"  # and the steps of the tutorial

# Where they are built, so that only what has changed is built again.
FOLDER = ROOT / "build/ros2_cpp"

# As the page promises.
FLAGS = "-DCMAKE_CXX_FLAGS=-std=c++17 -Wall -Wextra -Werror"

_BEGIN = re.compile("^start,")


@cache
def missing() -> str:
    """Why C++ nodes of ROS 2 cannot be built here; "" if they can."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    try:
        found = _configure(PROBES)
    except FileNotFoundError:
        return "C++ nodes of ROS 2 cannot be built: CMake is not installed"
    return "C++ nodes of ROS 2 cannot be built: CMake does not find rclcpp" if found.returncode else ""


class Programs:
    """The programs of a folder; ``version`` says of which ROS 2, such as ``Jazzy, rclcpp 28.1.6``."""

    def __init__(self, folder: Path, version: str) -> None:
        self.folder = folder
        self.version = f"{ros2.version().partition(',')[0]}, {version}"

    def __getitem__(self, name: str) -> str:
        (path,) = (path for path in self.folder.glob(f"*/{name}") if os.access(path, os.X_OK))
        return str(path)

    def run(
        self,
        nodes: ros2.Nodes,
        name: str,
        seconds: float | None,
        args: Sequence[str] = (),
        ending: Ending = Ending(((signal.SIGINT, 5.0),)),
    ) -> Output:
        """Run a program; the seconds of a probe count from its first timer or pass."""
        begins = _BEGIN if name.endswith("_probe") and seconds is not None else None
        return nodes.run([self[name], *args], seconds, begins=begins, ending=ending, more=libraries())


def libraries() -> dict[str, str]:
    """Where the libraries of ROS 2 are, as its set-up says it: where CMake found rclcpp and what it needs."""
    places = [os.environ.get(name, "") for name in ("CMAKE_PREFIX_PATH", "AMENT_PREFIX_PATH")]
    folders = [f"{prefix}/lib" for prefix in ":".join(places).split(":") if prefix]
    return {"LD_LIBRARY_PATH": ":".join(filter(None, [*folders, os.environ.get("LD_LIBRARY_PATH")]))}


@cache
def build() -> Programs:
    """Build the tutorial's package, its steps and the probes. Raises RuntimeError with what the compiler says."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    version = ""
    for source in (PACKAGE, PROBES):
        said = _configure(source)
        with _locked():
            made = _cmake("--build", FOLDER / source.name, "--parallel", str(os.cpu_count() or 1))
        if said.returncode or made.returncode:
            raise RuntimeError("\n".join((said.stderr, made.stdout, made.stderr)))
        if found := re.search(r"rclcpp \d\S+", said.stdout):
            version = found[0]
    return Programs(FOLDER, version)


@contextmanager
def _locked() -> Iterator[None]:
    """One process at a time builds."""
    with open(FOLDER / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _configure(source: Path) -> subprocess.CompletedProcess[str]:
    with _locked():
        return _cmake("-S", source, "-B", FOLDER / source.name, FLAGS)


def compiler() -> str:
    """Which compiler builds them."""
    run = subprocess.run(["c++", "--version"], check=True, capture_output=True, text=True)
    return run.stdout.splitlines()[0]


def _cmake(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["cmake", *words], capture_output=True, text=True)


def read_ticks(console: str) -> tuple[Tick, ...]:
    """The ticks that a probe told of, in the order in which they began."""

    def told(word: str) -> Iterator[tuple[tuple[str, int], list[float]]]:
        for line in console.splitlines():
            if line.startswith(f"{word},"):
                source, number, *times = line.split(",")[1:]
                yield (source, int(number)), [float(time) for time in times]

    durations = dict(told("done"))
    return tuple(
        Tick(*key, expected, real, durations.get(key, [math.nan])[0]) for key, (expected, real) in told("tick")
    )
