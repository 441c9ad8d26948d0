"""Listings that can be run, before they are, where they cannot be, and how they look."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, Response, expect

from tests.helpers.listings_in_page import (
    IN_PYTHON,
    LISTINGS,
    TIMER,
    TUTORIAL,
    Cell,
    node,
    open_tutorial,
    unfold,
)
from tests.helpers.looks import FAINT, SCHEMES, TOO_WIDE, look
from tests.helpers.readers import asks_for_no_more, reader, until
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


def test_listing_costs_two_small_requests_until_it_is_touched(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    found: list[Response] = []
    page.on("response", lambda response: found.append(response))
    page.goto(address + TUTORIAL)
    asks_for_no_more(page)
    ours = {response.url: len(response.body()) for response in found if "/live/" in response.url}
    assert 1 <= len(ours) <= 2
    assert sum(ours.values()) < 20_000


@pytest.mark.parametrize(("language", "shown"), [("python", True), ("cpp", False)])
def test_the_language_is_asked_and_remembered(
    context: BrowserContext, address: str, language: str, shown: bool
) -> None:
    """A link on the first page chooses it, for each later page too; where the text says Run, there is one."""
    page = context.new_page()
    page.goto(address)
    page.locator(f"article a[href$='ros=1&lang={language}']").click()
    page.wait_for_url(re.compile(rf"tutorial\.html\?.*lang={language}$"))
    expect(Cell(page, 0).button("Run")).to_be_visible(visible=shown)
    page.goto(address + "docs/ros2/tutorial.html")
    expect(Cell(page, 0).button("Run")).to_be_visible(visible=shown)
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    expect(Cell(page, 1).button("Run")).to_be_visible(visible=shown)


@pytest.mark.parametrize(("edition", "number"), [("ROS 2 in Python", 0), ("ROS 1 in Python", 1)])
def test_the_edition_is_asked_and_remembered(context: BrowserContext, address: str, edition: str, number: int) -> None:
    """A link on the first page chooses the ROS, for the tabs of each later page."""
    page = context.new_page()
    page.goto(address + "index.html")
    page.get_by_role("link", name=edition, exact=True).click()
    page.wait_for_url(re.compile(r"tutorial\.html\?ros="))
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    for listing in (0, 1):
        expect(Cell(page, listing).button("Run")).to_be_visible(visible=listing == number)


def test_choosing_a_language_at_the_top_shows_listings_with_run(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(address + TUTORIAL)
    expect(Cell(page, 0).button("Run")).to_be_hidden()
    page.locator(".sd-tab-set").first.locator(".sd-tab-label", has_text="Python").click()
    unfold(page)
    for index in range(len(LISTINGS)):
        expect(Cell(page, index).button("Run")).to_be_visible()


def test_listing_is_the_file(tutorial: Page) -> None:
    shown = tutorial.locator(f"{IN_PYTHON} > .highlight > pre").all_text_contents()
    assert shown == [(EXAMPLES / name).read_text(encoding="utf-8") for name in LISTINGS]


def _is_plain(page: Page, line: str) -> None:
    listing = page.locator(IN_PYTHON).nth(1)
    expect(listing.locator("pre")).to_contain_text("class SpinnerPyNode")
    expect(page.get_by_text(line).locator("visible=true").first).to_be_visible()
    expect(listing.get_by_role("button", name="Run")).to_have_count(0)


# --- where Python cannot run ------------------------------------------------------------------------------------------


def test_opened_as_a_file(context: BrowserContext, site: Path) -> None:
    page = context.new_page()
    page.goto((site / TUTORIAL).as_uri())
    unfold(page)
    _is_plain(page, "see START-HERE.html, or make serve")


def test_without_jspi(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.add_init_script("delete WebAssembly.Suspending")
    page.goto(address + TUTORIAL)
    unfold(page)
    _is_plain(page, "This browser cannot run this listing: it lacks JSPI")


def test_without_javascript(browser: Browser, address: str) -> None:
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + TUTORIAL)
        unfold(page)
        _is_plain(page, "To run this listing here, the page needs JavaScript.")


# --- what the page may do ---------------------------------------------------------------------------------------------


FORBIDDEN = [
    "fetch('https://example.org/')",
    "import('https://example.org/a.js')",
    "Promise.resolve(new Worker('data:text/javascript,'))",
    "new Promise(resolve => setTimeout(() => { resolve(); Function('') }))",
]


def test_policy_forbids(context: BrowserContext, address: str) -> None:
    """Each of these, and an inline script that the page did not come with."""
    page = context.new_page()
    page.goto(address + TUTORIAL)
    page.evaluate("window.blocked = []; addEventListener('securitypolicyviolation', e => blocked.push(e.blockedURI))")
    for number, attempt in enumerate(FORBIDDEN, 1):
        page.evaluate(f"async () => {{ try {{ await {attempt} }} catch {{}} }}")
        until(page, lambda: page.evaluate("blocked.length") >= number)
        page.wait_for_timeout(100)
        assert page.evaluate("blocked.length") == number, attempt
    page.evaluate("document.body.append(Object.assign(document.createElement('script'), {text: 'window.mine = 1'}))")
    assert page.evaluate("window.mine") is None


# --- how it looks -----------------------------------------------------------------------------------------------------


def test_looks(page: Page, address: str) -> None:
    """An open cell with its editor, console and plot fits a phone, and its text stands out in light and in dark."""
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write(node("rospy.logerr('late')\nrospy.Timer(rospy.Duration(0.1), lambda event: None)\nrospy.spin()"))
    cell.run(2)
    cell.ends("done")
    expect(cell.plot).to_be_visible()
    for width in (1280, 390):
        page.set_viewport_size({"width": width, "height": 900})
        for scheme in SCHEMES:
            look(page, scheme)
            assert page.evaluate(TOO_WIDE) + page.evaluate(FAINT) == [], (width, scheme)
