"""The built site in Chromium: nothing from another host, no console error, no sideways scrolling, light and dark."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pytest
from conftest import faults
from playwright.sync_api import Browser, Page


def _open(page: Page, address: str, name: str) -> list[str]:
    """Open a page and scroll to its end; what goes wrong in it is added to the list, now and later."""
    wrong = faults(page, address)
    page.goto(address + name)
    page.evaluate("window.scrollTo(0, document.body.scrollHeight)")
    return wrong


# What makes the page wider than its window, unless it stands in a box that scrolls by itself.
TOO_WIDE = """() => document.documentElement.scrollWidth <= window.innerWidth ? [] : [...document.querySelectorAll("*")]
    .filter(element => element.getBoundingClientRect().right > window.innerWidth)
    .map(element => `too wide: ${element.tagName}.${element.getAttribute("class")}`).slice(0, 5)"""

# Plots draw with the colour of the text around them: its contrast with the ground behind, by WCAG's formula.
FAINT = """() => {
    const parts = colour => colour.match(/[\\d.]+/g).map(Number)
    const luminance = colour => parts(colour).slice(0, 3).map(part => part / 255)
        .map(part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
        .reduce((sum, part, index) => sum + part * [0.2126, 0.7152, 0.0722][index], 0)
    const ground = element => {
        const colour = getComputedStyle(element).backgroundColor
        return parts(colour)[3] === 0 && element.parentElement ? ground(element.parentElement) : colour
    }
    return [...document.querySelectorAll("svg[role=img]:not([aria-hidden=true])")].filter(plot => {
        const [dark, light] = [getComputedStyle(plot).color, ground(plot)].map(luminance).sort((a, b) => a - b)
        return (light + 0.05) / (dark + 0.05) < 4.5
    }).map(plot => `faint: ${plot.getAttribute("aria-label")}`)
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_pages(site: Path, address: str, browser: Browser, width: int, scheme: Literal["light", "dark"]) -> None:
    names = [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    with browser.new_context(viewport={"width": width, "height": 844}, color_scheme=scheme) as context:
        pages = {name: context.new_page() for name in names}
        wrong = {name: _open(page, address, name) for name, page in pages.items()}
        for name, page in pages.items():
            page.wait_for_load_state("networkidle")
            wrong[name] += page.evaluate(TOO_WIDE) + page.evaluate(FAINT)
            if page.evaluate("document.documentElement.dataset.theme") != scheme:
                wrong[name].append(f"the page is not {scheme}")
    assert not {name: found for name, found in wrong.items() if found}
