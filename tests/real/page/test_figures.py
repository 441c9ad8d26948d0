"""The figures with a handle: moved in Chromium by pointer and by keyboard, they show the ticks of CPython's runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Locator, Page, expect

from rosspin import Tick
from rosspin.plots import with_handle
from tests.helpers.axe import COLOURS, violations
from tests.helpers.figures import FIGURES, SHOWN, SPINNER_ROS2, Figure, Kind, opened, probes, some_kinds
from tests.helpers.figures_in_chromium import moves_by_keyboard, moves_by_pointer
from tests.helpers.looks import FAINT, TOO_WIDE, Scheme, look
from tests.helpers.readers import asks_for_no_more, reader

pytestmark = pytest.mark.shares(10)

# --- moving -----------------------------------------------------------------------------------------------------------


@some_kinds
def test_by_keyboard(context: BrowserContext, address: str, kind: Kind) -> None:
    moves_by_keyboard(context, address, kind)


def test_by_pointer(context: BrowserContext, address: str) -> None:
    moves_by_pointer(context, address, FIGURES[3])


def test_by_touch(browser: Browser, address: str) -> None:
    with reader(browser, viewport={"width": 390, "height": 844}, has_touch=True) as context:
        figure = opened(context.new_page(), address, FIGURES[0])
        first = figure.value()
        box = figure.handle.bounding_box()
        assert box and box["height"] >= 24
        figure.handle.tap(position={"x": box["width"] - 5, "y": box["height"] / 2})
        assert figure.check() > first


def test_the_number_in_the_code_follows(context: BrowserContext, address: str) -> None:
    """What is moved is the number that stands in the lines next to the figure, and nothing else in them."""
    figure = opened(context.new_page(), address, FIGURES[0])
    code = context.pages[0].locator(".rosspin-beside pre")
    before = code.inner_text()
    assert before in "\n".join(line[8:] for line in SPINNER_ROS2.read_text(encoding="utf-8").splitlines())
    figure.handle.press("End")
    assert figure.value() != 0.5
    assert code.inner_text() == before.replace("0.5", f"{figure.value():g}")


@pytest.mark.parametrize("width", [358, 764])
def test_the_page_draws_each_position_as_matplotlib_does(browser: Browser, site: Path, width: int) -> None:
    """Also with ticks at one time or overlapping, with names that are no HTML, and with fewer kinds of rows."""
    blocks = [0.0, 0.7, 1.2, 1.499, 2.2]
    run = probes("_block_call:=3", seconds=6)
    runs = {
        block: {
            **run(block),
            "a<b & c": [tick._replace(real=tick.real + 0.0123456) for tick in run(block)["rospy"]],
            "at once": [Tick("A", n, n * 0.5, n * 0.5, block) for n in range(1, 7)],
        }
        for block in blocks
    }
    with reader(browser, viewport={"width": width, "height": 800}) as context:
        page = context.new_page()
        for block in blocks:
            still = with_handle("The third call takes", "s", runs, at=block, period=0.5, kinds=2)
            page.set_content(f"<style>body{{margin:0}}</style>{still.html}")
            figure = Figure(page, FIGURES[3])
            by_matplotlib, alternative = figure.element.evaluate(SHOWN), figure.picture.get_attribute("aria-label")
            box = figure.picture.bounding_box()
            other = with_handle("The third call takes", "s", runs, at=blocks[block == 0.0], period=0.5, kinds=2)
            page.set_content(f"<style>body{{margin:0}}</style>{other.html}")
            page.add_script_tag(path=site / "_static/handles/handles.js")
            figure.handle.press("Home")
            for _ in range(blocks.index(block)):
                figure.handle.press("ArrowRight")
            assert figure.value() == block and figure.picture.get_attribute("aria-label") == alternative
            moved = figure.picture.bounding_box()
            assert box and moved and (moved["width"], moved["height"]) == (box["width"], box["height"])
            for here, there in zip(figure.element.evaluate(SHOWN), by_matplotlib, strict=True):
                assert (here.pop("drawn_by"), there.pop("drawn_by")) == ("the page", "matplotlib")
                for what in ("marks", "bars", "crosses"):
                    assert here.pop(what) == pytest.approx(there.pop(what), abs=0.1)
                assert here.pop("heights") == pytest.approx(there.pop("heights"), abs=1.5)
                assert here == there


def test_one_figure_moves_alone(context: BrowserContext, address: str) -> None:
    one, other = (each for each in FIGURES if each.page == "docs/how-timing-works.html")
    figure = opened(context.new_page(), address, one)
    beside = Figure(context.pages[0], other)
    before = beside.markup()
    figure.handle.press("End")
    assert beside.markup() == before and beside.handle.input_value() != beside.handle.get_attribute("max")


# --- what it costs ----------------------------------------------------------------------------------------------------


def test_without_javascript_the_first_position_stands(browser: Browser, address: str) -> None:
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        for kind in FIGURES:
            page.goto(address + kind.page)
            figure = page.locator("figure[data-positions]").nth(kind.number)
            expect(figure.locator("input")).to_be_hidden()
            picture = figure.locator("svg[role=img]:visible")
            expect(picture).to_have_attribute("aria-label", re.compile(f"^Timeline, {kind.label}: "))
            assert figure.evaluate(SHOWN)[0]["marks"]


def test_a_figure_needs_no_python(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url.removeprefix(address).partition("?")[0]))
    figure = opened(page, address, FIGURES[0])
    figure.handle.press("End")
    figure.check()
    asks_for_no_more(page)
    ours = [url for url in asked if re.search(r"live/|handles/|pyodide", url)]
    assert ours == ["_static/handles/handles.js", "_static/handles/vehicle.js"]


# --- how it looks -----------------------------------------------------------------------------------------------------


def test_plots_follow_the_switch_of_the_theme(browser: Browser, address: str) -> None:
    """Not only the system's: here that is light."""
    with reader(browser, viewport={"width": 1280, "height": 844}, color_scheme="light") as context:
        page = context.new_page()
        page.goto(address + "notebooks/rate.html")
        for theme in ("light", "dark"):
            page.evaluate("theme => Object.assign(document.documentElement.dataset, { theme, mode: theme })", theme)
            assert page.evaluate(FAINT) == []
            colour = page.locator("figure.rosspin-plot svg[role=img]:visible text").first.evaluate(
                "text => getComputedStyle(text).fill"
            )
            assert (max(map(int, re.findall(r"\d+", colour))) > 150) == (theme == "dark")


