"""What several tests share: the built site, and what a machine may lack."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from corpus_ros2 import KILTED_PYTHON
from firefox import firefox
from hypothesis import settings
from in_chromium import launched, served
from message_probe import PACKAGES
from playwright.sync_api import Browser, Page, expect

from rosspin import doctor, ros2

# What random tests draw from, Hypothesis's too if it is asked for. CI always draws the same, as Hypothesis does there.
# Processes that share the tests out among them draw once.
DRAWN = "0" if "CI" in os.environ else str(random.SystemRandom().randrange(10**6))
SEED = int(os.environ.get("ROSSPIN_SEED") or os.environ.setdefault("ROSSPIN_DRAWN_SEED", DRAWN))

# How long a test waits for what should be on a page until it gives up (ms). Playwright's own 5 s are too short where
# Python starts, or the machine is busy.
PATIENCE = 120_000
expect.set_options(timeout=PATIENCE)

ROOT = Path(__file__).parent.parent
SITE = ROOT / "build" / "html"
DOCTREES = ROOT / "build" / "doctrees"

# A node whose threads print at the same time, on both streams.
CHATTER = """
import sys, threading
def chatter(word):
    for _ in range(2000):
        print(word)
        print(word, file=sys.stderr)
for word in 4 * ("one", "two"):
    threading.Thread(target=chatter, args=(word,)).start()
"""


@cache
def _lacks_ros1() -> str:
    commands = [name for name in ("roslaunch", "rosmaster", "catkin_make") if not shutil.which(name)]
    if commands:
        return f"ROS 1 is not installed (no {', '.join(commands)})"
    importing = f"import {', '.join(f'{name}.msg' for name in PACKAGES)}"
    run = subprocess.run(["/usr/bin/python3", "-c", importing], capture_output=True, text=True)
    return f"ROS 1 is not all installed ({run.stderr.splitlines()[-1]})" if run.returncode else ""


# What a test may ask for, and why it is not here ("" if it is).
LACKS: dict[str, Callable[[], str]] = {
    "ros1": _lacks_ros1,
    "ros2": lambda: str(ros2.Ros2Missing()) if ros2.missing() else "",
    "kilted": lambda: "" if KILTED_PYTHON.exists() else "Kilted is not installed (make ros2 DISTRO=kilted)",
    "browser": lambda: "" if doctor.chromium() else "Chromium is not installed",
    "firefox": lambda: "" if firefox() else "Firefox is not installed",
}


def pytest_report_header() -> str:
    return f"random tests: ROSSPIN_SEED={SEED}"


def _required() -> set[str]:
    return set(os.environ.get("ROSSPIN_REQUIRE", "").replace(",", " ").split())


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    if "ROSSPIN_SEED" in os.environ:
        settings.load_profile("default")  # CI's takes no seed
        config.option.hypothesis_seed = SEED
    if unknown := _required() - LACKS.keys():
        raise pytest.UsageError(f"ROSSPIN_REQUIRE knows {', '.join(LACKS)}; not {', '.join(sorted(unknown))}")


@pytest.fixture
def write(tmp_path: Path) -> Any:
    """Writes a node file; its path."""

    def write(text: str, name: str = "node.py") -> Path:
        path = tmp_path / name
        path.write_text(dedent(text), encoding="utf-8")
        return path

    return write


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
    path = doctor.chromium()
    assert path
    return path


@pytest.fixture(scope="session")
def site() -> Path:
    """The folder of the built site."""
    # A build with warnings or an error leaves no environment.
    if not ((SITE / "index.html").exists() and (DOCTREES / "environment.pickle").exists()):
        pytest.fail("the site is not built, or not to its end: run `make html` first")
    return SITE


# --- the site in Chromium ---------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    """The site on a local server."""
    with served(site) as address:
        yield address


@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Browser]:
    """One browser for all pages."""
    with launched(chromium) as browser:
        yield browser


def faults(page: Page, address: str) -> list[str]:
    """A list to which all is added that goes wrong in a page from now on, what it asks of another host included."""
    wrong: list[str] = []

    def note(bad: bool, what: str) -> None:
        if bad:
            wrong.append(what)

    page.on("request", lambda request: note(not request.url.startswith((address, "data:", "blob:")), request.url))
    page.on("response", lambda response: note(response.status >= 400, f"{response.status} {response.url}"))
    page.on("console", lambda message: note(message.type == "error", message.text))
    page.on("pageerror", lambda error: note(True, str(error)))
    return wrong
