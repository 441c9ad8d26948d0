"""The built site in Chromium: nothing from another host, no console error, no sideways scrolling, light and dark."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pytest
from looks import FAINT, TOO_WIDE, faults
from playwright.sync_api import Browser, Page


def _open(page: Page, address: str, name: str) -> list[str]:
    """Open a page and scroll to its end; what goes wrong in it is added to the list, now and later."""
    wrong = faults(page, address)
    page.goto(address + name)
    page.evaluate("window.scrollTo(0, document.body.scrollHeight)")
    return wrong


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_pages(site: Path, address: str, browser: Browser, width: int, scheme: Literal["light", "dark"]) -> None:
    names = [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    with browser.new_context(viewport={"width": width, "height": 844}, color_scheme=scheme) as context:
        pages = {name: context.new_page() for name in names}
        wrong = {name: _open(page, address, name) for name, page in pages.items()}
        for name, page in pages.items():
            page.wait_for_load_state("networkidle")
            wrong[name] += page.evaluate(TOO_WIDE) + page.evaluate(FAINT)
            if page.evaluate("document.documentElement.dataset.theme") != scheme:
                wrong[name].append(f"the page is not {scheme}")
    assert not {name: found for name, found in wrong.items() if found}
