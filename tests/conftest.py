"""What several tests share: the built site, and what a machine may lack."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SITE = ROOT / "build" / "html"
DOCTREES = ROOT / "build" / "doctrees"


def _lacks_ros1() -> str:
    commands = [name for name in ("roslaunch", "rosmaster", "catkin_make") if not shutil.which(name)]
    return f"ROS 1 is not installed (no {', '.join(commands)})" if commands else ""


def _browser() -> str | None:
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


# What a test may ask for, and why it is not here ("" if it is).
LACKS: dict[str, Callable[[], str]] = {
    "ros1": _lacks_ros1,
    "browser": lambda: "" if _browser() else "Chromium is not installed",
}


def _required() -> set[str]:
    return set(os.environ.get("ROSSPIN_REQUIRE", "").replace(",", " ").split())


def pytest_configure() -> None:
    if unknown := _required() - LACKS.keys():
        raise pytest.UsageError(f"ROSSPIN_REQUIRE knows {', '.join(LACKS)}; not {', '.join(sorted(unknown))}")


@pytest.fixture(scope="session")
def require() -> Callable[[str], None]:
    """``require("ros1")`` skips the test where ROS 1 is lacking; with ROSSPIN_REQUIRE=ros1 it fails there."""

    def check(name: str) -> None:
        if reason := LACKS[name]():
            (pytest.fail if name in _required() else pytest.skip)(reason)

    return check


@pytest.fixture(scope="session")
def chromium(require: Callable[[str], None]) -> str:
    """The path of Chromium."""
    require("browser")
    path = _browser()
    assert path
    return path


@pytest.fixture(scope="session")
def site() -> Path:
    """The folder of the built site."""
    if not ((SITE / "index.html").exists() and DOCTREES.exists()):  # a failed build leaves no doctrees
        pytest.fail("the site is not built, or not to its end: run `make html` first")
    return SITE
