"""axe-core finds nothing to object to where readers and teachers have done something, in light and in dark."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.helpers.answers import number_of
from tests.helpers.axe import in_both_schemes
from tests.helpers.hand_ins import HTML, WRONG, Table, handed_in
from tests.helpers.listings_in_page import TIMER, TUTORIAL, Cell, link, node, open_tutorial

pytestmark = pytest.mark.shares(10)


def test_open_cells(page: Page, address: str) -> None:
    """One cell that has run, with output on stderr and a tick chosen, one that runs, and one that could not."""
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
    assert in_both_schemes(page) == []


@pytest.mark.parametrize("cell", [TIMER, 99])
def test_shared_code(page: Page, address: str, cell: int) -> None:
    """That came with a link, into a listing or into none; what cannot be copied is shown."""
    page.add_init_script("delete Navigator.prototype.clipboard")
    page.goto(f"{address}{TUTORIAL}?lang=python{link(cell=cell, text='argv')}")
    page.locator(".live-notice:visible").wait_for()
    page.locator("details").evaluate_all("all => all.forEach((each) => (each.open = true))")
    Cell(page, TIMER).button("Copy link").click()
    page.locator("textarea:visible").wait_for()
    assert in_both_schemes(page) == []


def test_judged_answers(table: Table) -> None:
    """A right one, a wrong one, one that was not judged, and a file that was refused."""
    table.drop(ada=handed_in(), ben=handed_in(HTML, answers={"first-ticks": WRONG, "99": ""}), odd="")
    table.done()
    table.said(f"Ada, exercise {number_of('first-ticks')}: solved")
    assert in_both_schemes(table.page) == []
