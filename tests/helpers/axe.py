"""What axe-core finds in a page.

It sees about half of what can be wrong for people who use a screen reader, a keyboard or strong magnification. That the
rest is right, such as the order of reading and what the names mean, no test here shows.
"""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from playwright.sync_api import Page

from .looks import look
from .tree import ROOT

# The rules that are about colours; what the others find is the same in light and in dark.
COLOURS = ("color-contrast", "link-in-text-block")


@cache
def _source() -> str:
    return (ROOT / "build" / "npm" / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")


def violations(page: Page, rules: tuple[str, ...] = ()) -> list[str]:
    """What axe-core finds in a page as it is now, by these rules or by all: the rule, and where."""
    page.evaluate(_source())
    options = {"resultTypes": ["violations"]} | ({"runOnly": list(rules)} if rules else {})
    found: list[Any] = page.evaluate(f"async () => (await axe.run({json.dumps(options)})).violations")
    return [f"{rule['id']}: {node['html'][:200]} {node['target']}" for rule in found for node in rule["nodes"]]


def in_both_schemes(page: Page) -> list[str]:
    """The same, of a page that is light, in light and in dark."""
    found = violations(page)
    look(page, "dark")
    return found + violations(page, COLOURS)
