"""What the tests of pages look for in each of them: faults, what is too wide, what is too faint."""

from __future__ import annotations

from typing import Literal

from playwright.sync_api import Page, expect

Scheme = Literal["light", "dark"]
SCHEMES: tuple[Scheme, ...] = ("light", "dark")


def look(page: Page, scheme: Scheme) -> None:
    """Have the reader's system ask for light or dark pages from now on. Colours have changed when this returns."""
    page.emulate_media(color_scheme=scheme)
    expect(page.locator("html")).to_have_attribute("data-theme", scheme)
    page.evaluate("for (const moving of document.getAnimations()) if (moving instanceof CSSTransition) moving.finish()")


def faults(page: Page, address: str) -> list[str]:
    """A list to which all is added that goes wrong in a page from now on, what it asks of another host included."""
    wrong: list[str] = []

    def note(bad: bool, what: str) -> None:
        if bad:
            wrong.append(what)

    page.on("request", lambda request: note(not request.url.startswith((address, "data:", "blob:")), request.url))
    page.on("response", lambda response: note(response.status >= 400, f"{response.status} {response.url}"))
    page.on("console", lambda message: note(message.type == "error", message.text))
    page.on("pageerror", lambda error: note(True, str(error)))
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
