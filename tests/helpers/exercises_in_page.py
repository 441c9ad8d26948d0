"""The pages of exercises, and answers that are checked there."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from answers import CELLS, NOTEBOOKS, answer_in, number_of
from listings_in_page import exercise, lines_of
from looks import faults
from playwright.sync_api import Browser, Page, expect
from readers import reader

from rosspin.exercises import EXERCISES, check


@contextmanager
def open_pages(browser: Browser, address: str) -> Iterator[dict[int, Page]]:
    """The page of exercises on each ROS; nothing may go wrong in them."""
    with reader(browser, viewport={"width": 1280, "height": 900}) as context:
        pages = {ros: context.new_page() for ros in NOTEBOOKS}
        wrong = [faults(page, address) for page in pages.values()]
        for ros, page in pages.items():
            page.goto(f"{address}notebooks/{NOTEBOOKS[ros].stem}.html")
        yield pages
        assert not any(wrong)


def is_checked(pages: dict[int, Page], name: str) -> None:
    """The page says of the answers to an exercise, as it comes and right, what a notebook says of them."""
    number = number_of(name)
    cell = exercise(pages[EXERCISES[number - 1].ros], name)
    for answer, status in zip(CELLS[name], ("not yet", "right"), strict=True):
        if status == "right":
            cell.write(answer.source)
        cell.button("Run").click()
        said = cell.ends(f"Exercise {number}: {status}.")
        feedback = check(name, f"\n{answer_in(answer)}")
        console = feedback.console
        words = str(feedback).replace("`", "")
        assert lines_of(said) == lines_of((f"{console}\n" if console else "") + f"{words}\n")
    expect(cell.element.get_by_role("spinbutton")).to_have_count(0)
