"""Runs that the reader goes through step by step, by keyboard and by touch, on a page and after a run in it."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from tests.helpers.axe import in_both_schemes
from tests.helpers.listings_in_page import TIMER, Cell, unfold
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)

TIMING, HANGS = "docs/ros2/how-timing-works.html", "docs/how-to/why-does-it-hang.html"


def opened(page: Page, address: str) -> Locator:
    page.goto(address + TIMING)
    figure = page.locator("figure[data-scenes]").first
    figure.scroll_into_view_if_needed()
    return figure


def marked(page: Page, within: Locator) -> list[str]:
    """The lines of a listing that are marked, found by where the marks are."""
    lines: list[str] = within.locator("pre").first.evaluate(
        """pre => [...pre.querySelectorAll(".stepper-line")].map(mark => {
             const lines = pre.textContent.split("\\n"), { paddingTop, paddingBottom } = getComputedStyle(pre)
             const height = pre.scrollHeight - parseFloat(paddingTop) - parseFloat(paddingBottom)
             const down = mark.getBoundingClientRect().y + mark.offsetHeight / 2 - pre.getBoundingClientRect().y
             return lines[Math.floor((down - parseFloat(paddingTop)) / (height / (lines.length - 1)))].trim()
           })"""
    )
    return lines


def test_by_keyboard(page: Page, address: str) -> None:
    figure = opened(page, address)
    said, slider = figure.locator("[aria-live=polite]"), figure.get_by_role("slider")
    expect(said).to_have_text("No callback runs until 0.5 s.")
    beside = page.locator(".rosspin-beside", has=figure)
    assert marked(page, beside) == ["rclpy.spin(two_timers_py_node)"]
    figure.get_by_role("button", name="Forward").focus()
    page.keyboard.press("Enter")
    expect(said).to_have_text("The executor finds what is ready: slow_callback, quick_callback.")
    page.keyboard.press("Space")
    expect(said).to_have_text("MainThread calls slow_callback.")
    slider.press("ArrowRight")
    picture = figure.get_by_role("img")
    expect(picture).to_have_attribute("aria-label", re.compile("quick_callback waits for the thread"))
    expect(slider).to_have_attribute("aria-valuetext", re.compile(r"^step 4 of \d+, at 0\.5 s$"))
    assert marked(page, beside) == ["time.sleep(0.8)  # the work"]
    figure.get_by_role("button", name="Back").press("Enter")
    expect(said).to_have_text("MainThread calls slow_callback.")
    assert marked(page, beside) == ["def slow_callback(self):"]
    slider.press("End")
    expect(said).to_have_text("The node has ended, with status 0.")


def test_it_plays_until_it_is_stopped(page: Page, address: str) -> None:
    figure = opened(page, address)
    figure.get_by_role("button", name="Play").click()
    expect(figure.locator("[aria-live=polite]")).to_have_text("MainThread calls slow_callback.")
    figure.get_by_role("button", name="Pause").click()
    expect(figure.get_by_role("button", name="Play")).to_be_visible()


@pytest.mark.parametrize("motion", ["no-preference", "reduce"])
def test_by_touch(browser: Browser, address: str, motion: str) -> None:
    """On a phone nothing is wider than the screen; callbacks move to their threads if motion is wanted."""
    with reader(
        browser,
        viewport={"width": 390, "height": 844},
        has_touch=True,
        reduced_motion=motion,
    ) as context:
        page = context.new_page()
        figure = opened(page, address)
        for _ in range(2):
            figure.get_by_role("button", name="Forward").tap()
        moves = figure.evaluate("element => element.getAnimations({ subtree: true }).length")
        assert (moves > 0) == (motion == "no-preference")
        expect(figure.locator(".stepper-token", has_text="slow_callback")).to_be_visible()
        assert page.evaluate("document.documentElement.scrollWidth") == 390
        assert all(box["height"] >= 24 for each in figure.get_by_role("button").all() if (box := each.bounding_box()))


def test_a_page_with_scenes_is_accessible(page: Page, address: str) -> None:
    figure = opened(page, address)
    for _ in range(3):
        figure.get_by_role("button", name="Forward").click()
    assert in_both_schemes(page) == []


def test_a_run_in_the_page(page: Page, address: str) -> None:
    """A node that hangs: who waits for whom is drawn below it, and the reader can see how it came to that."""
    page.goto(address + HANGS)
    unfold(page)
    cell = Cell(page, 0)
    assert cell.button("Step through this").is_hidden()
    cell.run(2.5)
    cell.ends("done")
    ring = cell.element.locator("svg.stepper-ring")
    said = re.compile(r"^A ring of waits\. .* waits for the answer of /take_picture")
    expect(ring).to_have_attribute("aria-label", said)
    cell.button("Step through this").click()
    forward = cell.element.get_by_role("button", name="Forward")
    expect(forward).to_be_focused()
    for _ in range(3):
        page.keyboard.press("Enter")
    expect(cell.element.locator(".stepper-said")).to_have_text("timer_callback is at work until 2.5 s.")
    assert marked(page, cell.element) == ["answer = self.client.call(Trigger.Request())"]
    assert in_both_schemes(page) == []
    cell.button("Reset").click()
    expect(ring).to_have_count(0)
    assert cell.button("Step through this").is_hidden() and not marked(page, cell.element)


def test_the_open_editor_marks_the_line_that_runs(page: Page, address: str) -> None:
    """As long as it has the text that ran."""
    page.goto(address + HANGS)
    unfold(page)
    cell = Cell(page, 0)
    cell.run(2.5)
    cell.ends("done")
    cell.button("Step through this").click()
    forward = cell.element.get_by_role("button", name="Forward")
    for _ in range(3):
        forward.click()
    cell.button("Edit").click()
    running = cell.element.locator(".cm-line.stepper-running")
    expect(running).to_have_text(["        answer = self.client.call(Trigger.Request())"])
    cell.element.get_by_role("button", name="Back").click()
    expect(running).to_have_text(["    def timer_callback(self):"])
    assert in_both_schemes(page) == []
    cell.element.locator(".cm-content").press("Enter")
    expect(running).to_have_count(0)
    forward.click()
    expect(running).to_have_count(0)


def test_the_waits_alone(page: Page, address: str) -> None:
    """Drawn from a run of the listing below; a sentence where no script runs."""
    page.goto(address + HANGS)
    figure = page.locator("figure[data-scenes]")
    expect(figure.locator("svg.stepper-ring")).to_have_attribute("aria-label", re.compile("^A ring of waits"))
    assert figure.get_by_role("button").count() == 0
    box = figure.bounding_box()
    assert box and box["y"] + box["height"] < 900  # immediately, without scrolling or running anything


@pytest.mark.parametrize("name", ["ros2-executors", "ros2-rate"])
def test_a_notebook_has_steps(page: Page, address: str, name: str) -> None:
    page.goto(f"{address}notebooks/{name}.html")
    figure = page.locator("figure[data-scenes]")
    figure.get_by_role("button", name="Forward").click()
    assert marked(page, page.locator(".rosspin-beside", has=figure))


def test_the_threads_of_a_node_of_ros_1(tutorial: Page) -> None:
    """Each calls its own callbacks: there are no groups, and nothing is ready."""
    cell = Cell(tutorial, TIMER)
    cell.run(2)
    cell.ends("done")
    cell.button("Step through this").click()
    cell.element.get_by_role("button", name="Forward").press("Enter")
    expect(cell.element.locator(".stepper-said")).to_have_text("Thread-1 calls timerCallback.")
    expect(cell.element.locator(".stepper-picture > .stepper-box > b")).to_have_text(["Threads"])
    alternative = re.compile("MainThread, runs no callback, line .*; Thread-1, runs timerCallback, line ")
    expect(cell.element.locator(".stepper-picture")).to_have_attribute("aria-label", alternative)


@pytest.mark.parametrize("own", ["publisher", "subscriber"])
def test_nodes_that_run_together(page: Page, address: str, own: str) -> None:
    """Both are drawn; the lines come from the listing below which they ran."""
    page.goto(f"{address}docs/ros2/publish.html?lang=python")
    unfold(page)
    cell = Cell(page, ["publisher", "subscriber"].index(own))
    cell.element.get_by_role("spinbutton").fill("0.6")
    cell.element.get_by_role("button", name="Run both").click()
    cell.ends("done: 1 tick")
    cell.button("Step through this").click()
    picture = cell.element.locator(".stepper-picture")
    for name in "publisher", "subscriber":
        expect(picture).to_contain_text(f"Default group of /{name}_py_node")
    said, calls = cell.element.locator(".stepper-said"), re.compile(f"^/{own}_py_node calls ")
    for _ in range(9):
        if not calls.match(said.text_content() or ""):
            cell.element.get_by_role("button", name="Forward").click()
    expect(said).to_have_text(calls)
    assert marked(page, cell.element)[0].startswith(f"def {'timer' if own == 'publisher' else 'counter'}_callback(self")
    assert in_both_schemes(page) == []
