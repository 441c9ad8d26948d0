"""A figure with a handle in Chromium: it is moved there by keys and by the mouse, and shows the ticks of a run."""

from __future__ import annotations

from playwright.sync_api import BrowserContext

from .figures import Kind, opened
from .looks import faults


def moves_by_keyboard(context: BrowserContext, address: str, kind: Kind) -> None:
    page = context.new_page()
    wrong = faults(page, address)
    figure = opened(page, address, kind)
    first, before = figure.check(), figure.markup()
    figure.handle.focus()
    found = []
    for key in ("Home", "ArrowRight", "PageUp", "End", "ArrowLeft"):
        page.keyboard.press(key)
        found.append(figure.check())
    assert found[0] < found[1] < found[2] < found[3] > found[4] and first not in (found[0], found[3])
    # Moved back, it is as matplotlib drew it.
    while figure.value() > first:
        page.keyboard.press("ArrowLeft")
    assert figure.markup() == before
    assert not wrong


def moves_by_pointer(context: BrowserContext, address: str, kind: Kind) -> None:
    page = context.new_page()
    wrong = faults(page, address)
    figure = opened(page, address, kind)
    box = figure.handle.bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] / 2, y)
    page.mouse.down()
    found = []
    for share in (0.1, 0.45, 0.8):
        page.mouse.move(box["x"] + box["width"] * share, y, steps=3)
        found.append(figure.check())
    page.mouse.up()
    assert found == sorted(set(found))
    assert not wrong
