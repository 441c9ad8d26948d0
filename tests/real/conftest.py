"""What only the real lane has: what a machine may lack, the site in a browser, and what runs leave behind."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Generator, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from benchmarks.in_chromium import launched, served
from rosspin import doctor
from tests.helpers.cpp_nodes import CppNodes, built
from tests.helpers.firefox import Tab, firefox, tab
from tests.helpers.lacking import LACKS
from tests.helpers.leftovers import processes
from tests.helpers.readers import PATIENCE
from tests.helpers.verdicts import Inconclusive

expect.set_options(timeout=PATIENCE)

# WebAssembly is compiled quickly, not well: what a test runs of it is over before a better compiler would pay.
QUICK = ["--js-flags=--liftoff-only"]

# A test that the machine disturbed runs so many times more, at once.
RERUNS = 2


def _required() -> set[str]:
    return set(os.environ.get("ROSSPIN_REQUIRE", "").replace(",", " ").split())


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--conclusive", action="store_true", help="a test that stays inconclusive fails")


def pytest_configure() -> None:
    if unknown := _required() - LACKS.keys():
        raise pytest.UsageError(f"ROSSPIN_REQUIRE knows {', '.join(LACKS)}; not {', '.join(sorted(unknown))}")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        item.add_marker(pytest.mark.flaky(reruns=RERUNS, reruns_delay=1, only_rerun=Inconclusive))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """A test that stays inconclusive tells nothing of what it tests: it is skipped, with the reason."""
    report = yield
    is_last = getattr(item, "execution_count", 0) > RERUNS
    if call.excinfo and isinstance(call.excinfo.value, Inconclusive) and is_last and not item.config.option.conclusive:
        report.outcome = "skipped"
        report.longrepr = (str(item.path), item.location[1] or 0, f"inconclusive: {call.excinfo.value}")
    return report


@pytest.fixture(scope="session")
def require() -> Callable[[str], None]:
    """``require("ros1")`` skips the test where ROS 1 is lacking; with ROSSPIN_REQUIRE=ros1 it fails there."""

    def check(name: str) -> None:
        if reason := LACKS[name]():
            (pytest.fail if name in _required() else pytest.skip)(reason)

    return check


@pytest.fixture
def leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Every run in its own temporary folder: no file in it and no process from it is there afterwards."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)
    yield tmp_path
    assert list(tmp_path.glob("rosspin-*")) == []
    assert processes(tmp_path) == []


@pytest.fixture(scope="session")
def cpp_nodes(require: Callable[[str], None], tmp_path_factory: pytest.TempPathFactory) -> CppNodes:
    """The same for all of xdist's workers."""
    require("ros1")
    folder = tmp_path_factory.getbasetemp()
    return built((folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder) / "cpp_nodes")


@pytest.fixture(scope="session")
def chromium(require: Callable[[str], None]) -> str:
    """The path of Chromium: of that without windows if it is there, which takes two thirds of the processor time."""
    require("browser")
    path = shutil.which("chromium-headless-shell") or doctor.chromium()
    assert path
    return path


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    """The site on a local server."""
    with served(site) as address:
        yield address


@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Browser]:
    """One browser for all pages."""
    with launched(chromium, *QUICK) as browser:
        yield browser


@pytest.fixture(scope="module")
def firefox_page(require: Callable[[str], None]) -> Iterator[Tab]:
    """One tab of Firefox for all pages; nothing may go wrong in them."""
    require("firefox")
    with tab(firefox() or "") as page:
        page.resize(1280, 800)
        yield page
        assert not page.wrong
