"""Exercises on their pages: answers are checked, hints asked for, and what was solved is kept."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.helpers.answers import CELLS, NOTEBOOKS, ON_PAGE, answer_in, number_of
from tests.helpers.exercises_in_page import is_checked, open_page
from tests.helpers.listings_in_page import Cell, link, open_exercise
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)


@pytest.fixture(scope="module")
def opened(browser: Browser, address: str) -> Iterator[Page]:
    with open_page(browser, address) as page:
        yield page


@pytest.mark.parametrize("name", ["ten-hertz", "name-the-fault", ON_PAGE[2][-2]])
def test_exercise_is_checked(opened: Page, address: str, name: str) -> None:
    """A few; all of them are in judge/."""
    is_checked(opened, address, name)


@pytest.mark.parametrize("ros", NOTEBOOKS)
def test_what_was_solved_is_kept_and_leads_on(opened: Page, address: str, ros: int) -> None:
    """Told after each right answer, and known when the reader comes back, and on the list; then comes the next one."""
    page, (name, following, *_), count = opened, ON_PAGE[ros], len(ON_PAGE[ros])
    onward = page.get_by_role("link", name="Next: ")
    cell = open_exercise(page, address, name)
    cell.write(CELLS[name][0].source + "\n1 / 0\n")
    cell.button("Run").click()
    cell.ends(f"Exercise {number_of(name)}: not yet")
    expect(onward).to_be_hidden()
    cell.write(CELLS[name][1].source)
    cell.button("Run").click()
    cell.ends(rf"Exercise {number_of(name)}: right\. You have solved \d+ of {count}\.")
    expect(onward).to_be_in_viewport()
    page.reload()
    expect(cell.status).to_have_text("solved, as you edited it")
    said = page.locator("article .live-progress").text_content() or ""
    assert re.fullmatch(rf"[1-9]\d* of {count} solved", said)
    assert beside_its_link(page, ros) == said
    cell.button("Reset").click()
    expect(cell.status).to_have_text("an earlier version was solved")
    onward.click()
    expect(page).to_have_url(f"{address}exercises/{following}.html")
    page.get_by_role("link", name=re.compile("^Exercises")).and_(page.locator(".exercise-way a")).click()
    expect(page).to_have_url(f"{address}notebooks/{NOTEBOOKS[ros].stem}.html")
    assert page.locator("article .live-progress").text_content() == said
    solved = page.locator(".exercise-list .is-solved")
    expect(solved.first).to_contain_text(f"{number_of(name)}. ")
    assert said.startswith(f"{solved.count()} of ")


def test_each_list_counts_its_own(opened: Page, address: str) -> None:
    """A page that runs nodes shows both counts in its sidebar."""
    for name, *_ in ON_PAGE.values():
        cell = open_exercise(opened, address, name)
        cell.write(CELLS[name][1].source)
        cell.button("Run").click()
        cell.ends(f"Exercise {number_of(name)}: right")
    page = opened.context.new_page()
    page.goto(address + "docs/tutorial.html")
    for ros, names in ON_PAGE.items():
        assert beside_its_link(page, ros).endswith(f" of {len(names)} solved")
    expect(page.locator(".live-progress")).to_have_count(2)
    page.close()


def beside_its_link(page: Page, ros: int) -> str:
    """What the sidebar, where ROS 2 comes first, says next to the link to a page of exercises."""
    links = page.locator(".bd-docs-nav a").filter(has_text=re.compile("^Exercises$"))
    return links.nth(2 - ros).locator("xpath=following-sibling::*[1]").text_content() or ""


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", ["make-it-10-hz", "period-parameter", "cancel-a-goal", "stop-the-motor"])
def test_the_task_the_listing_and_run_are_on_one_screen(browser: Browser, address: str, name: str, width: int) -> None:
    """Without scrolling: nor is the page wider than the screen."""
    with reader(browser, viewport={"width": width, "height": 844}) as context:
        page = context.new_page()
        cell = open_exercise(page, address, name)
        for part in page.locator("h1"), cell.element.locator("pre").first, cell.button("Run"):
            expect(part).to_be_in_viewport()
        assert page.evaluate("document.documentElement.scrollWidth") == width


TUTORIALS = ["docs/ros2/tutorial", "docs/ros2/tutorial-timer", "docs/tutorial"]
NOTED = ["drive", "ros2-executors", "ros2-publish", "ros2-timer", "ros2-timer-slow", "timer"]


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (390, 844)])
def test_a_run_is_in_view_on_the_first_screen(
    browser: Browser, address: str, site: Path, width: int, height: int
) -> None:
    """Without scrolling, and on tutorials and, on a large screen, on notebooks; and nothing is wider than the screen.

    It is the Run of the answer, or of the node that it is about.
    """
    names = [*(f"exercises/{file.stem}" for file in sorted((site / "exercises").glob("*.html"))), *TUTORIALS]
    names += [f"notebooks/{name}" for name in NOTED] if width > height else []
    with reader(browser, viewport={"width": width, "height": height}) as context:
        page, wide = context.new_page(), []
        for name in names:
            page.goto(f"{address}{name}.html")
            expect(page.get_by_role("button", name=re.compile("^Run ")).first, name).to_be_in_viewport(ratio=1)
            wide += [name] * (page.evaluate("document.documentElement.scrollWidth") != width)
        assert not wide


def test_a_prediction_is_written_where_it_stays_in_view(page: Page, address: str) -> None:
    """The page does not move when its cell is edited: one reads the node meanwhile."""
    page.set_viewport_size({"width": 390, "height": 844})
    cell = open_exercise(page, address, "first-ticks")
    cell.write("timer = [0.4, 0.8, 1.2]\n")
    expect(cell.button("Run")).to_be_in_viewport(ratio=1)
    assert page.evaluate("scrollY") == 0


def test_links_to_the_list_lead_to_the_exercise(page: Page, address: str) -> None:
    """With its name, which was a heading there, with the words of that heading, or with code for it."""
    for anchor, name in ("two-timers", "two-timers"), ("give-a-node-two-timers", "two-timers"):
        page.goto(f"{address}notebooks/ros2-exercises.html?path=evening#{anchor}")
        expect(page).to_have_url(f"{address}exercises/{name}.html?path=evening")
    page.goto(f"{address}notebooks/ros2-exercises.html{link(cell=3, text='%%answer slow-timer' + chr(10))}")
    expect(page).to_have_url(re.compile("/exercises/slow-timer.html#code="))
    expect(page.locator(".live-notice:visible")).to_contain_text("This code came with the link")


def test_what_is_solved_leads_on_along_the_path_that_one_chose(browser: Browser, address: str) -> None:
    """Not to the next on the list; and at the end of the path, back to all of them."""
    with reader(browser) as context:
        page = context.new_page()
        onward, below = page.locator(".exercise-next a"), page.locator(".right-next .prev-next-title")
        came = page.locator(".left-prev .prev-next-title")
        for name, before, said in (
            ("make-it-10-hz", "", "2[.] When"),
            ("first-call", "1[.] Make", "Publish at a frequency"),
        ):
            page.goto(f"{address}exercises/{name}.html?path=evening")
            expect(onward).to_have_text(re.compile(f"^Next: {said}"))
            expect(below).to_have_text(re.compile(f"^{said}"))
            if before:
                expect(came).to_have_text(re.compile(f"^{before}"))
            assert onward.get_attribute("href") == page.locator(".right-next").get_attribute("href")
        page.goto(f"{address}notebooks/drive.html")
        page.locator(".left-prev").click()
        expect(page).to_have_url(f"{address}notebooks/ros2-executors.html?path=evening")
        page.goto(f"{address}exercises/look-while-driving.html")
        expect(onward).to_have_text("Finished: The path of an evening")
        expect(onward).to_have_attribute("href", re.compile("docs/paths.html#evening$"))
        expect(page.locator(".right-next")).to_be_hidden()


def test_hints_are_asked_for_one_at_a_time(opened: Page, address: str) -> None:
    open_exercise(opened, address, "fire-once")
    hints = opened.locator(".sd-tab-content:visible details:has(> summary:text('Hint'))")
    assert hints.count() >= 3
    for number in range(hints.count()):
        assert [hint.is_visible() for hint in hints.all()] == [place <= number for place in range(hints.count())]
        hints.nth(number).locator("summary").press("Enter")
        expect(hints.nth(number).locator("p").first).to_be_visible()


def test_a_whole_node_that_is_pasted_is_an_answer(opened: Page, address: str) -> None:
    """The cell knows which exercise it answers; its first line need not be there, and its lines keep their numbers."""
    cell = open_exercise(opened, address, "ten-hertz")
    right = answer_in(CELLS["ten-hertz"][1])
    for text in (right, f"%%answer\n{right}", f"%%answer 4\n{right}", f"# mine\n{right}"):
        cell.write(text)
        cell.button("Run").click()
        cell.ends(rf"Exercise {number_of('ten-hertz')}: right\.")
    cell.write("import rospy\n1 / 0\n")
    cell.button("Run").click()
    assert "in line 2" in cell.ends("Exercise")
    cell.button("Reset").click()


def test_verdict_leads_to_the_line_that_it_names(opened: Page, address: str) -> None:
    cell = open_exercise(opened, address, "stop-after-five")
    cell.write("%%answer stop-after-five\nimport rospy\nrospy.init_node('a_node')\n1 / 0\n")
    cell.button("Run").click()
    cell.ends(f"Exercise {number_of('stop-after-five')}: not yet")
    for place in ('"<answer>", line 4', "in line 4"):
        cell.console.get_by_role("button", name=place).first.click()
        expect(cell.editor).to_be_focused()
        assert opened.evaluate("getSelection().toString()") == "1 / 0"
        cell.editor.press("Control+Home")
    cell.button("Reset").click()


def test_ticks_at_the_same_time_are_drawn_apart(opened: Page, address: str) -> None:
    """The plot of the blocking node shows both ticks at 2.2 s."""
    open_exercise(opened, address, "after-a-slow-callback")
    cell = Cell(opened, 0)
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
