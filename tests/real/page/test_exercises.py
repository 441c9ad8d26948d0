"""Exercises on their pages: answers are checked, hints asked for, and what was solved is kept."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from answers import CELLS, NOTEBOOKS, ON_PAGE
from exercises_in_page import is_checked, open_pages
from listings_in_page import (
    Cell,
    exercise,
)
from playwright.sync_api import Browser, Page, expect


@pytest.fixture(scope="module")
def pages_of_exercises(browser: Browser, address: str) -> Iterator[dict[int, Page]]:
    with open_pages(browser, address) as pages:
        yield pages


@pytest.fixture
def exercises(pages_of_exercises: dict[int, Page]) -> Page:
    """The page of those on ROS 1."""
    return pages_of_exercises[1]


@pytest.mark.parametrize("number", [4, 14, ON_PAGE[2][-1]])
def test_exercise_is_checked(pages_of_exercises: dict[int, Page], number: int) -> None:
    """A few; all of them are in judge/."""
    is_checked(pages_of_exercises, number)


@pytest.mark.parametrize("ros", NOTEBOOKS)
def test_what_was_solved_is_kept(pages_of_exercises: dict[int, Page], ros: int) -> None:
    """Told after each right answer, and known when the reader comes back."""
    page, numbers = pages_of_exercises[ros], ON_PAGE[ros]
    cell = exercise(page, numbers[0])
    cell.write(CELLS[numbers[0]][1].source)
    cell.button("Run").click()
    cell.ends(rf"Exercise {numbers[0]}: right\. You have solved \d+ of {len(numbers)}\.")
    page.reload()
    expect(cell.status).to_have_text("solved, as you edited it")
    made = page.locator(f".cell:has([aria-label='Run answer {numbers[0]}']) > .cell_output")
    expect(made).to_be_hidden()  # it is about the text that came with the page
    said = page.locator("article .live-progress").text_content() or ""
    assert re.fullmatch(rf"[1-9]\d* of {len(numbers)} solved", said)
    assert beside_its_link(page, ros) == said
    cell.button("Reset").click()
    expect(cell.status).to_have_text("an earlier version was solved")
    expect(made).to_be_visible()


def test_each_page_of_exercises_counts_its_own(pages_of_exercises: dict[int, Page], address: str) -> None:
    """A page that runs nodes shows both counts in its sidebar."""
    for ros, page in pages_of_exercises.items():
        cell = exercise(page, ON_PAGE[ros][0])
        cell.write(CELLS[ON_PAGE[ros][0]][1].source)
        cell.button("Run").click()
        cell.ends(f"Exercise {ON_PAGE[ros][0]}: right")
    page = pages_of_exercises[1].context.new_page()
    page.goto(address + "docs/tutorial.html")
    for ros, numbers in ON_PAGE.items():
        assert beside_its_link(page, ros).endswith(f" of {len(numbers)} solved")
    expect(page.locator(".live-progress")).to_have_count(2)
    page.close()


def beside_its_link(page: Page, ros: int) -> str:
    """What the sidebar, where ROS 2 comes first, says beside the link to a page of exercises."""
    links = page.locator(".bd-docs-nav a").filter(has_text=re.compile("^Exercises$"))
    return links.nth(2 - ros).locator("xpath=following-sibling::*[1]").text_content() or ""


def test_hints_are_asked_for_one_at_a_time(exercises: Page) -> None:
    hints = exercises.locator("section#fire-once details:has(> summary:text('Hint'))")
    shown = [hints.nth(number).locator("p").first for number in range(hints.count())]
    assert len(shown) >= 3
    for number in range(len(shown)):
        for later in shown[number:]:
            expect(later).to_be_hidden()
        hints.nth(number).locator("summary").press("Enter")
        expect(shown[number]).to_be_visible()


def test_answer_has_its_first_line(exercises: Page) -> None:
    cell = exercise(exercises, 1)
    for first in ("%%answer 2", "%%answer", "# mine", ""):
        cell.write(f"{first}\nimport rospy\n")
        cell.button("Run").click()
        assert cell.ends("error: the first line must be %%answer 1") == ""
    cell.button("Reset").click()


def test_verdict_leads_to_the_line_that_it_names(exercises: Page) -> None:
    cell = exercise(exercises, 6)
    cell.write("%%answer 6\nimport rospy\nrospy.init_node('a_node')\n1 / 0\n")
    cell.button("Run").click()
    cell.ends("Exercise 6: not yet")
    for place in ('"<answer>", line 4', "in line 4"):
        cell.console.get_by_role("button", name=place).first.click()
        expect(cell.editor).to_be_focused()
        assert exercises.evaluate("getSelection().toString()") == "1 / 0"
        cell.editor.press("Control+Home")
    cell.button("Reset").click()


def test_ticks_at_the_same_time_are_drawn_apart(exercises: Page) -> None:
    """The plot of the blocking node shows both ticks at 2.2 s."""
    cell = Cell(exercises, 1)
    cell.write((cell.element.locator("pre").first.text_content() or "").replace("0.6", "1.0"))
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.button("Run").click()
    cell.ends("done: 7 ticks")
    places = cell.plot.locator("circle").evaluate_all(
        "all => all.map(c => c.getAttribute('cx') + ' ' + c.getAttribute('cy'))"
    )
    assert len(set(places)) == 7
    assert len({place.split()[0] for place in places}) == 6
    expect(cell.element.locator("figure:not(.live-made) figcaption")).to_contain_text("simulated")
    cell.button("Reset").click()
