"""Exercises on their pages: answers are checked, hints asked for, and what was solved is kept."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from answers import CELLS, NOTEBOOKS, ON_PAGE, answer_in, number_of
from exercises_in_page import is_checked, open_pages
from listings_in_page import (
    Cell,
    exercise,
)
from playwright.sync_api import Browser, Page, expect

pytestmark = pytest.mark.shares(2)


@pytest.fixture(scope="module")
def pages_of_exercises(browser: Browser, address: str) -> Iterator[dict[int, Page]]:
    with open_pages(browser, address) as pages:
        yield pages


@pytest.fixture
def exercises(pages_of_exercises: dict[int, Page]) -> Page:
    """The page of those on ROS 1."""
    return pages_of_exercises[1]


@pytest.mark.parametrize("name", ["ten-hertz", "name-the-fault", ON_PAGE[2][-1]])
def test_exercise_is_checked(pages_of_exercises: dict[int, Page], name: str) -> None:
    """A few; all of them are in judge/."""
    is_checked(pages_of_exercises, name)


@pytest.mark.parametrize("ros", NOTEBOOKS)
def test_what_was_solved_is_kept(pages_of_exercises: dict[int, Page], ros: int) -> None:
    """Told after each right answer, and known when the reader comes back."""
    page, names = pages_of_exercises[ros], ON_PAGE[ros]
    cell = exercise(page, names[0])
    cell.write(CELLS[names[0]][1].source)
    cell.button("Run").click()
    cell.ends(rf"Exercise {number_of(names[0])}: right\. You have solved \d+ of {len(names)}\.")
    page.reload()
    expect(cell.status).to_have_text("solved, as you edited it")
    made = page.locator(f".cell:has([aria-label='Run answer {names[0]}']) > .cell_output")
    expect(made).to_be_hidden()  # it is about the text that came with the page
    said = page.locator("article .live-progress").text_content() or ""
    assert re.fullmatch(rf"[1-9]\d* of {len(names)} solved", said)
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
        cell.ends(f"Exercise {number_of(ON_PAGE[ros][0])}: right")
    page = pages_of_exercises[1].context.new_page()
    page.goto(address + "docs/tutorial.html")
    for ros, names in ON_PAGE.items():
        assert beside_its_link(page, ros).endswith(f" of {len(names)} solved")
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


def test_a_whole_node_that_is_pasted_is_an_answer(exercises: Page) -> None:
    """The cell knows which exercise it answers; its first line need not be there, and its lines keep their numbers."""
    cell = exercise(exercises, "ten-hertz")
    right = answer_in(CELLS["ten-hertz"][1])
    for text in (right, f"%%answer\n{right}", f"%%answer 4\n{right}", f"# mine\n{right}"):
        cell.write(text)
        cell.button("Run").click()
        cell.ends(rf"Exercise {number_of('ten-hertz')}: right\.")
    cell.write("import rospy\n1 / 0\n")
    cell.button("Run").click()
    assert "in line 2" in cell.ends("Exercise")
    cell.button("Reset").click()


def test_verdict_leads_to_the_line_that_it_names(exercises: Page) -> None:
    cell = exercise(exercises, "stop-after-five")
    cell.write("%%answer stop-after-five\nimport rospy\nrospy.init_node('a_node')\n1 / 0\n")
    cell.button("Run").click()
    cell.ends(f"Exercise {number_of('stop-after-five')}: not yet")
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
