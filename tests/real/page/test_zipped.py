"""The zip of the site: what works where it is opened as files, and from the server that its first page names."""

from __future__ import annotations

import os
import re
import shlex
import socket
import subprocess
import sys
from collections.abc import Iterator
from html import unescape
from pathlib import Path
from zipfile import ZipFile

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from rosspin.site.zipped import START
from tests.helpers.axe import violations
from tests.helpers.listings_in_page import Cell
from tests.helpers.looks import TOO_WIDE, faults, look
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)


@pytest.fixture(scope="module")
def folder(site: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that a teacher has after `make zip`, of which this is the last line, and unpacking."""
    run = subprocess.run([sys.executable, "-m", "rosspin.site.zipped"], cwd=ROOT, capture_output=True, text=True)
    assert re.fullmatch(r"build/rosspin-site\.zip: \d+\.\d MB\n", run.stdout), run.stderr
    target = tmp_path_factory.mktemp("stick")
    with ZipFile(ROOT / "build/rosspin-site.zip") as archive:
        archive.extractall(target)
    return target / "rosspin-site"


@pytest.fixture
def stick(context: BrowserContext, folder: Path) -> Iterator[Page]:
    """The page to start with, opened by a double click; nothing may go wrong after it."""
    page = context.new_page()
    wrong = faults(page, folder.as_uri())
    page.goto((folder / START).as_uri())
    yield page
    assert not wrong


def test_the_first_page(stick: Page) -> None:
    assert violations(stick) == []
    stick.emulate_media(color_scheme="dark")
    assert violations(stick) == []
    stick.set_viewport_size({"width": 320, "height": 800})
    assert stick.evaluate(TOO_WIDE) == []
    stick.get_by_role("link", name="Open the first page").click()
    expect(stick.get_by_role("heading", level=1)).to_contain_text("Spin a ROS node at a frequency")
    look(stick, "light")


def test_figures_move(stick: Page, folder: Path) -> None:
    """The vehicle, a plot with a handle, and a run to go through."""
    stick.goto((folder / "site/index.html").as_uri())
    vehicle = stick.locator("figure[data-vehicle]")
    expect(vehicle.get_by_role("button")).to_be_visible()
    figure = stick.locator("figure[data-positions]").first
    before = figure.locator("b").inner_text()
    figure.get_by_role("slider").press("End")
    expect(figure.locator("b")).not_to_have_text(before)
    stick.goto((folder / "site/docs/ros2/how-timing-works.html").as_uri())
    stick.get_by_role("button", name="Forward").first.click()
    expect(stick.locator(".stepper-token:visible").first).to_be_visible()


def test_search(context: BrowserContext, folder: Path) -> None:
    """It finds pages. Files may not read other files, so it has no excerpts of them."""
    page = context.new_page()
    page.goto((folder / "site/search.html").as_uri() + "?q=jitter")
    expect(page.locator("#search-results li a").first).to_be_visible()
    expect(page.locator("#search-results .search-summary")).to_contain_text("matching the search query")
    assert page.locator("#search-results li p.context").count() == 0


def test_slides_and_notes(stick: Page, folder: Path) -> None:
    stick.goto((folder / "site/docs/slides/ros2.html").as_uri())
    stick.get_by_role("link", name="Show as slides").click()
    with stick.expect_popup() as opened:
        stick.get_by_role("button", name="Notes").click()
    stick.keyboard.press("PageDown")
    expect(opened.value.get_by_role("status")).to_have_text(re.compile("^2 of"))


def test_a_listing_and_an_exercise_say_that_they_need_a_server(stick: Page, folder: Path) -> None:
    for name in ("docs/ros2/tutorial", "exercises/make-it-10-hz"):
        stick.goto((folder / f"site/{name}.html").as_uri())
        expect(stick.locator(".live-missing:visible").first).to_contain_text("Opened as a file")
        expect(stick.get_by_role("button", name="Run")).to_have_count(0)


def test_a_listing_runs_from_the_server_that_the_first_page_names(page: Page, folder: Path) -> None:
    """The command for macOS and Linux, as it stands but for the port, which may be taken."""
    text = unescape((folder / START).read_text(encoding="utf-8"))
    of_windows, command = re.findall(r"<pre>(.*?)</pre>", text)
    assert of_windows.split()[1:] == command.split()[1:]
    python, *words, port = shlex.split(command)
    assert (python, port) == ("python3", "8000")
    environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(
        [sys.executable, *words, "0"], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as server:
        try:
            assert server.stdout
            port = re.search(rb" port (\d+) ", server.stdout.readline())[1].decode()  # type: ignore[index]
            with pytest.raises(OSError):  # by another of this machine's addresses
                socket.create_connection(("127.0.0.2", int(port)), 5)
            _runs(page, f"http://127.0.0.1:{port}/")
        finally:
            server.terminate()


def _runs(page: Page, address: str) -> None:
    tab = page.context.new_page()
    wrong = faults(tab, address)
    tab.goto(f"{address}docs/ros2/tutorial.html")
    cell = Cell(tab, 0)
    cell.run(2)
    assert "counter = 4" in cell.ends("done: 4 ticks")
    tab.goto(f"{address}docs/ros2/tutorial.html?lang=cpp")
    cell = Cell(tab, 0, "div.live.highlight-cpp")
    cell.run(2)
    assert "counter = 4" in cell.ends("done: 4 ticks")
    cell.write((cell.element.locator(".highlight pre").text_content() or "").replace("(0.5)", "(0.25)"))
    cell.run(2)
    assert "counter = 8" in cell.ends("done: 8 ticks", 120_000)
    tab.goto(f"{address}docs/slides/ros1.html?slides")
    tab.get_by_role("button", name="Next").click()
    assert not wrong
