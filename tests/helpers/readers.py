"""A reader in a browser: patient, however busy the machine, and done with loading when a test looks at the page."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Page

# How long a test waits for what should be on a page until it gives up (ms). Playwright's own 5 s and 30 s are too short
# where Python starts, or the machine is busy.
PATIENCE = 120_000


@contextmanager
def reader(browser: Browser, **options: Any) -> Iterator[BrowserContext]:
    """A reader who comes for the first time; the options go to Playwright's ``new_context``."""
    with browser.new_context(**options) as context:
        context.set_default_timeout(PATIENCE)
        yield context


def read_to_the_end(page: Page) -> None:
    """Scroll to the end of a page that is loaded; what is only loaded there has come when this returns."""
    page.evaluate("""async () => {
        window.scrollTo(0, document.body.scrollHeight)
        await Promise.allSettled([...document.images].map(image => image.decode()))
        await document.fonts.ready
    }""")


def until(page: Page, holds: Callable[[], bool]) -> None:
    """Wait until something holds of a page. Playwright's ``wait_for_function`` does not go with our policy: no eval."""
    end = time.monotonic() + PATIENCE / 1e3
    while not holds() and time.monotonic() < end:
        page.wait_for_timeout(50)
    assert holds()


def asks_for_no_more(page: Page) -> None:
    """Give a page that is loaded the time in which it would have asked for what it should not.

    Not Playwright's "networkidle", which it advises against: now and then that never comes, though nothing is loaded.
    """
    page.wait_for_timeout(500)
