"""All exercises in Chromium: the page says of an answer what a notebook says of it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from answers import NAMES
from exercises_in_page import is_checked, open_pages
from playwright.sync_api import Browser, Page


@pytest.fixture(scope="module")
def pages_of_exercises(browser: Browser, address: str) -> Iterator[dict[int, Page]]:
    with open_pages(browser, address) as pages:
        yield pages


@pytest.mark.parametrize("name", NAMES)
def test_exercise_is_checked(pages_of_exercises: dict[int, Page], name: str) -> None:
    is_checked(pages_of_exercises, name)
