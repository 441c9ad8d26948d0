"""Listings in C++ in the page: their programs, which were compiled with it, run without Python."""

from __future__ import annotations

import gzip
import re
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from listings_in_page import Cell
from playwright.sync_api import BrowserContext, Page, expect
from tree import EXAMPLES

from rosspin import simulate
from rosspin.measures import describe_timeline

pytestmark = pytest.mark.shares(4)

CPP = "div.live.highlight-cpp"
TIMER = {
    "docs/tutorial.html?lang=cpp": "my_robotics_pkg/src/spinner_cpp_node.cpp",
    "docs/ros2/tutorial.html?lang=cpp": "my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp",
}
COLOURS = re.compile(r"\x1b\[[\d;]*m")


def console(name: str, seconds: float, args: str = "") -> str:
    return COLOURS.sub("", simulate(EXAMPLES / name, seconds, args.split()).console)


@pytest.mark.parametrize("address_of_page", TIMER)
def test_the_first_click_loads_at_most_150_kb_and_no_python(
    context: BrowserContext, address: str, site: Path, address_of_page: str
) -> None:
    """Gzipped, as servers send it."""
    page = context.new_page()
    page.goto(address + address_of_page)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url) if request.url.startswith(address) else None)
    cell = Cell(page, 0, CPP)
    cell.run(2)
    name = TIMER[address_of_page]
    assert cell.ends("done: 4 ticks") == console(name, 2)
    files = {site / urlsplit(url).path.lstrip("/") for url in asked}
    assert {file.name.split(".")[-1] for file in files} == {"js", "html", "gz"}
    assert not {"worker.js", "snapshot.gz"} & {file.name for file in files}
    assert sum(len(gzip.compress(file.read_bytes())) for file in files) <= 150_000
    ticks = simulate(EXAMPLES / name, 2).ticks
    expect(cell.plot).to_have_attribute("aria-label", f"Timeline. {describe_timeline(ticks[0].source, ticks)}")
    cell.element.get_by_role("slider").press("ArrowRight")
    assert ["counter = 1" in line for line in cell.marked()] == [True]


def test_without_jspi(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.add_init_script("delete WebAssembly.Suspending")
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, CPP)
    cell.run(2)
    assert "counter = 4" in cell.ends("done: 4 ticks")


def test_stop_reset_and_again(page: Page, address: str) -> None:
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, CPP)
    cell.run(1000, "real time")
    expect(cell.console).to_contain_text("counter = 2")
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")
    cell.button("Reset").click()
    expect(cell.console).to_be_hidden()
    cell.run(1, "10 times as fast")
    assert "counter = 2" in cell.ends("done: 2 ticks")


def test_arguments_reach_a_node(page: Page, address: str) -> None:
    page.goto(f"{address}docs/publish.html?lang=cpp")
    cell = Cell(page, 0, f"{CPP}:has([aria-label='Run eager_cpp_node.cpp'])")
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_have_attribute("placeholder", "_frequency:=5")
    field.fill("_latch:=true")
    cell.run(2)
    assert cell.ends("done") == console("topics/eager_cpp_node.cpp", 2, "_latch:=true")
    field.fill("'_latch:=true")
    cell.run(2)
    assert cell.ends("error") == "arguments: no closing quotation\n"


def test_a_program_that_is_another_one_is_not_run(context: BrowserContext, address: str) -> None:
    context.route("**/programs/*", lambda route: route.fulfill(body=b"\0asm"))
    page = context.new_page()
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, CPP)
    cell.run(2)
    assert "is not the one that belongs to this page" in cell.ends("error")


# --- changed by the reader ------------------------------------------------------------------------------------------

PERIOD = "timer_delta_t_in_seconds = 0.5;"


def test_a_change_is_compiled_here(page: Page, address: str, tmp_path: Path) -> None:
    """The compiler is kept, after its size was said; what it says is shown in the listing; a link carries a text."""
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, CPP)
    file = EXAMPLES / TIMER["docs/tutorial.html?lang=cpp"]
    text = file.read_text(encoding="utf-8")
    assert PERIOD in text
    cell.button("Edit").click()
    expect(cell.status).to_contain_text("loads clang once: about 40 MB")
    faster = text.replace(PERIOD, PERIOD.replace("0.5", "0.25"))
    cell.write(faster)
    cell.run(1)
    node = tmp_path / "spinner_cpp_node.cpp"
    node.write_text(faster, encoding="utf-8")
    assert cell.ends("done: 4 ticks", 120_000) == COLOURS.sub("", simulate(node, 1).console)

    cell.write(text.replace(PERIOD, PERIOD.replace(";", "")))
    cell.run(1)
    said = cell.ends("error", 60_000)
    (line,) = [number for number, each in enumerate(text.splitlines(), 1) if PERIOD in each]
    assert f"spinner_cpp_node.cpp:{line}:" in said and "A ; is missing" in said
    expect(cell.element.locator(".live-fault")).to_have_text(re.compile(rf"{line}:\d+: expected ';'"))

    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell.write(faster)
    cell.button("Copy link").click()
    cell.ends("the link is copied")
    other = page.context.new_page()
    asked: list[str] = []
    other.on("request", lambda request: asked.append(request.url))
    other.goto(page.evaluate("navigator.clipboard.readText()"))
    received = Cell(other, 0, CPP)
    expect(received.element.locator(".highlight pre")).to_have_text(faster)
    received.run(1)
    assert "counter = 4" in received.ends("done: 4 ticks", 120_000)
    assert not [url for url in asked if "/clang/" in url and url.endswith(".gz")]
