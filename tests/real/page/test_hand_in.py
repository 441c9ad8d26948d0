"""Answers are handed in as a file, which the teachers' page reads."""

from __future__ import annotations

import json
import re
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Download, FilePayload, Page, expect

from tests.helpers.answers import number_of
from tests.helpers.hand_ins import EXERCISE, EXERCISES, RIGHT, TEACHERS, WRONG, Table
from tests.helpers.listings_in_page import Cell
from tests.helpers.readers import reader

pytestmark = pytest.mark.shares(10)


def _hand_in(page: Page, name: str) -> tuple[str, dict[str, Any]]:
    with page.expect_download() as found:
        page.get_by_label("Your name").fill(name)
        page.get_by_role("button", name="Save answers").click()
    return _read(found.value)


def _read(download: Download) -> tuple[str, dict[str, Any]]:
    return download.suggested_filename, json.loads(Path(download.path()).read_text(encoding="utf-8"))


def test_what_was_answered_is_saved(page: Page, address: str) -> None:
    """As it stands on the page, run or not, and what the browser keeps of other pages; without any verdict."""
    page.goto(address + EXERCISE)
    status = page.locator(".hand-in").get_by_role("status")
    page.get_by_role("button", name="Save answers").click()
    expect(status).to_have_text("Write your name first.")
    expect(page.get_by_label("Your name")).to_be_focused()
    page.get_by_label("Your name").fill("Ada")
    page.get_by_label("Your name").press("Enter")
    expect(status).to_have_text("There is nothing to hand in: you have not changed an answer yet.")

    Cell(page, 0).write(RIGHT)
    other = "%%answer slow-timer\nticks = [1]\n"
    record = json.dumps({"solved": False, "versions": [{"id": "a.0", "time": 1, "text": other}]})
    page.evaluate("record => localStorage.setItem('rosspin:/:answer:slow-timer', record)", record)
    name, found = _hand_in(page, " Ada <Lovelace>/2 ")
    assert name == "rosspin-answers-Ada-Lovelace-2.json"
    assert found.pop("id")
    assert abs((datetime.fromisoformat(found.pop("date")) - datetime.now().astimezone()).days) <= 1
    answers = {"first-ticks": RIGHT, "slow-timer": other}
    assert found == {"format": "rosspin-answers", "version": 2, "name": "Ada <Lovelace>/2", "answers": answers}
    numbers = " and ".join(map(str, sorted(map(number_of, answers))))
    expect(status).to_have_text(re.compile(f"^Saved as {name}, with your answers to exercises {numbers}"))


def test_name_and_answers_are_there_after_a_reload(page: Page, address: str) -> None:
    page.goto(address + EXERCISE)
    Cell(page, 0).write(WRONG)
    _, before = _hand_in(page, "Ada")
    page.reload()
    expect(page.get_by_label("Your name")).to_have_value("Ada")
    with page.expect_download() as found:
        page.get_by_role("button", name="Save answers").click()
    assert _read(found.value)[1] | {"date": before["date"]} == before


def test_file_comes_from_the_one_page_to_the_other(quick: Table, address: str) -> None:
    page = quick.page
    page.goto(address + EXERCISE)
    Cell(page, 0).write("%%answer first-ticks\nsolved")
    name, found = _hand_in(page, "Ada")
    table = Table(page, address)
    table.input.set_input_files(FilePayload(name=name, mimeType="application/json", buffer=json.dumps(found).encode()))
    table.done()
    expect(table.sign(f"Ada, exercise {number_of('first-ticks')}: solved")).to_have_text("✓")


# --- where it cannot be -----------------------------------------------------------------------------------------------


def test_without_jspi(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.add_init_script("delete WebAssembly.Suspending")
    page.goto(address + TEACHERS)
    expect(page.get_by_text("This browser cannot check answers: it lacks JSPI")).to_be_visible()
    expect(page.locator(".rosspin-judge input")).to_have_count(0)
    page.goto(address + EXERCISES)
    expect(page.get_by_text("This browser cannot check answers, nor hand them in: it lacks JSPI")).to_be_visible()
    expect(page.locator(".hand-in")).to_have_count(0)


def test_without_javascript(browser: Browser, address: str) -> None:
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + TEACHERS)
        expect(page.get_by_text("To check answers here, this page needs JavaScript.")).to_be_visible()