@pytest.mark.shares(10)
@pytest.mark.parametrize("name", sorted({kind.page for kind in FIGURES}))
def test_moved_figures(page: Page, address: str, name: str) -> None:
    """They stay in the page, also on a phone, can be read in light and in dark, and axe-core objects to nothing."""
    page.goto(address + name)
    figures = [Figure(page, kind) for kind in FIGURES if kind.page == name]
    for figure in figures:
        figure.handle.press("End")
    assert violations(page) == []
    for width in (1280, 390):
        page.set_viewport_size({"width": width, "height": 844})
        assert page.evaluate(TOO_WIDE) + page.evaluate(FAINT) == []
        for figure in figures:
            widths = figure.element.evaluate(
                "figure => [figure, ...figure.querySelectorAll('text')].map(part => part.getBoundingClientRect().right)"
            )
            assert max(widths[1:]) <= min(widths[0] + 1, width), figure.kind
    page.set_viewport_size({"width": 1280, "height": 844})
    look(page, "dark")
    assert violations(page, COLOURS) + page.evaluate(FAINT) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("width", "height"), [(390, 844), (1280, 800)])
def test_the_first_screen(browser: Browser, address: str, width: int, height: int, scheme: Scheme) -> None:
    """What one will learn, the vehicle and what moves it, and the ways in: all without scrolling."""
    with reader(browser, viewport={"width": width, "height": height}, color_scheme=scheme) as context:
        page = context.new_page()
        page.goto(address)

        def ends(place: Locator) -> float:
            expect(place).to_be_visible()
            box = place.bounding_box()
            assert box
            return box["y"] + box["height"]

        article = page.locator("article")
        seen = [article.locator(what) for what in ("p >> nth=0", "[data-vehicle] svg", "[data-vehicle] [type=range]")]
        names = "ROS 2 in Python", "ROS 2 in C++", "ROS 1 in Python", "ROS 1 in C++", "Try an exercise"
        ways = [article.get_by_role("link", name=name) for name in names]
        assert max(map(ends, [*seen, *ways])) < height
