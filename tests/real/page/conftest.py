"""What is open in Chromium."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, ViewportSize

from tests.helpers.hand_ins import NO_RUNS, Table, exchange
from tests.helpers.listings_in_page import LISTINGS, Cell, open_tutorial
from tests.helpers.looks import faults
from tests.helpers.readers import reader

LARGE = ViewportSize(width=1280, height=900)


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    """A reader who comes for the first time."""
    with reader(browser, viewport=LARGE) as context:
        yield context


@pytest.fixture
def page(context: BrowserContext, address: str) -> Iterator[Page]:
    """A page in which nothing may go wrong, such as a request to another host."""
    page = context.new_page()
    wrong = faults(page, address)
    yield page
    assert not wrong


# --- the tutorial: it stays open, so that Python need not start for each test -----------------------------------------


@pytest.fixture(scope="module")
def _tutorial(browser: Browser, address: str) -> Iterator[tuple[Page, list[str]]]:
    with reader(browser, viewport=LARGE) as context:
        page = context.new_page()
        wrong = faults(page, address)
        open_tutorial(page, address)
        yield page, wrong


@pytest.fixture
def tutorial(_tutorial: tuple[Page, list[str]]) -> Iterator[Page]:
    """The tutorial with its Python tabs open and its cells as at first; nothing may go wrong in it."""
    page, wrong = _tutorial
    for index in range(len(LISTINGS)):
        Cell(page, index).button("Reset").dispatch_event("click")
    yield page
    assert not wrong


# --- the teachers' page -----------------------------------------------------------------------------------------------


@pytest.fixture
def table(page: Page, address: str) -> Table:
    return Table(page, address)


@pytest.fixture
def quick(context: BrowserContext, table: Table, site: Path) -> Table:
    """One that runs no answer."""
    worker = (site / "_static/live/worker.js").read_text(encoding="utf-8")
    exchange(context, site, worker_js=NO_RUNS.replace("PYTHON", worker).encode())
    return table
