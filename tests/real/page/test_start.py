"""How Python starts in a page, from what, and what is said where a part of it cannot be had."""

from __future__ import annotations

import gzip
import re
from functools import cache
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from rosspin import simulate
from tests.helpers.listings_in_page import (
    LISTINGS,
    OTHER,
    ROS2,
    TIMER,
    TUTORIAL,
    Cell,
    have_workers,
    open_tutorial,
)
from tests.helpers.readers import asks_for_no_more, until
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


def _asked(page: Page, name: str) -> list[str]:
    """A list of the requests for a file from now on."""
    found: list[str] = []
    page.on("request", lambda request: found.append(request.url) if f"/live/{name}" in request.url else None)
    return found


def _first_run(page: Page, address: str, text: str = "") -> str:
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    if text:
        cell.write(text)
    cell.run(2)
    return cell.ends("done")


@pytest.mark.parametrize("sign", ["hover", "focus"])
def test_python_is_asked_for_when_the_reader_points_at_run(context: BrowserContext, address: str, sign: str) -> None:
    page = context.new_page()
    asked = _asked(page, "")
    open_tutorial(page, address)
    asks_for_no_more(page)
    assert not [url for url in asked if "/live/live." not in url]
    with page.expect_request(re.compile("/snapshot.zst")):
        getattr(Cell(page, TIMER).button("Run"), sign)()


def _kept(page: Page) -> list[str]:
    """Which snapshots the browser keeps."""
    keys = page.evaluate("async () => (await (await caches.open('rosspin')).keys()).map((key) => key.url)")
    return [urlsplit(url).query for url in keys]


def _until_kept(page: Page) -> None:
    """Wait for this site's, and for no other: some time after the first run."""
    until(page, lambda: len(kept := _kept(page)) == 1 and kept != ["old"])


def test_snapshot_is_kept_for_the_next_page(context: BrowserContext, address: str) -> None:
    """In place of an earlier version's."""
    page = context.new_page()
    page.goto(address)
    page.evaluate("async () => (await caches.open('rosspin')).put('snapshot.zst?old', new Response('old'))")
    asked = _asked(page, "snapshot.zst")
    assert "counter = 1" in _first_run(page, address)
    assert asked
    _until_kept(page)
    page.close()
    page = context.new_page()
    asked = _asked(page, "snapshot.zst")
    assert "counter = 1" in _first_run(page, address)
    assert not asked


def test_without_a_snapshot_python_starts_plainly(context: BrowserContext, address: str) -> None:
    expected = simulate(EXAMPLES / LISTINGS[TIMER], 2).console
    context.route("**/snapshot.zst*", lambda route: route.abort())
    page = context.new_page()
    whole, snapshots = _asked(page, "python_stdlib.zip"), _asked(page, "snapshot.zst")
    assert _first_run(page, address) == expected
    assert whole
    assert _kept(page) == []
    page.close()  # its spare worker may still be starting
    context.unroute("**/snapshot.zst*")
    page = context.new_page()
    whole, snapshots = _asked(page, "python_stdlib.zip"), _asked(page, "snapshot.zst")
    assert _first_run(page, address) == expected
    assert snapshots and not whole


def test_without_what_unpacks_a_snapshot_python_starts_plainly(context: BrowserContext, address: str) -> None:
    context.route("**/unpack.js*", lambda route: route.abort())
    page = context.new_page()
    whole = _asked(page, "python_stdlib.zip")
    assert _first_run(page, address) == simulate(EXAMPLES / LISTINGS[TIMER], 2).console
    assert whole


@cache
def packed(file: Path) -> int:
    """The size of a file as it is sent."""
    return len(gzip.compress(file.read_bytes()))


