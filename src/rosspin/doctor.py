"""Say what can run on this machine, and what to install for the rest; in a checkout also how old its recordings are."""

from __future__ import annotations

import importlib.util
import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path

from .real import ros1, ros2

__all__ = ["chromium", "report"]

# Next to the project's tests: which recording of the real ROS was confirmed when, and by which version.
_LEDGER = Path(__file__).parents[2] / "tests" / "ledger.toml"

_APT = "on Debian and Ubuntu: sudo apt-get install"


def chromium() -> str | None:
    """Return the path of Chromium, or of its sibling Chrome; None if neither is installed."""
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def report() -> Iterator[str]:
    """Yield a line for each runtime: its name, yes or no, and after a no what to install.

    In a checkout there is another one for each ROS: since when its recordings have been confirmed.
    """
    lacking = [name for name in ("greenlet", "yaml") if not importlib.util.find_spec(name)]
    yield _line("stand-in", lacking, "pip install greenlet PyYAML")
    yield _line("rospy", ros1.missing(cpp=False), f"{_APT} python3-rospy python3-roslaunch python3-rosmaster")
    yield _line("roscpp", ros1.missing(), f"{_APT} {ros1.APT}")
    yield _line("rclpy", ros2.missing(), ros2.remedy())
    yield _line("browser", [] if chromium() else ["Chromium"], f"{_APT} chromium")
    yield _line("bwrap", [] if shutil.which("bwrap") else ["bubblewrap, which seals answers"], f"{_APT} bubblewrap")
    if _LEDGER.exists():
        yield from _recordings()


def _line(runtime: str, lacking: list[str], remedy: str) -> str:
    return f"{runtime:<9} no   lacks {', '.join(lacking)}; {remedy}" if lacking else f"{runtime:<9} yes"


def _recordings() -> Iterator[str]:
    """Yield a line for each ROS: how many of its recordings there are, and when the oldest was last confirmed."""
    batches = tomllib.loads(_LEDGER.read_text(encoding="utf-8")).get("confirmed", ())
    for ros in sorted({batch["ros"] for batch in batches}):
        own = [batch for batch in batches if batch["ros"] == ros]
        count = sum(len(batch["scenarios"]) for batch in own)
        oldest = min(own, key=lambda batch: batch["date"])
        confirmed = f"confirmed on {oldest['date']} or later by {oldest['version']}"
        yield f"recorded  ROS {ros}: {count} scenarios, {confirmed} (make judge)"
