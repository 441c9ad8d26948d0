"""Exercises in C++ on their pages: in a tab of their own, judged as in Python, and kept besides."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from rosspin.hand_ins.files import read
from tests.helpers.answers import CELLS, IN_CPP
from tests.helpers.listings_in_page import Cell, open_exercise
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)

NAME = "make-it-10-hz"


@pytest.fixture(scope="module")
def opened(browser: Browser) -> Iterator[Page]:
    with reader(browser) as context:
        yield context.new_page()


def in_cpp(page: Page, address: str, name: str = NAME) -> Cell:
    page.goto(f"{address}exercises/{name}.html?lang=cpp")
    return Cell(page, 0, "div.live.highlight-cpp")


def check(cell: Cell, text: str = "") -> None:
    if text:
        cell.write(f"%%answer {NAME}\n{text}")
    cell.button("Run").click()


def test_what_is_given_is_judged_without_a_compiler(page: Page, address: str) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    cell = in_cpp(page, address)
    expect(page.get_by_text("C++", exact=True)).to_be_visible()
    check(cell)
    console = cell.ends("Exercise 1: not yet")
    assert "Counter 1 came at 0.5 s, not at 0.1 s." in console and "create_wall_timer" in console
    assert not [url for url in asked if "/clang/" in url]


def test_an_answer_is_compiled_judged_and_kept_besides_that_in_python(
    opened: Page, address: str, tmp_path: Path
) -> None:
    page = opened
    python = open_exercise(page, f"{address}", f"{NAME}")
    python.write(CELLS[NAME][0].source + "\n# mine\n")
    cell = in_cpp(page, address)
    cell.button("Edit").click()
    expect(cell.status).to_contain_text("loads clang once: about 28 MB")
    broken = IN_CPP[NAME].written({"counter_++;": "counter_++"})
    check(cell, broken)
    line = broken.splitlines().index("    counter_++") + 2
    said = cell.ends("error: see the console")
    assert f"answer.cpp:{line}:15: error: expected ';'" in said and "A ; is missing" in said
    check(cell, IN_CPP[NAME].changed)
    assert "counter = 10" in cell.ends(r"Exercise 1: right\. You have solved 1 of 21\.")
    expect(page.get_by_role("link", name="Next: ")).to_be_visible()
    page.goto(f"{address}exercises/{NAME}.html")  # the language is remembered
    expect(cell.status).to_have_text("solved, as you edited it")
    page.get_by_text("Python", exact=True).click()
    expect(open_exercise(page, address, NAME).element).to_contain_text("# mine")
    page.get_by_label("Your name").fill("Ann")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save answers").click()
    download.value.save_as(tmp_path / "answers.json")
    data = (tmp_path / "answers.json").read_bytes()
    assert json.loads(data)["version"] == 2
    assert read("answers.json", data).answers == {NAME: f"%%answer {NAME}\n{IN_CPP[NAME].changed}"}


def test_what_never_ends_is_stopped(opened: Page, address: str) -> None:
    cell = in_cpp(opened, address)
    check(cell, IN_CPP[NAME].written({"counter_++;": "for (volatile int i = 0;; i++) {}"}))
    cell.ends("running")
    cell.button("Stop").click()
    expect(cell.status).to_have_text(re.compile("^stopped"))
