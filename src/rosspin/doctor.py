"""Say what can run on this machine, and what to install for the rest."""

from __future__ import annotations

import importlib.util
import shutil
from collections.abc import Iterator

from . import ros1, ros2

__all__ = ["chromium", "report"]

_APT = "on Debian and Ubuntu: sudo apt-get install"


def chromium() -> str | None:
    """The path of Chromium, or of its sibling Chrome; None if neither is installed."""
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def report() -> Iterator[str]:
    """Yield a line for each runtime: its name, yes or no, and after a no what to install."""
    lacking = [name for name in ("greenlet", "yaml") if not importlib.util.find_spec(name)]
    yield _line("stand-in", lacking, "pip install greenlet PyYAML")
    yield _line("rospy", ros1.missing(cpp=False), f"{_APT} python3-rospy python3-roslaunch python3-rosmaster")
    yield _line("roscpp", ros1.missing(), f"{_APT} {ros1.APT}")
    yield _line("rclpy", ros2.missing(), ros2.unavailable() or ros2.REMEDY)
    yield _line("browser", [] if chromium() else ["Chromium"], f"{_APT} chromium")


def _line(runtime: str, lacking: list[str], remedy: str) -> str:
    return f"{runtime:<9} no   lacks {', '.join(lacking)}; {remedy}" if lacking else f"{runtime:<9} yes"
