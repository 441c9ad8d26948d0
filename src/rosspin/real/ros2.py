"""Run nodes on the real ROS 2: Python nodes on rclpy, each in a process of its own, and collect the run.

Nothing of a run leaves this machine, and nothing is left of it: no process, no folder, no shared memory.
"""

from __future__ import annotations

import math
import os
import platform
import random
import re
import shutil
import signal
import sys
import time
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import TextIO

from ..clocks.ctrl_c import ROS2_LAUNCH, Ending
from ..results.ticks import Run, Tick
from ..run.source import around_package, words_of
from .children import SITECUSTOMIZE, START_PATIENCE, Children, check_seconds, say_deaths

__all__ = ["Nodes", "Ros2Missing", "launch", "missing", "python", "remedy", "unavailable", "version"]


NS = 10**9

# Where `make ros2` puts it: in an environment of its own, because its packages restart every Python there.
_CHECKOUT = Path(__file__).parents[3]
_MADE = _CHECKOUT / "build" / "ros2" / "bin" / "python"

# Where the Python is for which a ROS 2 of the system's is made.
_SYSTEM = "/usr/bin:/bin"

_PROBE = Path(__file__).with_name("ros2_probe.py")

# Compiled under a name without a source: in a traceback, each of its frames is then one line that can be recognised.
_PROBING = f"""exec(compile(open({str(_PROBE)!r}).read(), "<rosspin>", "exec"), {{}})
"""

_MESSAGES = re.compile(r"\w+_(msgs|srvs|interfaces)").fullmatch

# What the probe writes (see there), and its frames in tracebacks, which a node without it would not have.
_TOLD = re.compile(r"\x1b]rosspin;(\w+) ([^\x07]*)\x07\n?")
_FRAME = re.compile(r'^ +File "<rosspin>", line .*\n')
_BEGIN = re.compile(r"\x1b]rosspin;begin ")

# What in the caller's environment would change the run or its console.
_UNWANTED = re.compile(
    "PYTHONHOME|RCUTILS_.*|RMW_.*|ROS_(DOMAIN_ID|LOCALHOST_ONLY|STATIC_PEERS|DISABLE_LOANED_MESSAGES|SECURITY_.*)|FAST.*"
)

# Also what other wheels leave in the environment of their children: with it, these would not find their libraries.
_UNWANTED_BY_WHEELS = re.compile(f"{_UNWANTED.pattern}|_ROS_WHEELS_BOOTSTRAP_COMPLETE|LD_LIBRARY_PATH|PYTHONPATH")


class Ros2Missing(RuntimeError):
    """ROS 2 is not installed; the message says what to do."""

    def __init__(self) -> None:
        super().__init__(f"ROS 2 is not installed (no rclpy): {remedy()}")


@cache
def python() -> str:
    """Find a Python with rclpy: from ``make ros2``, or from a ROS 2 whose set-up was sourced; "" if there is none."""
    if _MADE.exists():
        return str(_MADE)
    if "AMENT_PREFIX_PATH" in os.environ:
        return shutil.which("python3", path=f"{_SYSTEM}:{os.environ.get('PATH', '')}") or ""
    return ""


@cache
def version() -> str:
    """Return which ROS 2 is installed, such as ``Jazzy, rclpy 7.1.6``; "" if none is."""
    code = (
        "import os, rclpy; from importlib.metadata import distributions, version\n"
        "wheels = [found.name for found in distributions() if found.name.endswith('-rclpy')]\n"
        "name = max(wheels or ['rclpy'], key=len)\n"  # ros-jazzy-rclpy brings ros-rclpy
        "distro = name.split('-')[1] if wheels else os.environ.get('ROS_DISTRO', '')\n"
        "print(f'{distro.title()}, rclpy {version(name)}')"
    )
    if not python():
        return ""
    with Nodes() as nodes:
        output = nodes.run([python(), "-c", code], START_PATIENCE)
    return output.console.strip() if output.status == 0 else ""


def missing() -> list[str]:
    """List what this machine lacks to run ROS 2 nodes. Empty if nothing is missing."""
    return [] if version() else ["rclpy"]


def remedy() -> str:
    """Return what to do on this machine to have ROS 2."""
    if (_CHECKOUT / "Makefile").exists():
        return unavailable() or "make ros2"
    return "install ROS 2, and source its setup.bash"


def unavailable() -> str:
    """Why ROS 2 cannot be installed from its wheels with this Python; "" if it can."""
    system, machine, own = platform.system(), platform.machine(), sys.version_info[:2]
    if (system, machine) == ("Linux", "x86_64") and (3, 10) <= own <= (3, 14):
        return ""
    here = f"{system} on {machine} with Python {own[0]}.{own[1]}"
    return f"the wheels of ROS 2 are for Linux on x86_64 with Python 3.10 to 3.14; this is {here}"


