"""All exercises in Chromium: the page says of an answer what a notebook says of it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page

from tests.helpers.answers import NAMES
from tests.helpers.exercises_in_page import is_checked, open_page


@pytest.fixture(scope="module")
def page_of_exercises(browser: Browser, address: str) -> Iterator[Page]:
    with open_page(browser, address) as page:
        yield page


@pytest.mark.parametrize("name", NAMES)
def test_exercise_is_checked(page_of_exercises: Page, address: str, name: str) -> None:
    is_checked(page_of_exercises, address, name)
