"""The lanes of the tests, and what several tests share. What only the real lane has is in real/conftest.py."""

from __future__ import annotations

import json
import os
import signal
from collections import defaultdict
from collections.abc import Iterator
from contextlib import nullcontext
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from rosspin.clocks.ctrl_c import Ending
from rosspin.results.saving import save_whole
from tests.helpers.seeds import SEED
from tests.helpers.settle import settle
from tests.helpers.shares import SHARE, is_left_out
from tests.helpers.simulated_only import simulated_only
from tests.helpers.surroundings import clean, heed_ctrl_c
from tests.helpers.tree import DOCTREES, ROOT, SITE, TESTS

# Seconds that each file of tests took once, by its path below tests/; and in this run.
DURATIONS: dict[str, float] = json.loads((TESTS / "durations.json").read_text(encoding="utf-8"))
_took: defaultdict[str, float] = defaultdict(float)

clean(os.environ)
heed_ctrl_c()


def pytest_report_header() -> str:
    return f"random tests: ROSSPIN_SEED={SEED}; share of those that come in shares: ROSSPIN_SHARE={SHARE}"


# What it draws follows from the seed alone, not from earlier runs, nor from the time that one takes.
settings.register_profile(
    "seeded", database=None, deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("judge", settings.get_profile("seeded"), max_examples=1000)  # ten times as many
settings.load_profile("seeded")


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    config.option.hypothesis_seed = SEED


# --- lanes ------------------------------------------------------------------------------------------------------------


def lane(name: str) -> str:
    """The lane of a file of tests, by its path below tests/."""
    return "judge" if name.startswith("real/judge/") else "real" if name.startswith("real/") else "simulated"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--share", action="store_true", help="of tests marked shares(n), that of ROSSPIN_SHARE alone")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark each test with its lane; the files that take longest come first, and before them those that are new."""
    if config.option.share:
        config.hook.pytest_deselected(items=[item for item in items if is_left_out(item, SHARE)])
        items[:] = [item for item in items if not is_left_out(item, SHARE)]
    names = {item: item.path.relative_to(TESTS).as_posix() for item in items}
    for item, name in names.items():
        item.add_marker(lane(name))
    items.sort(key=lambda item: -DURATIONS.get(names[item], float("inf")))


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    _took[report.nodeid.partition("::")[0].removeprefix("tests/")] += report.duration


def pytest_sessionfinish(session: pytest.Session) -> None:
    if not hasattr(session.config, "workerinput"):
        durations = DURATIONS | {name: round(seconds, 1) for name, seconds in _took.items()}
        (ROOT / "build").mkdir(exist_ok=True)
        text = json.dumps(dict(sorted(durations.items())), indent=2)
        save_whole(ROOT / "build" / "durations.json", f"{text}\n".encode())


def pytest_collection_finish() -> None:
    settle()


@pytest.fixture(autouse=True, scope="module")
def _settled() -> None:
    """What earlier files have left is not gone through again with each collection of garbage."""
    settle()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup(item: pytest.Item) -> Iterator[None]:
    return (yield from _in_its_lane(item))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    return (yield from _in_its_lane(item))


def _in_its_lane(item: pytest.Item) -> Iterator[None]:
    with simulated_only() if item.get_closest_marker("simulated") else nullcontext():
        return (yield)


# --- fixtures ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def write(tmp_path: Path) -> Any:
    """Writes a node file; its path."""

    def write(text: str, name: str = "node.py") -> Path:
        path = tmp_path / name
        path.write_text(dedent(text), encoding="utf-8")
        return path

    return write


@pytest.fixture
def watchful(monkeypatch: pytest.MonkeyPatch) -> None:
    """A node that stands still is found soon: after half a second's work, not after four."""
    monkeypatch.setattr("rosspin.clocks.watchdog._INTERVAL", 0.05)


@pytest.fixture
def impatient(watchful: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """That, and one that does not heed Ctrl-C is killed after a second."""
    monkeypatch.setattr("rosspin.run.host.Host.ending", Ending(((signal.SIGINT, 1.0),)))


@pytest.fixture(scope="session")
def site() -> Path:
    """The folder of the built site."""
    # A build with warnings or an error leaves no environment.
    if not ((SITE / "index.html").exists() and (DOCTREES / "environment.pickle").exists()):
        pytest.fail("the site is not built, or not to its end: run `make html` first")
    return SITE