def launch(
    node: str | os.PathLike[str],
    seconds: float | None = None,
    args: Sequence[str] = (),
    onward: TextIO | None = None,
) -> Run:
    """Run a node file on the real ROS 2, where it meets no other node.

    Time counts from the moment at which its first node has been made. Ctrl-C is pressed at ``seconds``; without them,
    the run ends at a real Ctrl-C or when the node does. A node that does not end is killed when ``ros2 launch`` would.
    ``args`` are the node's, such as ``("--ros-args", "-r", "__ns:=/mrp")``. The console is also written to
    ``onward``, as it comes. A timer's ticks last from call to return, a Rate's from pass to pass.

    Raises :class:`Ros2Missing`, OSError if the file cannot be read, ValueError if it is no Python file or ``seconds``
    is negative, RuntimeError if no node is made within a minute, and KeyboardInterrupt if Ctrl-C is pressed before
    ``seconds`` are over.
    """
    check_seconds(seconds)
    path = Path(node)
    with open(path, "rb"):
        pass
    if path.suffix != ".py":
        raise ValueError(f"{path}: not a Python node (.py)")
    if missing():
        raise Ros2Missing
    with Nodes() as nodes:
        return nodes.launch(path, seconds, args, onward)


class Nodes(Children):
    """A temporary folder for what nodes write, and the nodes. Leaving it ends the nodes and removes the folder.

    The nodes see no others; with ``meet`` they see each other.
    """

    ending = ROS2_LAUNCH

    def __init__(self, meet: bool = False) -> None:
        super().__init__()
        self._discovery = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST" if meet else "OFF"}
        if meet:
            # Domains up to 101 avoid the ports that Linux gives out by itself; other people's nodes are in domain 0.
            self._discovery["ROS_DOMAIN_ID"] = str(random.randint(1, 101))
        (self.folder / "sitecustomize.py").write_text(SITECUSTOMIZE + _PROBING)

    @property
    def environment(self) -> dict[str, str]:
        """The environment of each program that is started here."""
        unwanted = _UNWANTED if python() != str(_MADE) else _UNWANTED_BY_WHEELS
        return {
            **{name: value for name, value in super().environment.items() if not unwanted.fullmatch(name)},
            **self._discovery,
            # With shared memory, Fast DDS would leave half a megabyte behind for every node that is killed. Nodes that
            # meet have some all the same: on localhost alone, rmw_fastrtps chooses the transports itself.
            "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4",
        }

    def launch(
        self,
        file: Path,
        seconds: float | None = None,
        args: Sequence[str] = (),
        onward: TextIO | None = None,
        ending: Ending | None = None,
    ) -> Run:
        """Run a node file: see :func:`launch`; ``ending`` says how it is ended."""
        measured = _Measured()
        folders = (str(self.folder), around_package(str(file.resolve().parent)), self.environment.get("PYTHONPATH"))
        path = os.pathsep.join(filter(None, folders))
        command = [python(), *words_of(str(file)), *args]
        begins = None if seconds is None else _BEGIN
        output = self.run(command, seconds, onward, begins, ending, measured, {"PYTHONPATH": path})
        # Python itself has reported an interrupt; no one has reported an abort or a kill.
        silent = output.status > 128 and output.status != 128 + signal.SIGINT
        said = say_deaths({file.name: output.status} if silent else {}, onward) + _say_lacking(output.console, onward)
        return Run(
            output.console + said,
            measured.ticks(),
            output.status,
            "ros2",
            time.time() - output.start if seconds is None else seconds,
            measured.start or output.start,
        )


def _say_lacking(console: str, onward: TextIO | None) -> str:
    """Say so if a node ended because ROS 2's wheels, which are few, lack a package of messages."""
    found = re.search(r"^ModuleNotFoundError: No module named '(\w+)\b.*\n\Z", console, re.M)
    if not found or not _MESSAGES(found[1]) or python() != str(_MADE):
        return ""
    there = sorted(
        path.name for path in _MADE.parents[1].glob("lib/python*/site-packages/*_*s") if _MESSAGES(path.name)
    )
    line = f"rosspin: make ros2 does not install {found[1]}; its message packages are {', '.join(there)}\n"
    if onward:
        onward.write(line)
    return line


class _Measured:
    """Takes what the probe writes out of the lines of a console, and keeps it."""

    def __init__(self) -> None:
        self.start = 0.0
        self._zero = 0
        self._ticks: dict[tuple[str, int], tuple[int, int]] = {}
        self._durations: dict[tuple[str, int], int] = {}

    def __call__(self, line: str) -> str:
        return "" if _FRAME.match(line) else _TOLD.sub(self._keep, line)

    def _keep(self, match: re.Match[str]) -> str:
        if match[1] == "begin":
            self._zero = int(match[2])
            self.start = self._zero / NS
        else:
            source, number, *times = match[2].split("\t")
            if match[1] == "tick":
                self._ticks[source, int(number)] = int(times[0]), int(times[1])
            else:
                self._durations[source, int(number)] = int(times[0])
        return ""

    def ticks(self) -> tuple[Tick, ...]:
        """Return the ticks, in the order in which they began."""
        ticks = [
            Tick(*key, (expected - self._zero) / NS, (real - self._zero) / NS, self._durations.get(key, math.nan) / NS)
            for key, (expected, real) in self._ticks.items()
        ]
        return tuple(sorted(ticks, key=lambda tick: tick.real))
