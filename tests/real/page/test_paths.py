"""A path that a reader chooses, and the pages that it leads along."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.helpers.axe import in_both_schemes
from tests.helpers.readers import reader


def test_the_path_that_was_chosen_is_told_and_leads_on(page: Page, address: str) -> None:
    """Through all of its pages, by either link; a page that is not on it says where on its course it is."""
    page.goto(f"{address}docs/paths.html")
    page.locator("table[id='evening'] tbody a").first.click()
    shown, onward = page.locator(".rosspin-path:visible"), page.locator("a.right-next")
    exercises = ["5 of 8, part 1 of 2", "5 of 8, part 2 of 2"]
    vehicle = [f"8 of 8, part {part} of 4" for part in (1, 2, 3)]
    places = [*(f"{number} of 8" for number in range(1, 5)), *exercises, "6 of 8", "7 of 8", *vehicle]
    for step, place in enumerate(places):
        expect(shown).to_have_text(re.compile(f"^The path of an evening, {place}. Next: "))
        below = shown.locator("a").last
        assert onward.evaluate("link => link.href") == below.evaluate("link => link.href")
        expect(onward).to_contain_text(below.text_content() or "-")
        (below if step % 2 else onward).click()
    expect(page.locator("h1")).to_have_text(re.compile("^43[.] Look while driving"))
    expect(shown).to_have_text("The path of an evening, 8 of 8, part 4 of 4. You have reached its end.")
    expect(onward).to_be_hidden()
    page.goto(f"{address}notebooks/ros2-timer.html")  # by another way
    expect(shown).to_have_text(re.compile("^The path of an evening, 3 of 8"))
    page.goto(f"{address}notebooks/ros2-rate.html")
    expect(shown).to_have_text(re.compile("^The course on ROS 2, "))
    assert in_both_schemes(page) == []


@pytest.mark.parametrize("width", [1280, 390])
def test_it_takes_little_room(browser: Browser, address: str, width: int) -> None:
    with reader(browser, viewport={"width": width, "height": 844}) as context:
        page = context.new_page()
        page.goto(f"{address}docs/ros2/tutorial.html?path=evening")
        box = page.locator(".rosspin-path:visible").bounding_box()
        assert box and box["height"] < 50
        assert page.evaluate("document.documentElement.scrollWidth") == width
