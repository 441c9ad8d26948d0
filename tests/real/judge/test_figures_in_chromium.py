"""All figures with a handle in Chromium."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, BrowserContext

from tests.helpers.figures import Kind, kinds
from tests.helpers.figures_in_chromium import moves_by_keyboard, moves_by_pointer
from tests.helpers.readers import reader


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    with reader(browser, viewport={"width": 1280, "height": 900}) as context:
        yield context


@kinds
def test_by_keyboard(context: BrowserContext, address: str, kind: Kind) -> None:
    moves_by_keyboard(context, address, kind)


@kinds
def test_by_pointer(context: BrowserContext, address: str, kind: Kind) -> None:
    moves_by_pointer(context, address, kind)
