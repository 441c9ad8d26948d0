"""Every page of the built site in Chromium, on a phone and on large screens, in light and dark."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from axe import COLOURS, violations
from looks import FAINT, TOO_WIDE, faults, look
from playwright.sync_api import Browser, Page

# The pictures that leave more than a little of the place that they have beside them.
NARROW = """() => [...document.querySelectorAll("article svg[role=img]")].filter(picture => {
    const width = element => element.getBoundingClientRect().width
    const place = width(picture.parentElement) // in which one of two may be seen
    return place && Math.max(...[...picture.parentElement.querySelectorAll(":scope > svg")].map(width)) < place - 40
}).map(picture => `narrow: ${picture.getAttribute("aria-label")}`)"""

# The lettering that is too small in the plots of a page that are seen (px).
SMALL = """() => [...document.querySelectorAll("figure.rosspin-plot svg[role=img]")]
    .filter(picture => picture.getBoundingClientRect().width)
    .flatMap(picture => [...picture.querySelectorAll("text")].map(text =>
        parseFloat(getComputedStyle(text).fontSize) * (picture.getScreenCTM().a || 1)))
    .filter(size => size < 11).map(size => `small lettering: ${size} px`).slice(0, 5)"""


def _open(page: Page, address: str, name: str) -> list[str]:
    """Open a page and scroll to its end; what goes wrong in it is added to the list, now and later."""
    wrong = faults(page, address)
    page.goto(address + name)
    page.evaluate("window.scrollTo(0, document.body.scrollHeight)")
    return wrong


def _seen(page: Page, *looks: str) -> list[Any]:
    return [found for script in looks for found in page.evaluate(script)]


@pytest.fixture(scope="module")
def names(site: Path) -> list[str]:
    """The pages, by their addresses."""
    return [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]


def test_in_dark_on_a_phone(names: list[str], address: str, browser: Browser) -> None:
    """Nothing from another host, no error, no sideways scrolling, plots that can be read; colours on a large screen."""
    with browser.new_context(viewport={"width": 390, "height": 844}, color_scheme="dark") as context:
        pages = {name: context.new_page() for name in names}
        wrong = {name: _open(page, address, name) for name, page in pages.items()}
        for name, page in pages.items():
            page.wait_for_load_state("networkidle")
            look(page, "dark")
            wrong[name] += _seen(page, TOO_WIDE, FAINT, SMALL)
            page.set_viewport_size({"width": 1280, "height": 844})
            wrong[name] += violations(page, COLOURS)
            page.close()
    assert not {name: found for name, found in wrong.items() if found}


def test_in_light_on_large_screens(names: list[str], address: str, browser: Browser) -> None:
    """Likewise; nothing that axe-core objects to, and figures as wide as the text."""
    with browser.new_context(viewport={"width": 1280, "height": 844}, color_scheme="light") as context:
        pages = {name: context.new_page() for name in names}
        wrong = {name: _open(page, address, name) for name, page in pages.items()}
        for name, page in pages.items():
            page.wait_for_load_state("networkidle")
            look(page, "light")
            wrong[name] += _seen(page, TOO_WIDE, FAINT, SMALL, NARROW) + violations(page)
            page.set_viewport_size({"width": 1920, "height": 800})
            wrong[name] += _seen(page, NARROW)
            page.close()
    assert not {name: found for name, found in wrong.items() if found}
