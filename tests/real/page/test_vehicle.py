"""The vehicle of the first page in Chromium: moved by keyboard and touch, played, and still for who wants it still."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import Browser, BrowserContext, Locator, Page, expect

from tests.helpers.axe import in_both_schemes
from tests.helpers.looks import FAINT, SCHEMES, TOO_WIDE, look
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)

STILL = {"reduced_motion": "reduce"}


def opened(page: Page, address: str) -> Locator:
    page.goto(f"{address}index.html")
    figure = page.locator("figure[data-vehicle]")
    expect(figure.get_by_role("slider")).to_be_visible()
    return figure


def shows(figure: Locator, node: int, position: int) -> None:
    """The figure shows what the page carries for a node and a position, in the picture and in words."""
    _, lengths, positions = json.loads(str(figure.get_attribute("data-vehicle")))
    words, alternative, path, dashes, _ = positions[node][position]
    expect(figure.get_by_role("status")).to_have_text(words)
    expect(figure.get_by_role("img")).to_have_attribute("aria-label", alternative)
    expect(figure.locator(".overdue")).to_have_attribute("stroke-dasharray", dashes)
    for way in figure.locator(".way").all():
        expect(way).to_have_attribute("d", path)
    expect(figure.get_by_role("slider")).to_have_attribute("aria-valuetext", f"{lengths[position]:.1f} s")


def place(figure: Locator) -> str:
    return str(figure.locator(".vehicle").get_attribute("transform"))


def test_by_keyboard(context: BrowserContext, address: str) -> None:
    figure = opened(context.new_page(), address)
    slider = figure.get_by_role("slider")
    shows(figure, 0, 18)
    slider.press("Home")
    shows(figure, 0, 0)
    slider.press("End")
    slider.press("ArrowLeft")
    shows(figure, 0, 19)
    figure.get_by_role("radio").first.focus()
    for node in (1, 2, 3, 4):
        context.pages[0].keyboard.press("ArrowDown")
        shows(figure, node, 19)


def test_by_touch_on_a_phone(browser: Browser, address: str) -> None:
    size = {"width": 390, "height": 844}
    with reader(browser, viewport=size, has_touch=True, **STILL) as context:
        page = context.new_page()
        figure = opened(page, address)
        slider = figure.get_by_role("slider")
        box = slider.bounding_box()
        assert box and box["height"] >= 24
        slider.tap(position={"x": 3, "y": box["height"] / 2})
        shows(figure, 0, 0)
        figure.get_by_label("ROS 1 in C++").tap()
        shows(figure, 4, 0)
        assert page.evaluate(TOO_WIDE) == []
        picture = figure.get_by_role("img").bounding_box()
        assert picture and picture["y"] + picture["height"] < size["height"], "not on the first screen"


def test_it_plays_once_and_can_be_paused(context: BrowserContext, address: str) -> None:
    """Without a clock: it moves while it plays, and stands still when it is paused."""
    page = context.new_page()
    page.clock.install()
    figure = opened(page, address)
    pause = figure.get_by_role("button")
    expect(pause).to_have_text("Pause")
    page.clock.run_for(1000)
    before = place(figure)
    page.clock.run_for(500)
    assert place(figure) != before
    pause.click()
    expect(pause).to_have_text("Play")
    before = place(figure)
    page.clock.run_for(500)
    assert place(figure) == before
    pause.click()
    page.clock.run_for(10_000)
    expect(pause).to_have_text("Play")


def test_it_stands_still_where_motion_is_reduced(browser: Browser, address: str) -> None:
    """At the moment at which it is off its line most, as it was drawn with the page. Who presses Play sees it move."""
    with reader(browser, **STILL) as context:
        page = context.new_page()
        page.clock.install()
        figure = opened(page, address)
        expect(figure.get_by_role("button")).to_have_text("Play")
        drawn = place(figure)
        page.clock.run_for(2000)
        assert place(figure) == drawn
        slider = figure.get_by_role("slider")
        slider.press("ArrowLeft")
        slider.press("ArrowRight")
        moved = [float(number) for number in re.findall(r"-?[\d.]+", place(figure))]
        assert all(abs(a - float(b)) < 0.1 for a, b in zip(moved, re.findall(r"-?[\d.]+", drawn), strict=True))
        figure.get_by_role("button").click()
        page.clock.run_for(100)
        assert place(figure) != drawn


def test_it_is_drawn_without_javascript(browser: Browser, address: str) -> None:
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(f"{address}index.html")
        figure = page.locator("figure[data-vehicle]")
        expect(figure.get_by_role("img")).to_be_visible()
        for control in figure.locator("input, button").all():
            expect(control).to_be_hidden()


def test_how_it_looks(browser: Browser, address: str) -> None:
    with reader(browser, viewport={"width": 1280, "height": 900}, **STILL) as context:
        page = context.new_page()
        opened(page, address)
        assert in_both_schemes(page) == []
        for scheme in SCHEMES:
            look(page, scheme)
            assert page.evaluate(FAINT) == []