@pytest.mark.parametrize("node", [EXAMPLES / LISTINGS[TIMER], ROS2[0]], ids=["ros1", "ros2"])
def test_first_click_loads_at_most_9_mb(context: BrowserContext, address: str, site: Path, node: Path) -> None:
    """Gzipped, as servers send them. ROS 2 is in the snapshot, too."""
    page = context.new_page()
    asked = _asked(page, "")
    assert "counter = 1" in _first_run(page, address, node.read_text(encoding="utf-8"))
    files = {site / urlsplit(url).path.lstrip("/") for url in asked}
    assert 7_000_000 < sum(map(packed, files)) <= 9_140_000


def test_our_own_files_are_loaded_when_one_is_read(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    asked = _asked(page, "rosspin.zip")
    for text in ("", ROS2[0].read_text(encoding="utf-8")):
        assert "counter = 1" in _first_run(page, address, text)
    assert not asked
    text = "import inspect\nimport rospy\nprint(inspect.getsource(rospy.Rate).splitlines()[0])\n"
    assert _first_run(page, address, text) == "class Rate:\n"
    assert asked


def test_node_finds_no_traces_of_the_snapshot(context: BrowserContext, address: str) -> None:
    """Its environment and its path are as in a plain start; nothing that made the snapshot is left in it."""
    text = "import os, sys\nprint(sorted(os.environ.items()), sys.path, sys.argv)\nprint(sorted(globals()))\n"
    found = _first_run(context.new_page(), address, text)
    context.route("**/snapshot.zst*", lambda route: route.abort())
    page = context.new_page()
    page.goto(address + TUTORIAL)
    page.evaluate("caches.delete('rosspin')")
    plain = _first_run(page, address, text)
    assert re.sub("'LANG', '.*?'", "", found) == re.sub("'LANG', '.*?'", "", plain)


# --- what cannot be loaded --------------------------------------------------------------------------------------------

# What is said where a file of the site cannot be had.
NOT_LOADED = "A part of Python could not be loaded from this site. Is its server still there?"


def test_without_the_server(context: BrowserContext, address: str) -> None:
    """The Python that is ready runs once more; where no other can be had, none runs twice. Then all is as before."""
    page = context.new_page()
    assert _first_run(page, address, "print('first')") == "first\n"
    cell = Cell(page, TIMER)

    def ends(text: str, status: str) -> str:
        cell.write(text)
        cell.run(1)
        return cell.ends(status)

    have_workers(page, 1)  # a Python whose files are still on their way might wait for them
    context.set_offline(True)
    context.route("**/sandbox.html*", lambda route: route.abort())  # which the browser may still have
    assert ends("import csv", "error").endswith(f"{NOT_LOADED}\n")
    assert ends("print('next')", "error").startswith("The frame in which Python runs did not open.")
    context.unroute("**/sandbox.html*")
    context.set_offline(False)
    assert ends("import csv", "done") == ""


def test_a_link_that_cannot_be_made(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    open_tutorial(page, address)
    context.set_offline(True)
    cell = Cell(page, OTHER)
    cell.button("Copy link").click()
    expect(cell.status).to_have_text("error: the link could not be made. Is the site still there?")
    context.set_offline(False)


def test_an_editor_that_cannot_be_loaded(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    open_tutorial(page, address)
    context.set_offline(True)
    cell = Cell(page, OTHER)
    cell.button("Edit").click()
    expect(cell.status).to_have_text("error: the editor could not be loaded. Is the site still there?")


TRIES_AGAIN = """import time

while True:
    try:
        import csv
        break
    except OSError:
        print("not yet")
        time.sleep(0.1)
"""


def test_a_wrong_file_in_the_place_of_the_library(context: BrowserContext, address: str) -> None:
    """As from a portal, or cut off; nothing of it is kept."""
    context.route("**/python_stdlib.zip*", lambda route: route.fulfill(body="PK"))
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write(TRIES_AGAIN)
    cell.run(1000, "real time")
    expect(cell.console).to_contain_text("not yet")
    context.unroute("**/python_stdlib.zip*")
    assert set(cell.ends("done").splitlines()) == {"not yet"}
