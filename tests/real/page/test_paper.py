"""Pages as they are printed."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, BrowserContext, Locator, Page, expect

from tests.helpers.figures import FIGURES, opened
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)


@pytest.fixture(params=["light", "dark"])
def paper(browser: Browser, address: str, request: pytest.FixtureRequest) -> Iterator[Page]:
    """A page as it is printed, by a reader with light or dark pages."""
    with reader(browser, color_scheme=request.param) as context:
        page = context.new_page()
        page.emulate_media(media="print", color_scheme=request.param)
        yield page


def _all_visible(found: Locator) -> bool:
    return found.count() > 0 and all(found.nth(index).is_visible() for index in range(found.count()))


def test_both_languages_are_printed(paper: Page, address: str) -> None:
    paper.goto(f"{address}/docs/tutorial.html")
    assert _all_visible(paper.locator(".sd-tab-content"))
    assert _all_visible(paper.locator(".sd-tab-label"))
    # Each label stands above what it names.
    for label in paper.locator(".sd-tab-label").all():
        above, below = label.bounding_box(), label.locator("xpath=following-sibling::*[1]").bounding_box()
        assert above and below and above["y"] < below["y"]


@pytest.mark.parametrize(
    "name", ["docs/slides/ros2", "docs/tutorial", "docs/how-to/judge-hand-ins", "docs/for-teachers"]
)
def test_a_page_is_printed_to_its_end(page: Page, address: str, name: str) -> None:
    """Each of its links is on the paper, even of its last section."""
    page.goto(f"{address}{name}.html")
    seen = "[...document.querySelectorAll('article a[href]:not(.headerlink)')].filter((a) => a.checkVisibility())"
    links = set(
        page.evaluate(f"{seen}.map((a) => a.href).filter((to) => !to.includes('#') && !to.startsWith('blob:'))")
    )
    for margin in ("0", "1cm"):
        pdf = page.pdf(format="A4", margin={"top": margin, "right": margin, "bottom": margin, "left": margin})
        printed = {to.decode() for to in re.findall(rb"/URI \(([^)]*)\)", pdf)}
        assert links and not links - printed


def test_what_is_folded_is_printed(paper: Page, address: str) -> None:
    paper.goto(f"{address}/notebooks/timer.html")
    expect(paper.get_by_text("20, at 0.1 s, 0.2 s and so on")).to_be_visible()
    paper.goto(f"{address}/exercises/fire-once.html")
    assert _all_visible(paper.locator("details > :not(summary)"))
    paper.goto(f"{address}/docs/ros2/how-timing-works.html")
    assert _all_visible(paper.locator("details > :not(summary)"))


def test_print_is_dark_on_white_and_without_what_can_be_pressed(paper: Page, address: str) -> None:
    paper.goto(f"{address}/docs/tutorial.html")
    assert not any(button.is_visible() for button in paper.get_by_role("button").all())
    assert not paper.locator(".bd-sidebar-primary").is_visible()
    seen = "document.querySelectorAll('.bd-article :is(p, a, pre, pre span, .sd-tab-label)')"
    find = f"[...{seen}].filter((e) => e.checkVisibility()).map((e) => getComputedStyle(e))"
    inks = paper.evaluate(f"{find}.map((style) => style.color)")
    assert not {ink for ink in inks if sum(map(int, re.findall(r"\d+", ink)[:3])) > 400}
    grounds = paper.evaluate(f"{find}.map((style) => style.backgroundColor)")
    dark = {ground for ground in grounds if sum(map(int, re.findall(r"\d+", ground)[:3])) < 600}
    assert dark <= {"rgba(0, 0, 0, 0)"}
    assert paper.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"


def test_on_paper_the_first_position_stands(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    figure = opened(page, address, FIGURES[0])
    before, code = figure.markup(), page.locator(".rosspin-beside pre").inner_text()
    figure.handle.press("End")
    moved = figure.markup()
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    expect(figure.handle).to_be_hidden()
    assert figure.markup() == before
    assert page.locator(".rosspin-beside pre").inner_text() == code
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert figure.markup() == moved


def test_plots_are_on_paper(browser: Browser, address: str) -> None:
    with reader(browser, viewport={"width": 1280, "height": 844}, color_scheme="dark") as context:
        page = context.new_page()
        page.goto(address + "notebooks/rate.html")
        page.emulate_media(media="print")
        plots = page.locator(".cell_output figure.rosspin-plot")
        assert plots.count() > 1
        for index in range(plots.count()):
            text = plots.nth(index).locator("svg[role=img]:visible text").first
            assert text.evaluate("text => getComputedStyle(text).fill") == "rgb(0, 0, 0)"
