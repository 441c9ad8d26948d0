"""Readers who use the keyboard alone, want less motion, or have their own colours."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.helpers.answers import CELLS, ON_PAGE, number_of
from tests.helpers.axe import COLOURS, violations
from tests.helpers.listings_in_page import TIMER, Cell, open_exercise, open_tutorial
from tests.helpers.looks import FAINT, faults
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)

# The pages on which most moves or is drawn, and slides.
PAGES = ["index.html", "docs/tutorial.html", "docs/ros2/how-timing-works.html", "docs/slides/ros2.html?slides"]

# What is on the move in a page, and whether that is a fading of colours, which comes to an end.
MOVING = "document.getAnimations().filter(each => each.playState === 'running')"
FADES = "each => each instanceof CSSTransition"

# Whether what has the focus can be told from what has not, other than by the caret in a text.
SEEN = """() => {
    const style = getComputedStyle(document.activeElement)
    const edged = (name) => style[name + "Style"] !== "none" && parseFloat(style[name + "Width"]) > 0
    return edged("outline") || style.boxShadow !== "none"
}"""


def tab_to(page: Page, name: str) -> None:
    """Press Tab until the focus is on a button of this name, and can be seen."""
    for _ in range(20):
        if (page.evaluate("document.activeElement.ariaLabel") or "").startswith(name):
            assert page.evaluate(SEEN), name
            return
        page.keyboard.press("Tab")
    pytest.fail(f"Tab does not lead to {name}")


def test_a_quick_check_by_keyboard_without_a_script(browser: Browser, address: str) -> None:
    """Of its answers one is open at a time, and says whether it is right."""
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + "notebooks/ros2-executors.html")
        answers = page.locator("details[name=swapped]")
        for number, said in ((0, "No."), (1, "Yes.")):
            answers.nth(number).locator("summary").press("Enter")
            expect(page.locator("details[name=swapped][open]")).to_have_count(1)
            expect(answers.nth(number).get_by_text(said)).to_be_visible()


def test_an_exercise_by_keyboard(page: Page, address: str) -> None:
    """From its heading to the editor, a wrong answer, the hint, a right answer, and on to what follows."""
    name = ON_PAGE[2][0]
    cell = open_exercise(page, address, name, f"#{name}")
    expect(cell.button("Run")).to_be_visible()
    page.evaluate(f"document.getElementById('{name}').focus()")
    tab_to(page, "Run answer")
    page.keyboard.press("Enter")
    cell.ends(f"Exercise {number_of(name)}: ")
    tab_to(page, "Edit answer")
    page.keyboard.press("Enter")
    expect(cell.editor).to_be_focused()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(CELLS[name][1].source)
    page.keyboard.press("Control+Enter")
    cell.ends(rf"Exercise {number_of(name)}: right\.")
    page.keyboard.press("Escape")
    expect(cell.editor).not_to_be_focused()
    for _ in range(20):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.tagName") == "SUMMARY":
            break
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.parentElement.open && document.activeElement.checkVisibility()")


def test_a_listing_by_keyboard(page: Page, address: str) -> None:
    """Run, then each tick by arrow keys, then on."""
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.element.get_by_role("spinbutton").fill("2")
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.button("Run").focus()
    page.keyboard.press("Enter")
    cell.ends("done: 4 ticks")
    for _ in range(20):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.role") == "slider":
            break
    assert page.evaluate(SEEN)
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    assert "counter = 2" in "".join(cell.marked())
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.role") != "slider"


@pytest.mark.parametrize("name", PAGES)
def test_nothing_moves_where_motion_is_reduced(browser: Browser, address: str, name: str) -> None:
    """By itself: two pictures, a while after each other, are the same; and no page scrolls smoothly."""
    with reader(browser, reduced_motion="reduce", viewport={"width": 1280, "height": 900}) as context:
        page = context.new_page()
        wrong = faults(page, address)
        page.goto(address + name)
        # The theme fades its colours in, once.
        page.evaluate(
            f"async () => {{ await Promise.allSettled({MOVING}.filter({FADES}).map(each => each.finished)) }}"
        )
        assert page.evaluate(f"{MOVING}.length") == 0
        assert page.evaluate("getComputedStyle(document.documentElement).scrollBehavior") == "auto"
        first = page.screenshot()
        page.wait_for_timeout(1500)
        assert page.screenshot() == first
        assert not wrong


@pytest.mark.parametrize("name", PAGES)
def test_in_forced_colours(browser: Browser, address: str, name: str) -> None:
    """Buttons have an edge, plots and words a contrast."""
    with reader(browser, forced_colors="active") as context:
        page = context.new_page()
        page.goto(address + name)
        assert page.evaluate("matchMedia('(forced-colors: active)').matches")
        assert page.evaluate(FAINT) + violations(page, COLOURS) == []
        edges = page.evaluate("""[...document.querySelectorAll("article :is(.live-bar, figure) button")]
            .filter(button => button.checkVisibility())
            .map(button => parseFloat(getComputedStyle(button).borderTopWidth))""")
        assert all(edge > 0 for edge in edges)
