"""Links that carry a listing, and runs that are copied as tests."""

from __future__ import annotations

import time
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import BrowserContext, Page, Route, expect

from rosspin import simulate
from rosspin.results.pinned import as_test
from tests.helpers.listings_in_page import (
    IN_PYTHON,
    LISTINGS,
    OTHER,
    ROS2,
    TIMER,
    TUTORIAL,
    Cell,
    link,
    node,
)
from tests.helpers.looks import faults
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


def _copied(page: Page) -> str:
    text: str = page.evaluate("navigator.clipboard.readText()")
    return text


def _late(route: Route) -> None:
    """For a script after the listings' own, until whose end the tabs stay closed."""
    time.sleep(1)
    route.continue_()


def test_a_link_carries_the_code(tutorial: Page, address: str) -> None:
    """It opens with a notice, does not run, and leaves alone what the reader has written."""
    tutorial.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell = Cell(tutorial, TIMER)
    code = node("print(rospy.get_param('~word'), '<b>ä</b>')")
    cell.write(code)
    cell.element.get_by_role("textbox", name="Arguments").fill("_word:=shared")
    cell.element.get_by_role("spinbutton").fill("3")
    cell.button("Copy link").click()
    expect(cell.status).to_have_text("the link is copied; the code is in it")
    copied = _copied(tutorial)
    mine = node("print('mine')")
    cell.write(mine)

    other = tutorial.context.new_page()
    wrong = faults(other, address)
    other.route("**/handles.js*", _late)
    other.goto(copied)
    opened = Cell(other, TIMER)
    expect(opened.element.locator(".live-notice")).to_contain_text("This code came with the link")
    expect(opened.element.locator(".live-notice")).to_be_in_viewport()
    assert opened.element.locator("pre").first.text_content() == code
    expect(opened.element.locator("pre .k").first).to_have_text("import")  # in colours, with no editor open
    expect(opened.status).to_have_text("as it came with the link")
    other.wait_for_timeout(500)
    assert opened.text() == ""
    expect(opened.element.get_by_role("spinbutton")).to_have_value("3")
    opened.element.get_by_role("combobox").select_option("instantly")
    opened.button("Run").click()
    assert opened.ends("done") == "shared <b>ä</b>\n"
    opened.write("print('theirs')")
    opened.button("Reset").click()
    expect(opened.element.locator(".live-notice")).to_be_hidden()
    assert "#" not in other.url
    other.reload()
    assert opened.element.locator("pre").first.text_content() == mine
    assert not wrong
    other.close()


@pytest.mark.parametrize(
    ("tabs", "query"), [(["ROS 2"], {"ros": ["2"]}), (["ROS 1", "Python"], {"ros": ["1"], "lang": ["python"]})]
)
def test_a_link_chooses_the_tabs_of_its_listing(
    context: BrowserContext, address: str, tabs: list[str], query: dict[str, list[str]]
) -> None:
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    for tab in tabs:
        page.locator(".sd-tab-label", has_text=tab).locator("visible=true").first.click()
    cell = Cell(page, len(tabs) - 1)
    cell.button("Copy link").click()
    expect(cell.status).to_have_text("the link is copied; the code is in it")
    assert parse_qs(urlsplit(_copied(page)).query) == query


@pytest.mark.parametrize(
    ("fragment", "said"),
    [
        (link()[:-6], "cannot be read"),
        (link(cell=99), "no longer has"),
        (link(cell=-1), "no longer has"),
        (link(text="x" * 1_000_000), "too long"),
    ],
    ids=lambda value: value[:20],
)
def test_a_broken_link_does_nothing_but_say_so(tutorial: Page, address: str, fragment: str, said: str) -> None:
    """Whatever else can be wrong with one is in web/test/link.test.mjs."""
    other = tutorial.context.new_page()
    wrong = faults(other, address)
    other.goto(address + TUTORIAL + fragment)
    expect(other.get_by_role("alert").filter(has_text="link")).to_contain_text(said)
    for index, name in enumerate(LISTINGS):
        shown = other.locator(f"{IN_PYTHON} > .highlight > pre").nth(index).text_content()
        assert shown == (EXAMPLES / name).read_text(encoding="utf-8")
    assert not wrong
    other.close()


def test_html_in_a_link_is_text(tutorial: Page, address: str) -> None:
    html = "<script>document.title = 'taken'</script><img src=x onerror=\"document.title = 'taken'\">"
    other = tutorial.context.new_page()
    wrong = faults(other, address)
    other.goto(address + TUTORIAL + link(text=html, args=html))
    cell = Cell(other, TIMER)
    expect(cell.element.locator("pre").first).to_have_text(html)
    assert other.title() != "taken" and cell.element.locator("img, script").count() == 0
    assert not wrong
    other.close()


@pytest.mark.parametrize("listing", [EXAMPLES / LISTINGS[OTHER], ROS2[0]], ids=lambda path: path.parts[-3])
def test_run_is_copied_as_a_test(tutorial: Page, listing: Path) -> None:
    """It is the one that CPython makes of the same run. That it passes, and fails, is in results/test_pinned.py."""
    tutorial.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell = Cell(tutorial, TIMER)
    source = listing.read_text(encoding="utf-8")
    cell.write(source)
    expect(cell.button("Copy as test")).to_be_hidden()
    cell.run(2)
    cell.ends("done")
    cell.button("Copy as test").click()
    expect(cell.status).to_have_text("the test is copied: save it in a file for pytest")
    run = simulate(listing, 2)
    assert _copied(tutorial) == as_test(source, "spinner_py_node.py", 2, (), run.console, run.ticks)


def test_run_with_an_error_is_no_test(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    for body in ("1 / 0", "rospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)\nrospy.spin()", "print('x' * 60_000)"):
        cell.write(node(body))
        cell.run(1)
        cell.ends("done|error")
        expect(cell.button("Copy as test")).to_be_hidden()
