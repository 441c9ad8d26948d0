"""Every page of the built site in Chromium, on phones and on large screens, in light and dark."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, ViewportSize

from tests.helpers.axe import in_both_schemes
from tests.helpers.looks import FAINT, TOO_WIDE, faults, look
from tests.helpers.readers import read_to_the_end, reader
from tests.helpers.tree import SITE

# The pictures that leave more than a little of the place that they have next to them. A ring of waits is not made
# larger: its lettering is the text's.
NARROW = """() => [...document.querySelectorAll("article svg[role=img]:not(.stepper-ring)")].filter(picture => {
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

# What is cut off, or crosses an edge: words in a drawing, names in a text, captions.
CUT = """() => {
    const box = element => element.getBoundingClientRect()
    const crosses = (text, edge) => text.left < edge && edge < text.right
    const drawings = [...document.querySelectorAll("svg.rosspin-drawing")].filter(each => box(each).width)
    const words = drawings.flatMap(drawing => {
        const frames = [...drawing.querySelectorAll("rect")].map(box)
        return [...drawing.querySelectorAll("text")].filter(text => {
            const own = box(text), near = frames.filter(frame => frame.top < own.bottom && own.top < frame.bottom)
            return [box(drawing), ...near].some(frame => crosses(own, frame.left) || crosses(own, frame.right))
        })
    })
    const named = "article code:not(pre *, table *), article .code-block-caption"
    const names = [...document.querySelectorAll(named)].filter(name =>
        box(name).right > box(name.closest("article")).right + 1)
    return [...words, ...names].map(each => `cut: ${each.textContent}`)
}"""


LARGE = ViewportSize(width=1280, height=844)


def _seen(page: Page, *looks: str) -> list[Any]:
    return [found for script in looks for found in page.evaluate(script)]


NAMES = [path.relative_to(SITE).as_posix() for path in sorted(SITE.rglob("*.html")) if "_static" not in path.parts]


def test_the_site_is_built(site: Path) -> None:
    """Without it there would be no name of a page."""
    assert NAMES


@pytest.fixture(scope="module")
def tab(browser: Browser) -> Iterator[Page]:
    """One tab, in which page after page is opened."""
    with reader(browser, viewport=LARGE, color_scheme="light") as context:
        yield context.new_page()


@pytest.fixture(scope="module")
def wrong(tab: Page, address: str) -> list[str]:
    """What has gone wrong in the page that is open there."""
    return faults(tab, address)


@pytest.fixture
def opened(tab: Page, wrong: list[str], address: str, name: str) -> Iterator[Page]:
    """A page of the site on a large screen, in light. Nothing may go wrong in it, such as a request to another host."""
    wrong.clear()
    tab.set_viewport_size(LARGE)
    tab.goto(address + name)
    read_to_the_end(tab)
    look(tab, "light")
    yield tab
    assert not wrong


@pytest.mark.shares(10)
@pytest.mark.parametrize("name", NAMES)
def test_it_fits(opened: Page) -> None:
    """Nothing scrolls sideways or is cut off; plots can be read in light and in dark, and are as wide as a text."""
    seen = _seen(opened, TOO_WIDE, FAINT, SMALL, NARROW)
    opened.set_viewport_size({"width": 1920, "height": 800})
    seen += _seen(opened, NARROW)
    opened.set_viewport_size({"width": 390, "height": 844})
    look(opened, "dark")
    seen += _seen(opened, TOO_WIDE, FAINT, SMALL, CUT)
    opened.set_viewport_size({"width": 320, "height": 256})  # 1280 px by 1024 px at a zoom of 400 %
    assert seen + _seen(opened, TOO_WIDE) == []


# What is looked up, and slides, of which one is seen at a time.
LONG = re.compile(r"docs/(reference/|slides/|(ros2/)?how-timing-works)|genindex")


@pytest.mark.shares(10)
@pytest.mark.parametrize("name", [name for name in NAMES if not LONG.match(name)])
def test_it_is_at_most_six_screens_long(opened: Page) -> None:
    opened.set_viewport_size({"width": 1280, "height": 800})
    assert opened.evaluate("document.documentElement.scrollHeight") <= 6 * 800


@pytest.mark.shares(10)
@pytest.mark.parametrize("name", NAMES)
def test_axe_objects_to_nothing(opened: Page) -> None:
    assert in_both_schemes(opened) == []
