"""The pages of exercises, and answers that are checked there."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, Page, expect

from rosspin.exercises import check

from .answers import CELLS, answer_in, number_of
from .listings_in_page import lines_of, open_exercise
from .looks import faults
from .readers import reader


@contextmanager
def open_page(browser: Browser, address: str) -> Iterator[Page]:
    """A page in which nothing may go wrong."""
    with reader(browser, viewport={"width": 1280, "height": 900}) as context:
        page = context.new_page()
        wrong = faults(page, address)
        yield page
        assert not wrong


def is_checked(page: Page, address: str, name: str) -> None:
    """The page says of the answers to an exercise, as it comes and right, what a notebook says of them."""
    number = number_of(name)
    cell = open_exercise(page, address, name)
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
