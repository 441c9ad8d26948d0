"""axe-core finds nothing to object to on any page, in light and in dark, with the cells opened.

It sees about half of what can be wrong for people who use a screen reader, a keyboard or strong magnification. That the
rest is right, such as the order of reading and what the names mean, no test here shows.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

import pytest
from figures import FIGURES, opened
from hand_ins import HTML, WRONG, Table, handed_in
from listings_in_page import TIMER, TUTORIAL, Cell, link, node, open_tutorial
from playwright.sync_api import Browser, Page, expect
from tree import ROOT

AXE = ROOT / "build" / "npm" / "node_modules" / "axe-core" / "axe.min.js"

Scheme = Literal["light", "dark"]


@pytest.fixture(scope="module")
def violations(site: Path) -> Callable[[Page], list[str]]:
    """What axe-core finds in a page as it is now: the rule, and where."""
    source = AXE.read_text(encoding="utf-8")

    def check(page: Page) -> list[str]:
        page.evaluate(source)
        found: list[Any] = page.evaluate("async () => (await axe.run({ resultTypes: ['violations'] })).violations")
        return [f"{rule['id']}: {node['html'][:200]} {node['target']}" for rule in found for node in rule["nodes"]]

    return check


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_pages(
    site: Path, address: str, browser: Browser, violations: Callable[[Page], list[str]], scheme: Scheme
) -> None:
    wrong = {}
    with browser.new_context(color_scheme=scheme) as context:
        page = context.new_page()
        for path in sorted(site.rglob("*.html")):
            if "_static" not in path.parts:
                name = path.relative_to(site).as_posix()
                page.goto(address + name)
                wrong[name] = violations(page)
    assert not {name: found for name, found in wrong.items() if found}


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_open_cells(address: str, browser: Browser, violations: Callable[[Page], list[str]], scheme: Scheme) -> None:
    """One cell that has run, with output on stderr and a tick chosen, one that runs, and one that could not."""
    with browser.new_context(color_scheme=scheme) as context:
        page = context.new_page()
        open_tutorial(page, address)
        done, running, failed = Cell(page, TIMER), Cell(page, 0), Cell(page, 1)
        done.write(node("rospy.logerr('late')\nrospy.Timer(rospy.Duration(0.1), lambda event: None)\nrospy.spin()"))
        done.run(2)
        done.ends("done")
        done.element.get_by_role("slider").press("End")
        failed.write("1 / 0")
        failed.run(2)
        failed.ends("error")
        running.run(1000, "real time")
        expect(running.console).to_be_visible()
        assert TUTORIAL in page.url
        assert violations(page) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_moved_figures(address: str, browser: Browser, violations: Callable[[Page], list[str]], scheme: Scheme) -> None:
    wrong = {}
    with browser.new_context(color_scheme=scheme) as context:
        page = context.new_page()
        for kind in FIGURES:
            opened(page, address, kind).handle.press("End")
            wrong[kind.page, kind.number] = violations(page)
    assert not {kind: found for kind, found in wrong.items() if found}


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("cell", [TIMER, 99])
def test_shared_code(
    address: str, browser: Browser, violations: Callable[[Page], list[str]], scheme: Scheme, cell: int
) -> None:
    """That came with a link, into a listing or into none; what cannot be copied is shown."""
    with browser.new_context(color_scheme=scheme) as context:
        page = context.new_page()
        page.add_init_script("delete Navigator.prototype.clipboard")
        page.goto(f"{address}{TUTORIAL}?lang=python{link(cell=cell, text='argv')}")
        page.locator(".live-notice:visible").wait_for()
        Cell(page, TIMER).button("Share").click()
        page.locator("textarea:visible").wait_for()
        assert violations(page) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_judged_answers(
    address: str, browser: Browser, violations: Callable[[Page], list[str]], scheme: Scheme
) -> None:
    """A right one, a wrong one, one that was not judged, and a file that was refused."""
    with browser.new_context(color_scheme=scheme) as context:
        table = Table(context.new_page(), address)
        table.drop(ada=handed_in(), ben=handed_in(HTML, answers={"1": WRONG, "99": ""}), odd="")
        table.done()
        table.said("Ada, exercise 1: solved")
        assert violations(table.page) == []
