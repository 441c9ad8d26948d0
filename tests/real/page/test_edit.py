"""Listings are edited, and run with the keyboard alone."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.helpers.listings_in_page import (
    LISTINGS,
    OTHER,
    TIMER,
    Cell,
    open_tutorial,
)
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


def test_edit(tutorial: Page, address: str) -> None:
    """The reader changes 0.5 to 0.1. The edit survives a reload, Copy copies it, Reset brings the original back, and
    what was reset can be had again."""
    cell = Cell(tutorial, TIMER)
    original = (EXAMPLES / LISTINGS[TIMER]).read_text(encoding="utf-8")
    edited = original.replace("0.5", "0.1")
    cell.write(edited)
    cell.element.get_by_role("spinbutton").fill("1")
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.editor.press("Control+Enter")
    assert cell.ends("done: 10 ticks").count("counter = ") == 10

    open_tutorial(tutorial, address)
    assert cell.element.locator("pre").first.text_content() == edited
    tutorial.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell.element.locator("pre").first.hover()
    cell.element.locator("button.copybtn").click()
    assert tutorial.evaluate("navigator.clipboard.readText()") == edited.rstrip("\n")
    other = Cell(tutorial, OTHER)
    untouched = (EXAMPLES / LISTINGS[OTHER]).read_text(encoding="utf-8")
    assert other.element.locator("pre").first.text_content() == untouched

    cell.button("Reset").click()
    assert cell.element.locator("pre").first.text_content() == original
    expect(cell.element.locator("pre .k").first).to_be_visible()
    cell.button("Restore earlier version").click()
    assert cell.element.locator("pre").first.text_content() == edited
    expect(cell.button("Restore earlier version")).to_be_hidden()
    cell.button("Reset").press("Enter")  # which has the focus
    assert cell.element.locator("pre").first.text_content() == original
    open_tutorial(tutorial, address)
    assert cell.element.locator("pre").first.text_content() == original


def test_keyboard_alone(tutorial: Page) -> None:
    """From the heading by Tab into the cell; Enter, Escape, Tab and Ctrl-Enter do the rest."""
    cell = Cell(tutorial, TIMER)
    cell.element.get_by_role("spinbutton").fill("1000")
    cell.element.get_by_role("combobox").select_option("real time")
    cell.button("Run").focus()
    for name in ("Stop", "Edit"):
        tutorial.keyboard.press("Tab")
        expect(cell.button(name)).to_be_focused()
    tutorial.keyboard.press("Enter")
    expect(cell.editor).to_be_focused()
    tutorial.keyboard.press("Control+End")
    tutorial.keyboard.type("# mine")
    tutorial.keyboard.press("Tab")
    expect(cell.editor).to_be_focused()
    tutorial.keyboard.press("Control+Enter")
    expect(cell.status).to_have_text(re.compile("^starting Python|^running"))
    tutorial.keyboard.press("Escape")
    expect(cell.button("Run")).to_be_focused()
    tutorial.keyboard.press("Tab")
    tutorial.keyboard.press("Enter")
    cell.ends("stopped")
    for _ in range(2):
        tutorial.keyboard.press("Tab")
    expect(cell.button("Reset")).to_be_focused()
    tutorial.keyboard.press("Enter")
    expect(cell.editor).to_have_count(0)
    expect(cell.button("Reset")).to_be_focused()
