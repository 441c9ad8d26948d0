"""What several tests share: the built site, and what a machine may lack."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from hypothesis import settings
from lacking import LACKS
from seeds import SEED
from tree import DOCTREES, SITE

from rosspin import doctor


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
