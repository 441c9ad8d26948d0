"""Every page of the built site in Chromium, on phones and on large screens, in light and dark."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from axe import COLOURS, violations
from looks import FAINT, TOO_WIDE, faults, look
from playwright.sync_api import Browser, Page, ViewportSize

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


LARGE = ViewportSize(width=1280, height=844)


def _open(page: Page, address: str) -> None:
    """Open a page and scroll to its end, so that all of it is loaded."""
    page.goto(address)
    page.evaluate("window.scrollTo(0, document.body.scrollHeight)")


def _seen(page: Page, *looks: str) -> list[Any]:
    return [found for script in looks for found in page.evaluate(script)]


def test_every_page(site: Path, address: str, browser: Browser) -> None:
    """Nothing from another host, no error, no sideways scrolling, plots that can be read, in light and in dark.

    axe-core objects to nothing, on large screens figures are as wide as the text. Opened once each, in two tabs: one
    page settles as the other is looked at.
    """
    names = [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    found = {}
    with browser.new_context(viewport=LARGE, color_scheme="light") as context:
        pages = [context.new_page() for _ in range(2)]
        wrong = [faults(page, address) for page in pages]
        _open(pages[0], address + names[0])
        for number, name in enumerate(names):
            page, faulty = pages[number % 2], wrong[number % 2]
            if number + 1 < len(names):
                _open(pages[(number + 1) % 2], address + names[number + 1])
            page.wait_for_load_state("networkidle")
            look(page, "light")
            seen = _seen(page, TOO_WIDE, FAINT, SMALL, NARROW) + violations(page)
            page.set_viewport_size({"width": 1920, "height": 800})
            seen += _seen(page, NARROW)
            page.set_viewport_size({"width": 390, "height": 844})
            look(page, "dark")
            seen += _seen(page, TOO_WIDE, FAINT, SMALL)
            page.set_viewport_size({"width": 320, "height": 256})  # 1280 px by 1024 px at a zoom of 400 %
            seen += _seen(page, TOO_WIDE)
            page.set_viewport_size(LARGE)
            found[name] = seen + violations(page, COLOURS) + faulty
            faulty.clear()
    assert not {name: what for name, what in found.items() if what}
