"""The vehicle that a reader's own node steers, in Chromium: its page, its pictures, its six tasks."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from rosspin.exercises import EXERCISES, check
from rosspin.exercises.own import Lesson
from tests.helpers.answers import TASKS
from tests.helpers.axe import in_both_schemes
from tests.helpers.listings_in_page import Cell, open_exercise, unfold
from tests.helpers.looks import TOO_WIDE

pytestmark = pytest.mark.shares(10)

PAGE = "notebooks/drive.html"

ANYWHERE = "The vehicle drives 15.0 m in 8 s and leaves its line by 1.4 m, at 4.8 s. Commands: 16 from /driver_py_node."


def driven(cell: Cell) -> str | None:
    figure = cell.element.locator(".live-drive")
    expect(figure.get_by_role("img")).to_have_count(1)
    return figure.get_by_role("img").get_attribute("aria-label")


@pytest.mark.parametrize("number", [0, 1], ids=["ROS 2", "ROS 1"])
def test_a_node_drives_and_the_page_draws_it_as_the_build_did(page: Page, address: str, number: int) -> None:
    page.goto(address + PAGE)
    unfold(page)
    cell = Cell(page, number)
    made = page.locator("div.cell:has(div.live)").nth(number).locator(".cell_output figure")
    before = str(made.locator("svg").first.get_attribute("aria-label"))
    cell.button("Run").click()
    cell.ends("done: 16 ticks")
    said = driven(cell)
    assert said and before.startswith(said) and (number or said == ANYWHERE)
    expect(made).to_be_hidden()
    expect(cell.button("Copy as test")).to_be_hidden()


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.exercise.name)
def test_a_task_is_judged_and_drawn_as_in_a_notebook(page: Page, address: str, task: Lesson) -> None:
    name = task.exercise.name
    number = next(each.number for each in EXERCISES if each.name == name)
    cell = open_exercise(page, address, name)
    for answer, verdict in ((task.node, "not yet"), (task.written(task.right[1]), "right")):
        text = f"%%answer {name}\n{answer}"
        cell.write(text)
        cell.button("Run").click()
        said = cell.ends(f"Exercise {number}: {verdict}.")
        feedback = check(name, f"\n{answer}")
        assert str(feedback).replace("`", "") in said.replace("\n\n", "\n")
        assert driven(cell) == feedback.drive.words
    expect(page.locator("article .live-progress")).to_have_text("1 of 6 solved")


def test_the_pictures_are_fit_for_all(page: Page, address: str) -> None:
    page.goto(address + PAGE)
    cell = Cell(page, 0)
    cell.button("Run").click()
    cell.ends("done")
    assert in_both_schemes(page) == []
    page.set_viewport_size({"width": 390, "height": 844})
    assert page.evaluate(TOO_WIDE) == []
