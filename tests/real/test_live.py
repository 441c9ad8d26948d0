"""The listings that run in the page: run, edited, stopped and reset in Chromium, with the keyboard alone, too."""

from __future__ import annotations

import gzip
import hashlib
import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Literal
from urllib.parse import parse_qs, urlsplit

import pytest
import yaml
from answers import CELLS, NOTEBOOKS, NUMBERS, ON_PAGE, answer_in
from listings_in_page import (
    LISTINGS,
    RATE,
    TIMER,
    TUTORIAL,
    Cell,
    _fragment,
    have_workers,
    lines_of,
    link,
    node,
    node2,
    open_tutorial,
)
from looks import FAINT, PATIENCE, TOO_WIDE, faults
from notebook_nodes import NODES
from playwright.sync_api import Browser, BrowserContext, Page, Response, Route, expect
from tree import ROOT

from rosspin import simulate
from rosspin.exercises import EXERCISES, check
from rosspin.measures import describe_timeline
from rosspin.site.live import plot, policy

EXAMPLES = ROOT / "examples"

ROS2 = [
    EXAMPLES / "my_robotics_pkg_ros2" / "my_robotics_pkg" / f"spinner_{name}py_node.py"
    for name in ("", "rate_", "param_")
]


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    """A reader who comes for the first time."""
    with browser.new_context(viewport={"width": 1280, "height": 900}) as context:
        context.set_default_timeout(PATIENCE)
        yield context


@pytest.fixture(scope="module")
def opened(browser: Browser, address: str) -> Iterator[tuple[Page, list[str]]]:
    """The tutorial, and what went wrong in it. It stays open, so that Python need not start for each test."""
    with browser.new_context(viewport={"width": 1280, "height": 900}) as context:
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        wrong = faults(page, address)
        open_tutorial(page, address)
        yield page, wrong


@pytest.fixture
def page(opened: tuple[Page, list[str]]) -> Iterator[Page]:
    """The tutorial with its Python tabs open and its cells as at first; nothing may go wrong in it."""
    page, wrong = opened
    for index in range(len(LISTINGS)):
        Cell(page, index).button("Reset").dispatch_event("click")
    yield page
    assert not wrong


# --- before it is touched ---------------------------------------------------------------------------------------------


def test_listing_costs_two_small_requests_until_it_is_touched(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    found: list[Response] = []
    page.on("response", lambda response: found.append(response))
    page.goto(address + TUTORIAL, wait_until="networkidle")
    ours = {response.url: len(response.body()) for response in found if "/live/" in response.url}
    assert 1 <= len(ours) <= 2
    assert sum(ours.values()) < 20_000


def test_pages_without_such_a_listing_load_nothing(site: Path) -> None:
    text = (site / "index.html").read_text(encoding="utf-8")
    assert "live/live" not in text


@pytest.mark.parametrize(("language", "shown"), [("python", True), ("cpp", False)])
def test_the_language_is_asked_and_remembered(
    context: BrowserContext, address: str, language: str, shown: bool
) -> None:
    """A link on the first page chooses it, for each later page too; where the text says Run, there is one."""
    page = context.new_page()
    page.goto(address)
    page.locator(f"article a[href$='lang={language}']").click()
    words, run = page.get_by_text("You can run the Python listings on this page"), Cell(page, 0).button("Run")
    expect(words).to_be_visible(visible=shown)
    expect(run).to_be_visible(visible=shown)
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    expect(Cell(page, 1).button("Run")).to_be_visible(visible=shown)


@pytest.mark.parametrize(("edition", "number"), [("ROS 2 in Python", 0), ("ROS 1 in Python", 1)])
def test_the_edition_is_asked_and_remembered(context: BrowserContext, address: str, edition: str, number: int) -> None:
    """A link on the first page chooses the ROS, for the tabs of each later page."""
    page = context.new_page()
    page.goto(address + "index.html")
    page.get_by_role("link", name=edition, exact=True).click()
    page.wait_for_url(re.compile(r"tutorial\.html\?ros="))
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    for listing in (0, 1):
        expect(Cell(page, listing).button("Run")).to_be_visible(visible=listing == number)


def test_choosing_a_language_at_the_top_shows_listings_with_run(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(address + TUTORIAL)
    expect(Cell(page, 0).button("Run")).to_be_hidden()
    page.locator(".sd-tab-set").first.locator(".sd-tab-label", has_text="Python").click()
    for index in range(len(LISTINGS)):
        expect(Cell(page, index).button("Run")).to_be_visible()


def test_listing_is_the_file(page: Page) -> None:
    shown = page.locator("div.live > .highlight > pre").evaluate_all("found => found.map(pre => pre.textContent)")
    assert shown == [(EXAMPLES / name).read_text(encoding="utf-8") for name in LISTINGS]


# --- run --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("index", range(len(LISTINGS)))
def test_run(page: Page, index: int) -> None:
    """The page prints what the same file prints in simulated time elsewhere, and draws its ticks."""
    cell = Cell(page, index)
    cell.run(2)
    run = simulate(EXAMPLES / LISTINGS[index], 2)
    assert cell.ends("done") == run.console
    if run.ticks:
        expect(cell.status).to_have_text(f"done: {len(run.ticks)} ticks")
        expect(cell.plot).to_have_attribute("aria-label", re.compile(f"{run.ticks[0].source}: {len(run.ticks)} ticks"))
    else:
        expect(cell.plot).to_have_count(0)


def test_run_in_real_time(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.status.evaluate(
        """status => {
            window.said = []
            new MutationObserver(() => said.push(status.textContent)).observe(status, { childList: true })
        }"""
    )
    cell.run(1.5, "real time")
    assert cell.ends("done") == simulate(EXAMPLES / LISTINGS[TIMER], 1.5).console
    assert page.evaluate("said.includes('running')")
    ticks = cell.plot.locator("circle")
    expect(ticks).to_have_count(3)


def test_two_at_once(page: Page) -> None:
    cells = [Cell(page, TIMER), Cell(page, RATE)]
    for cell in cells:
        cell.run(3, "real time")
    for cell, index in zip(cells, (TIMER, RATE), strict=True):
        assert cell.ends("done") == simulate(EXAMPLES / LISTINGS[index], 3).console


def test_bad_seconds(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.run(1)
    assert cell.ends("done")
    cell.run(-1)
    assert cell.ends("error: seconds") == ""
    cell.button("Reset").click()
    expect(cell.element.get_by_role("spinbutton")).to_have_value("10")


# --- how Python starts ------------------------------------------------------------------------------------------------


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
    page.wait_for_load_state("networkidle")
    assert not [url for url in asked if "/live/live." not in url]
    with page.expect_request(re.compile("/snapshot.gz")):
        getattr(Cell(page, TIMER).button("Run"), sign)()


def _kept(page: Page) -> list[str]:
    """Which snapshots the browser keeps."""
    keys = page.evaluate("async () => (await (await caches.open('rosspin')).keys()).map((key) => key.url)")
    return [urlsplit(url).query for url in keys]


def _until_kept(page: Page) -> None:
    """Wait for that of this site, and for no other: some time after the first run."""
    end = time.monotonic() + PATIENCE / 1e3
    while (len(kept := _kept(page)) != 1 or kept == ["old"]) and time.monotonic() < end:
        page.wait_for_timeout(50)
    assert len(kept) == 1 and kept != ["old"]


def test_snapshot_is_kept_for_the_next_page(context: BrowserContext, address: str) -> None:
    """In place of that of an earlier version of the site."""
    page = context.new_page()
    page.goto(address)
    page.evaluate("async () => (await caches.open('rosspin')).put('snapshot.gz?old', new Response('old'))")
    asked = _asked(page, "snapshot.gz")
    assert "counter = 1" in _first_run(page, address)
    assert asked
    _until_kept(page)
    page.close()
    page = context.new_page()
    asked = _asked(page, "snapshot.gz")
    assert "counter = 1" in _first_run(page, address)
    assert not asked


def test_without_a_snapshot_python_starts_plainly(context: BrowserContext, address: str) -> None:
    expected = simulate(EXAMPLES / LISTINGS[TIMER], 2).console
    context.route("**/snapshot.gz*", lambda route: route.abort())
    page = context.new_page()
    whole, snapshots = _asked(page, "python_stdlib.zip"), _asked(page, "snapshot.gz")
    assert _first_run(page, address) == expected
    assert whole
    assert _kept(page) == []
    page.close()  # its spare worker may still be starting
    context.unroute("**/snapshot.gz*")
    page = context.new_page()
    whole, snapshots = _asked(page, "python_stdlib.zip"), _asked(page, "snapshot.gz")
    assert _first_run(page, address) == expected
    assert snapshots and not whole


def test_snapshot_is_made_anew_only_when_its_inputs_change(site: Path, tmp_path: Path) -> None:
    """And its address in the pages follows it."""
    (kept,) = ROOT.glob("build/snapshot-*.gz")
    (tmp_path / kept.name).write_bytes(b"kept")
    out = tmp_path / "web" / "live"
    node: list[str | Path] = [ROOT / ".venv/bin/node", "--experimental-wasm-jspi", ROOT / "web/build.mjs"]
    subprocess.run([*node, ROOT / "build/npm", *yaml.__path__, out], check=True)
    assert (out / "snapshot.gz").read_bytes() == b"kept"
    for folder, data in ((out, b"kept"), (site / "_static/live", kept.read_bytes())):
        assert hashlib.sha256(data).hexdigest() in (folder / "runs.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("node", [EXAMPLES / LISTINGS[TIMER], ROS2[0]], ids=["ros1", "ros2"])
def test_first_click_loads_at_most_11_mb(context: BrowserContext, address: str, site: Path, node: Path) -> None:
    """Gzipped, as servers send them. ROS 2 is in the snapshot, too."""
    page = context.new_page()
    asked = _asked(page, "")
    assert "counter = 1" in _first_run(page, address, node.read_text(encoding="utf-8"))
    files = {site / urlsplit(url).path.lstrip("/") for url in asked}
    assert 7_000_000 < sum(len(gzip.compress(file.read_bytes())) for file in files) <= 11_000_000


def test_our_own_files_are_loaded_when_one_is_read(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    asked = _asked(page, "rosspin.zip")
    assert "counter = 1" in _first_run(page, address)
    assert not asked
    text = "import inspect\nimport rospy\nprint(inspect.getsource(rospy.Rate).splitlines()[0])\n"
    assert _first_run(page, address, text) == "class Rate:\n"
    assert asked


def test_module_that_is_not_in_the_snapshot(context: BrowserContext, address: str) -> None:
    text = "import sys\nprint('csv' in sys.modules)\nimport csv\nprint(csv.reader(['a,b']).__next__())\n"
    assert _first_run(context.new_page(), address, text) == "False\n['a', 'b']\n"


def test_what_is_drawn_at_random_differs(context: BrowserContext, address: str) -> None:
    text = "import random\nprint(random.random())\n"
    drawn = {_first_run(context.new_page(), address, text) for _ in range(2)}
    assert len(drawn) == 2


def test_node_finds_no_traces_of_the_snapshot(context: BrowserContext, address: str) -> None:
    """Its environment and its path are those of a plain start; nothing that made the snapshot is left in it."""
    text = "import os, sys\nprint(sorted(os.environ.items()), sys.path, sys.argv)\nprint(sorted(globals()))\n"
    found = _first_run(context.new_page(), address, text)
    context.route("**/snapshot.gz*", lambda route: route.abort())
    page = context.new_page()
    page.goto(address + TUTORIAL)
    page.evaluate("caches.delete('rosspin')")
    plain = _first_run(page, address, text)
    assert re.sub("'LANG', '.*?'", "", found) == re.sub("'LANG', '.*?'", "", plain)


# --- arguments --------------------------------------------------------------------------------------------------------


def test_arguments_are_offered_where_a_node_reads_parameters(page: Page) -> None:
    cell = Cell(page, TIMER)
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_be_hidden()
    cell.write(node("print(rospy.get_param('~frequency', 1.0), rospy.get_name())"))
    expect(field).to_be_visible()
    for words, said in {
        "": "1.0 /a_node",
        "_frequency:=5": "5 /a_node",
        "_frequency:='[1, 2]' __ns:=/mrp": "[1, 2] /mrp/a_node",
        "'_frequency:=two words'": "two words /a_node",
    }.items():
        field.fill(words)
        cell.run(1)
        assert cell.ends("done") == f"{said}\n"
    expect(field).to_have_attribute("placeholder", "_frequency:=5")
    field.fill("_frequency:='5")
    field.press("Enter")
    assert cell.ends("error") == "arguments: no closing quotation\n"
    cell.button("Reset").click()
    expect(field).to_be_hidden()
    expect(cell.element.locator(".live-arguments input")).to_have_value("")


@pytest.mark.parametrize("words", ["-p frequency:=5.0", "_frequency:=5"])
def test_words_that_ros2_does_not_read_are_named(page: Page, words: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(node2("print(node.declare_parameter('frequency', 2.0).value)"))
    cell.element.get_by_role("textbox", name="Arguments").fill(words)
    cell.run(1)
    said = "In ROS 2, what is for ROS follows --ros-args, as in: --ros-args -p frequency:=5.0"
    assert cell.ends("done") == f"2.0\n{said}\n"


@pytest.mark.parametrize(
    ("ros", "listing", "arguments"),
    [
        (1, "my_robotics_pkg/src/spinner_param_py_node.py", "_frequency:=5"),
        (2, "my_robotics_pkg_ros2/my_robotics_pkg/spinner_param_py_node.py", "--ros-args -p frequency:=5.0"),
    ],
)
def test_arguments_set_a_parameter(
    context: BrowserContext, address: str, ros: int, listing: str, arguments: str
) -> None:
    page = context.new_page()
    page.goto(f"{address}docs/how-to/frequency-from-parameter.html?lang=python&ros={ros}")
    cell = Cell(page, 2 - ros)
    cell.element.get_by_role("textbox", name="Arguments").fill(arguments)
    cell.run(1)
    assert cell.ends("done: 5 ticks") == simulate(EXAMPLES / listing, 1, arguments.split()).console


# --- plots ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("index", range(len(LISTINGS)))
def test_plot_is_there_before_the_first_run(page: Page, index: int) -> None:
    """It makes way for that of a run, and comes back."""
    cell = Cell(page, index)
    made = cell.element.locator("figure.live-made")
    ticks = simulate(EXAMPLES / LISTINGS[index], 10).ticks
    if not ticks:
        expect(made).to_have_count(0)
        return
    expect(made).to_be_visible()
    expect(made).to_contain_text("simulated when this page was made: the first 10 s")
    said = describe_timeline(ticks[0].source, ticks)
    expect(made.locator("svg[role=img]:visible")).to_have_attribute("aria-label", f"Timeline. {said}")
    cell.run(10)
    cell.ends("done")
    expect(made).to_be_hidden()
    expect(cell.plot.first).to_have_attribute("aria-label", f"Timeline. {said}")
    cell.button("Reset").click()
    expect(made).to_be_visible()


def test_the_axis_goes_to_the_end_of_the_run(page: Page) -> None:
    """Where nothing ticks any more, that is seen: in the plot that was made, and in that of a run."""
    text = node("timer = rospy.Timer(rospy.Duration(0.5), lambda event: timer.shutdown())\nrospy.spin()")
    cell = Cell(page, TIMER)
    cell.write(text)
    cell.run(10)
    cell.ends("done: 1 tick")
    assert cell.plot.locator("circle").get_attribute("cx") == "5%"
    wide, narrow = (float(x) for x in re.findall(r'<circle cx="([\d.]+)"', plot(text)))
    assert 0.05 < wide / 760 < 0.07 and 0.05 < narrow / 365 < 0.07


def test_a_finger_chooses_a_tick(browser: Browser, address: str) -> None:
    with browser.new_context(viewport={"width": 390, "height": 800}, has_touch=True, is_mobile=True) as context:
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        open_tutorial(page, address)
        cell = Cell(page, TIMER)
        cell.run(2)
        cell.ends("done")
        cell.element.get_by_role("slider").tap()
        expect(cell.element.locator(".live-tick")).to_have_text(re.compile("tick 2"))


def test_plot_of_a_listing_that_says_for_how_long() -> None:
    text = (
        "import rospy\nrospy.init_node('a')\nrospy.Timer(rospy.Duration(rospy.get_param('~p')), print)\nrospy.spin()\n"
    )
    assert "print: 4 ticks" in plot(f"%%simulate 2 -- _p:=0.5\n{text}")
    assert "the first 2 s" in plot(f"%%simulate 2 -- _p:=0.5\n{text}")
    for other in (f"%%answer 1\n{text}", "print(1)\n", "import rospy\n1 / 0\n", "while True: pass", "print("):
        assert plot(other) == ""


# What each of these nodes prints at its ticks: a timer beside another one, and a loop that works.
TWO_TIMERS = """
import rospy

def slow(event):
    print("slow begins")
    rospy.sleep(0.3)
    print("slow ends")

def fast(event):
    print("fast", "and", "more")

rospy.init_node("a_node")
print("before")
rospy.Timer(rospy.Duration(0.5), slow)
rospy.Timer(rospy.Duration(0.25), fast)
rospy.spin()
"""
LOOP = """
import rospy

rospy.init_node("a_node")
print("before")
rate = rospy.Rate(2)
while not rospy.is_shutdown():
    print("begins")
    rospy.sleep(0.1)
    print("ends")
    rate.sleep()
"""


def _marked(cell: Cell) -> list[str]:
    return cell.console.locator(".of-tick").all_text_contents()


def test_tick_leads_to_its_lines(page: Page) -> None:
    """By the arrow keys; the lines of two threads that print at the same time are told apart."""
    cell = Cell(page, TIMER)
    cell.write(TWO_TIMERS)
    cell.run(1)
    cell.ends("done")
    handle = cell.element.get_by_role("slider")
    handle.focus()
    found = {}
    for _ in range(6):
        page.keyboard.press("ArrowRight")
        found[handle.get_attribute("aria-valuetext")] = _marked(cell)
    assert found == {
        "fast, tick 1: expected 0.25 s, real 0.25 s, on time": ["fast and more\n"],
        "slow, tick 1: expected 0.5 s, real 0.5 s, on time": ["slow begins\n", "slow ends\n"],
        "fast, tick 2: expected 0.5 s, real 0.5 s, on time": ["fast and more\n"],
        "fast, tick 3: expected 0.75 s, real 0.75 s, on time": ["fast and more\n"],
        "slow, tick 2: expected 1 s, real 1 s, on time": ["slow begins\n", "slow ends\n"],
        "fast, tick 4: expected 1 s, real 1 s, on time": ["fast and more\n"],
    }
    page.keyboard.press("Home")
    expect(handle).to_have_attribute("aria-valuenow", "1")
    page.keyboard.press("End")
    expect(handle).to_have_attribute("aria-valuenow", "6")
    page.keyboard.press("Tab")
    assert _marked(cell) == []


LOOP_OF_ROS2 = """
import threading
import time

import rclpy

rclpy.init()
node = rclpy.create_node("a_node")

def loop():
    print("before")
    rate = node.create_rate(2)
    while rclpy.ok():
        print("begins")
        time.sleep(0.1)
        print("ends")
        rate.sleep()

threading.Thread(target=loop, daemon=True).start()
rclpy.spin(node)
"""


@pytest.mark.parametrize("loop", [LOOP, LOOP_OF_ROS2], ids=["ROS 1", "ROS 2"])
def test_pass_of_a_loop_leads_to_its_lines(page: Page, loop: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(loop)
    cell.run(1.2)
    cell.ends("done")
    cell.element.get_by_role("slider").press("ArrowRight")
    assert _marked(cell) == ["begins\n", "ends\n"]


def test_pointing_at_a_tick(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.write((EXAMPLES / LISTINGS[TIMER]).read_text(encoding="utf-8").replace("0.5", "0.4"))
    cell.run(2)
    cell.ends("done: 5 ticks")
    mark = cell.plot.locator("g circle").nth(2).bounding_box()
    assert mark
    page.mouse.move(mark["x"] + mark["width"] / 2 + 1, mark["y"] + mark["height"] / 2)
    expect(cell.element.locator(".live-tick")).to_have_text(
        "timerCallback, tick 3: expected 1.2 s, real 1.2 s, on time"
    )
    assert _marked(cell) == ["[INFO] [1.200000]: [SPINNER PY NODE] counter = 3\n"]
    page.mouse.move(0, 0)
    assert _marked(cell) == []


@pytest.mark.parametrize(
    ("body", "named", "line"),
    [
        ("\n\nraise KeyError('mine')", 'File "spinner_py_node.py", line 6', 6),
        ("while True: pass", "spinner_py_node.py:4", 4),
        ("rospy.Service", "spinner_py_node.py:4", 4),
    ],
)
def test_error_leads_to_its_line(page: Page, body: str, named: str, line: int) -> None:
    cell = Cell(page, TIMER)
    cell.write(node(body))
    cell.run(1)
    cell.ends("error")
    cell.console.get_by_role("button", name=named).first.click()
    expect(cell.editor).to_be_focused()
    assert page.evaluate("getSelection().toString()") == node(body).splitlines()[line - 1]


@pytest.mark.parametrize(
    ("log", "level"),
    [
        ("rospy.logwarn", "WARN"),
        ("rospy.logerr", "ERROR"),
        ("rospy.logfatal", "FATAL"),
        ("node.get_logger().warning", "WARN"),
        ("node.get_logger().error", "ERROR"),
        ("node.get_logger().fatal", "FATAL"),
    ],
)
def test_logged_line_leads_to_its_call(page: Page, log: str, level: str) -> None:
    """Also from a timer's callback, which the stand-in calls. A line that is no warning leads nowhere."""
    cell = Cell(page, TIMER)
    call = f"    {log}('late\\nvery')"
    if log.startswith("rospy"):
        text = node(
            f"def tick(event):\n{call}\nrospy.Timer(rospy.Duration(1), tick)\nrospy.loginfo('fine')\nrospy.spin()"
        )
    else:
        text = node2(
            f"def tick():\n{call}\nnode.create_timer(1, tick)\nnode.get_logger().info('fine')\nrclpy.spin(node)"
        )
    cell.write(text)
    cell.run(1)
    assert "late\nvery\n" in cell.ends("done")
    (line,) = cell.console.locator(".stderr", has_text="late").all()
    expect(cell.console.locator("span", has_text="fine").get_by_role("button")).to_have_count(0)
    button = line.get_by_role("button")
    expect(button).to_have_text(f"[{level}]")
    button.click()
    expect(cell.editor).to_be_focused()
    assert page.evaluate("getSelection().toString()") == call


# --- nodes of ROS 2 ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", ROS2, ids=lambda path: path.stem)
def test_node_of_ros2(page: Page, path: Path) -> None:
    """It is as good as one of ROS 1; INFO lines, which ROS 2 puts on stderr, do not look like errors."""
    cell = Cell(page, TIMER)
    cell.write(path.read_text(encoding="utf-8"))
    cell.run(2)
    run = simulate(path, 2)
    assert cell.ends(f"done: {len(run.ticks)} ticks$") == run.console
    expect(cell.plot).to_have_attribute("aria-label", f"Timeline. {describe_timeline(run.ticks[0].source, run.ticks)}")
    expect(cell.console.locator(".stderr")).to_have_count(0)
    cell.element.get_by_role("slider").press("ArrowRight")
    assert [line[-12:] for line in _marked(cell)] == ["counter = 1\n"]
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_be_visible(visible=path.stem.startswith("spinner_param"))


def test_arguments_set_a_parameter_of_ros2(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.write(ROS2[2].read_text(encoding="utf-8"))
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_have_attribute("placeholder", "--ros-args -p frequency:=5.0")
    field.fill("--ros-args -p frequency:=5.0 -r __ns:=/mrp")
    cell.run(1)
    args = ["--ros-args", "-p", "frequency:=5.0", "-r", "__ns:=/mrp"]
    assert cell.ends("done: 5 ticks") == simulate(ROS2[2], 1, args).console
    field.fill("--ros-args -p frequency:=5")
    cell.run(1)
    assert "5 is an integer, 5.0 is not." in cell.ends("error")


@pytest.mark.parametrize(
    ("body", "status", "sentence"),
    [
        ("import rclpy.action", "error", "On a computer with ROS 2, run: python -m rosspin run --ros2 FILE"),
        ("from std_srvs.srv import Empty", "error", "std_srvs is not simulated"),
        ("import curses", "error", "Python has no curses in a page"),
        ("import numpy", "error", "stand-ins for rospy and rclpy, and Python's standard library, but no numpy"),
        ("node.create_timer(0.5, print)", "done$", "never called. Is rclpy.spin(node) missing"),
        (
            "node.create_timer(0.5, lambda event: 1)\nrclpy.spin(node)",
            "error",
            "A timer passes its callback no argument",
        ),
        ("node.create_timer(0.5, print)\nrclpy.spin(node)", "done: 4 ticks, ended by Ctrl-C", "KeyboardInterrupt"),
        ("while rclpy.ok(): pass", "error", "Sleep in every loop (rate.sleep(), time.sleep(0.1))"),
        (
            "import threading, time\nwhile True: threading.Thread(target=time.sleep, args=[1]).start()",
            "error",
            "node.py:5: simulated time stands still at 0.0 s, because 1,000 threads have not ended",
        ),
    ],
)
def test_errors_of_ros2_end_in_a_sentence_that_helps(page: Page, body: str, status: str, sentence: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(node2(body))
    cell.run(2)
    console = cell.ends(status)
    assert sentence in console
    assert "rosspin/" not in console and "pyodide" not in console


LOOP_IN_MAIN = "rate = node.create_rate(2)\nwhile rclpy.ok():\n    rate.sleep()"
SPIN = "import threading\nthreading.Thread(target=rclpy.spin, args=[node], daemon=True).start()\n"


@pytest.mark.parametrize(("spin", "ticks"), [("", "1 tick"), (SPIN, "4 ticks|5 ticks")])
def test_rate_that_nobody_wakes(page: Page, spin: str, ticks: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(node2(spin + LOOP_IN_MAIN))
    cell.run(2)
    console = cell.ends(f"done: ({ticks}), ended by Ctrl-C")
    assert ("another one has to spin the node" in console) == (not spin)


@pytest.mark.parametrize("seconds", [0.4, 2])
def test_nobody_is_told_to_spin_who_does(page: Page, seconds: float) -> None:
    cell = Cell(page, TIMER)
    cell.run(seconds)
    assert "missing" not in cell.ends("done")


# --- links and copies -------------------------------------------------------------------------------------------------


def _copied(page: Page) -> str:
    text: str = page.evaluate("navigator.clipboard.readText()")
    return text


def _late(route: Route) -> None:
    """For a script after the listings' own, until whose end the tabs stay closed."""
    time.sleep(1)
    route.continue_()


def test_a_link_carries_the_code(page: Page, address: str) -> None:
    """It opens with a notice, does not run, and leaves alone what the reader has written."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell = Cell(page, TIMER)
    code = node("print(rospy.get_param('~word'), '<b>ä</b>')")
    cell.write(code)
    cell.element.get_by_role("textbox", name="Arguments").fill("_word:=shared")
    cell.element.get_by_role("spinbutton").fill("3")
    cell.button("Share").click()
    expect(cell.status).to_have_text("the link is copied; the code is in it")
    copied = _copied(page)
    mine = node("print('mine')")
    cell.write(mine)

    other = page.context.new_page()
    wrong = faults(other, address)
    other.route("**/handles.js*", _late)
    other.goto(copied)
    opened = Cell(other, TIMER)
    expect(opened.element.locator(".live-notice")).to_contain_text("This code came with the link")
    expect(opened.element.locator(".live-notice")).to_be_in_viewport()
    assert opened.element.locator("pre").first.text_content() == code
    expect(opened.status).to_have_text("as it came with the link")
    other.wait_for_timeout(500)
    assert opened.text() == ""
    expect(opened.element.get_by_role("spinbutton")).to_have_value("3")
    opened.element.get_by_role("combobox").select_option("instantly")
    opened.button("Run").click()
    assert opened.ends("done") == "shared <b>ä</b>\n"
    opened.write("print('theirs')")
    opened.button("Reset").click()
    expect(opened.element.locator(".live-notice")).to_be_hidden()
    assert "#" not in other.url
    other.reload()
    assert opened.element.locator("pre").first.text_content() == mine
    assert not wrong
    other.close()


@pytest.mark.parametrize(
    ("tabs", "query"), [(["ROS 2"], {"ros": ["2"]}), (["ROS 1", "Python"], {"ros": ["1"], "lang": ["python"]})]
)
def test_a_link_chooses_the_tabs_of_its_listing(
    context: BrowserContext, address: str, tabs: list[str], query: dict[str, list[str]]
) -> None:
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    page.goto(address + "docs/how-to/frequency-from-parameter.html")
    for tab in tabs:
        page.locator(".sd-tab-label", has_text=tab).locator("visible=true").first.click()
    cell = Cell(page, len(tabs) - 1)
    cell.button("Share").click()
    expect(cell.status).to_have_text("the link is copied; the code is in it")
    assert parse_qs(urlsplit(_copied(page)).query) == query


@pytest.mark.parametrize(
    ("fragment", "said"),
    [
        ("#code=", "cannot be read"),
        ("#code=%%%", "cannot be read"),
        ("#code=AAAA", "cannot be read"),
        (link()[:-6], "cannot be read"),
        (_fragment(b"[]"), "cannot be read"),
        (_fragment(b"null"), "cannot be read"),
        (_fragment(b"{"), "cannot be read"),
        (link(text=5), "cannot be read"),
        (link(seconds="2"), "cannot be read"),
        (link(seconds=-1), "cannot be read"),
        (link(args=["a"]), "cannot be read"),
        (link(cell="0"), "cannot be read"),
        (link(cell=99), "no longer has"),
        (link(cell=-1), "no longer has"),
        (link(text="x" * 1_000_000), "too long"),
        ("#code=" + "A" * 1_000_000, "too long"),
    ],
    ids=lambda value: value[:20],
)
def test_a_broken_link_does_nothing_but_say_so(page: Page, address: str, fragment: str, said: str) -> None:
    other = page.context.new_page()
    wrong = faults(other, address)
    other.goto(address + TUTORIAL + fragment)
    expect(other.get_by_role("alert").filter(has_text="link")).to_contain_text(said)
    for index, name in enumerate(LISTINGS):
        shown = other.locator("div.live > .highlight > pre").nth(index).text_content()
        assert shown == (EXAMPLES / name).read_text(encoding="utf-8")
    assert not wrong
    other.close()


def test_html_in_a_link_is_text(page: Page, address: str) -> None:
    html = "<script>document.title = 'taken'</script><img src=x onerror=\"document.title = 'taken'\">"
    other = page.context.new_page()
    wrong = faults(other, address)
    other.goto(address + TUTORIAL + link(text=html, args=html))
    cell = Cell(other, TIMER)
    expect(cell.element.locator("pre").first).to_have_text(html)
    assert other.title() != "taken" and cell.element.locator("img, script").count() == 0
    assert not wrong
    other.close()


@pytest.mark.parametrize(
    "listing", [*[EXAMPLES / LISTINGS[index] for index in (TIMER, RATE)], *ROS2[:2]], ids=lambda path: path.parts[-3]
)
def test_run_is_copied_as_a_test(page: Page, listing: Path, tmp_path: Path) -> None:
    """It passes as it is, and fails when the period is changed."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell = Cell(page, TIMER)
    cell.write(listing.read_text(encoding="utf-8"))
    expect(cell.button("Copy as test")).to_be_hidden()
    cell.run(2)
    cell.ends("done")
    cell.button("Copy as test").click()
    expect(cell.status).to_have_text("the test is copied: save it in a file for pytest")
    text = _copied(page)
    path = tmp_path / "test_copied.py"
    for period, outcome in {"as it is": 0, "changed": 1}.items():
        path.write_text(text if period == "as it is" else _with_another_period(text), encoding="utf-8")
        run = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", path], capture_output=True
        )
        assert run.returncode == outcome, run.stdout.decode()


def _with_another_period(text: str) -> str:
    changed = re.sub(r"(timer_delta_t_in_seconds|loop_frequency_in_hz) = [\d.]+", r"\1 = 0.25", text)
    assert changed != text
    return changed


def test_run_with_an_error_is_no_test(page: Page) -> None:
    cell = Cell(page, TIMER)
    for body in ("1 / 0", "rospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)\nrospy.spin()", "print('x' * 60_000)"):
        cell.write(node(body))
        cell.run(1)
        cell.ends("done|error")
        expect(cell.button("Copy as test")).to_be_hidden()


# --- edit -------------------------------------------------------------------------------------------------------------


def test_edit(page: Page, address: str) -> None:
    """The reader changes 0.5 to 0.1. The edit survives a reload, Copy copies it, Reset brings the original back."""
    cell = Cell(page, TIMER)
    original = (EXAMPLES / LISTINGS[TIMER]).read_text(encoding="utf-8")
    edited = original.replace("0.5", "0.1")
    cell.write(edited)
    cell.element.get_by_role("spinbutton").fill("1")
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.editor.press("Control+Enter")
    assert cell.ends("done: 10 ticks").count("counter = ") == 10

    open_tutorial(page, address)
    assert cell.element.locator("pre").first.text_content() == edited
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    cell.element.locator("pre").first.hover()
    cell.element.locator("button.copybtn").click()
    assert page.evaluate("navigator.clipboard.readText()") == edited.rstrip("\n")
    other = Cell(page, 0)
    assert other.element.locator("pre").first.text_content() == original

    cell.button("Reset").click()
    assert cell.element.locator("pre").first.text_content() == original
    expect(cell.element.locator("pre .k").first).to_be_visible()
    open_tutorial(page, address)
    assert cell.element.locator("pre").first.text_content() == original


def test_keyboard_alone(page: Page) -> None:
    """From the heading by Tab into the cell; Enter, Escape, Tab and Ctrl-Enter do the rest."""
    cell = Cell(page, TIMER)
    cell.element.get_by_role("spinbutton").fill("1000")
    cell.element.get_by_role("combobox").select_option("real time")
    cell.button("Run").focus()
    for name in ("Stop", "Edit"):
        page.keyboard.press("Tab")
        expect(cell.button(name)).to_be_focused()
    page.keyboard.press("Enter")
    expect(cell.editor).to_be_focused()
    page.keyboard.press("Control+End")
    page.keyboard.type("# mine")
    page.keyboard.press("Tab")
    expect(cell.editor).to_be_focused()
    page.keyboard.press("Control+Enter")
    expect(cell.status).to_have_text(re.compile("^starting Python|^running"))
    page.keyboard.press("Escape")
    expect(cell.button("Run")).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    cell.ends("stopped")
    for _ in range(2):
        page.keyboard.press("Tab")
    expect(cell.button("Reset")).to_be_focused()
    page.keyboard.press("Enter")
    expect(cell.editor).to_have_count(0)
    expect(cell.button("Reset")).to_be_focused()


# --- cells of notebooks -----------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pages_of_exercises(browser: Browser, address: str) -> Iterator[dict[int, Page]]:
    """The page of exercises on each ROS; nothing may go wrong in them."""
    with browser.new_context(viewport={"width": 1280, "height": 900}) as context:
        context.set_default_timeout(PATIENCE)
        pages = {ros: context.new_page() for ros in NOTEBOOKS}
        wrong = [faults(page, address) for page in pages.values()]
        for ros, page in pages.items():
            page.goto(f"{address}notebooks/{NOTEBOOKS[ros].stem}.html")
        yield pages
        assert not any(wrong)


@pytest.fixture
def exercises(pages_of_exercises: dict[int, Page]) -> Page:
    """The page of those on ROS 1."""
    return pages_of_exercises[1]


def exercise(page: Page, number: int) -> Cell:
    """The cell of an exercise: one before the 2nd, and one before the first on ROS 2, is no exercise."""
    return Cell(page, {1: 0}.get(number, number) if number in ON_PAGE[1] else number - ON_PAGE[2][0] + 1)


@pytest.mark.parametrize("number", NUMBERS)
def test_exercise_is_checked(pages_of_exercises: dict[int, Page], number: int) -> None:
    """The page says of an answer what a notebook says of it."""
    cell = exercise(pages_of_exercises[EXERCISES[number - 1].ros], number)
    for answer, status in zip(CELLS[number], ("not yet", "right"), strict=True):
        if status == "right":
            cell.write(answer.source)
        cell.button("Run").click()
        said = cell.ends(f"Exercise {number}: {status}.")
        feedback = check(number, f"\n{answer_in(answer)}")
        console = feedback.console
        words = str(feedback).replace("`", "")
        assert lines_of(said) == lines_of((f"{console}\n" if console else "") + f"{words}\n")
    expect(cell.element.get_by_role("spinbutton")).to_have_count(0)


def test_the_page_is_interrupted_within_runs_only() -> None:
    """A check runs an answer several times; an interrupt in between, for the watchdog, must not end it."""
    code = """
import signal, sys
from unittest.mock import MagicMock
sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
import rosspin.page
assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
"""
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("ros", NOTEBOOKS)
def test_what_was_solved_is_kept(pages_of_exercises: dict[int, Page], ros: int) -> None:
    """Told after each right answer, and known when the reader comes back."""
    page, numbers = pages_of_exercises[ros], ON_PAGE[ros]
    cell = exercise(page, numbers[0])
    cell.write(CELLS[numbers[0]][1].source)
    cell.button("Run").click()
    cell.ends(rf"Exercise {numbers[0]}: right\. You have solved \d+ of {len(numbers)}\.")
    page.reload()
    expect(cell.status).to_have_text("solved, as you edited it")
    made = page.locator(f".cell:has([aria-label='Run answer {numbers[0]}']) > .cell_output")
    expect(made).to_be_hidden()  # it is about the text that came with the page
    said = page.locator("article .live-progress").text_content() or ""
    assert re.fullmatch(rf"[1-9]\d* of {len(numbers)} solved", said)
    assert beside_its_link(page, ros) == said
    cell.button("Reset").click()
    expect(cell.status).to_have_text("an earlier version was solved")
    expect(made).to_be_visible()


def test_each_page_of_exercises_counts_its_own(pages_of_exercises: dict[int, Page], address: str) -> None:
    """A page that runs nodes shows both counts in its sidebar."""
    for ros, page in pages_of_exercises.items():
        cell = exercise(page, ON_PAGE[ros][0])
        cell.write(CELLS[ON_PAGE[ros][0]][1].source)
        cell.button("Run").click()
        cell.ends(f"Exercise {ON_PAGE[ros][0]}: right")
    page = pages_of_exercises[1].context.new_page()
    page.goto(address + "docs/tutorial.html")
    for ros, numbers in ON_PAGE.items():
        assert beside_its_link(page, ros).endswith(f" of {len(numbers)} solved")
    expect(page.locator(".live-progress")).to_have_count(2)
    page.close()


def beside_its_link(page: Page, ros: int) -> str:
    """What the sidebar, where ROS 2 comes first, says beside the link to a page of exercises."""
    links = page.locator(".bd-docs-nav a").filter(has_text=re.compile("^Exercises$"))
    return links.nth(2 - ros).locator("xpath=following-sibling::*[1]").text_content() or ""


def test_hints_are_asked_for_one_at_a_time(exercises: Page) -> None:
    hints = exercises.locator("section#fire-once details:has(> summary:text('Hint'))")
    shown = [hints.nth(number).locator("p").first for number in range(hints.count())]
    assert len(shown) >= 3
    for number in range(len(shown)):
        for later in shown[number:]:
            expect(later).to_be_hidden()
        hints.nth(number).locator("summary").press("Enter")
        expect(shown[number]).to_be_visible()


def test_answer_has_its_first_line(exercises: Page) -> None:
    cell = exercise(exercises, 1)
    for first in ("%%answer 2", "%%answer", "# mine", ""):
        cell.write(f"{first}\nimport rospy\n")
        cell.button("Run").click()
        assert cell.ends("error: the first line must be %%answer 1") == ""
    cell.button("Reset").click()


def test_verdict_leads_to_the_line_that_it_names(exercises: Page) -> None:
    cell = exercise(exercises, 6)
    cell.write("%%answer 6\nimport rospy\nrospy.init_node('a_node')\n1 / 0\n")
    cell.button("Run").click()
    cell.ends("Exercise 6: not yet")
    for place in ('"<answer>", line 4', "in line 4"):
        cell.console.get_by_role("button", name=place).first.click()
        expect(cell.editor).to_be_focused()
        assert exercises.evaluate("getSelection().toString()") == "1 / 0"
        cell.editor.press("Control+Home")
    cell.button("Reset").click()


@pytest.mark.parametrize(
    ("first", "said"),
    [
        ("%%answer 99", "there is no exercise 99"),
        ("%%answer", "the first line can be %%simulate SECONDS or %%answer NUMBER"),
        ("%%answer x", "the first line can be %%simulate SECONDS or %%answer NUMBER"),
        ("%%simulate 1.2.3", "the first line can be %%simulate SECONDS or %%answer NUMBER"),
        ("%%measure 2", "the first line can be %%simulate SECONDS or %%answer NUMBER"),
        ("%%simulate nan", "seconds must be a number of at least 0, not nan"),
    ],
)
def test_first_line_that_cannot_be(page: Page, first: str, said: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(f"{first}\nimport rospy\n")
    cell.run(1)
    assert said in cell.ends("error")


def test_ticks_at_the_same_time_are_drawn_apart(exercises: Page) -> None:
    """The plot of the blocking node shows both ticks at 2.2 s."""
    cell = Cell(exercises, 1)
    cell.write((cell.element.locator("pre").first.text_content() or "").replace("0.6", "1.0"))
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.button("Run").click()
    cell.ends("done: 7 ticks")
    places = cell.plot.locator("circle").evaluate_all(
        "all => all.map(c => c.getAttribute('cx') + ' ' + c.getAttribute('cy'))"
    )
    assert len(set(places)) == 7
    assert len({place.split()[0] for place in places}) == 6
    expect(cell.element.locator("figure:not(.live-made) figcaption")).to_contain_text("simulated")
    cell.button("Reset").click()


@pytest.mark.parametrize("notebook", NODES)
def test_simulated_cell(context: BrowserContext, address: str, notebook: str) -> None:
    """It runs for the seconds in its first line, and what it printed when the site was built makes way."""
    page = context.new_page()
    page.goto(f"{address}notebooks/{notebook}.html")
    cell, output = Cell(page, 0), page.locator("div.cell:has(div.live) > .cell_output").first
    cell.element.get_by_role("combobox").select_option("instantly")
    cell.button("Run").click()
    text = cell.element.locator("pre").first.text_content() or ""
    run = simulate(EXAMPLES / NODES[notebook], 2.0)
    assert text.startswith("%%simulate 2.0")
    assert cell.ends(f"done: {len(run.ticks)} ticks") == run.console
    expect(output).to_be_hidden()
    cell.button("Reset").click()
    expect(output).to_be_visible()


# --- stop -------------------------------------------------------------------------------------------------------------


def test_stop_ends_a_busy_loop_and_the_next_run_starts(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.write("print('busy')\nsum(iter(int, 1))\n")  # which no watchdog can interrupt
    cell.run(2)
    expect(cell.console).to_contain_text("busy")
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")
    cell.write("print('next')\n")
    cell.button("Run").click()
    assert cell.ends("done") == "next\n"


def test_stop_in_real_time(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.run(1000, "real time")
    expect(cell.plot.locator("circle")).not_to_have_count(0)
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")
    before = cell.text()
    page.wait_for_timeout(700)
    assert cell.text() == before
    handle = cell.element.get_by_role("slider")
    handle.press("Home")
    said = "timerCallback, tick 1: expected 0.5 s, real 0.5 s, on time"
    expect(handle).to_have_attribute("aria-valuetext", re.compile(said))


# --- what goes wrong --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("line", ["while True:\n    print('flood')", "while True:\n    rospy.loginfo('flood')"])
def test_flood(page: Page, line: str) -> None:
    """The page answers all the while, keeps the last lines only, and the run comes to its end."""
    cell = Cell(page, TIMER)
    cell.write(node(line))
    cell.run(2)
    expect(cell.console).to_contain_text("earlier lines are left out")
    assert page.evaluate("1 + 1") == 2
    assert "simulated time stands still at 0.0 s" in cell.ends("error")
    assert cell.text().count("\n") <= 1000


@pytest.mark.parametrize(
    ("code", "status", "sentence"),
    [
        (node("rospy.Rate(0)"), "error: see", "Nothing can have a frequency of 0 Hz"),
        (
            node("rospy.Timer(rospy.Duration(0), print)\nrospy.spin()"),
            "done, but with an error",
            "Nothing can have a frequency of 0 Hz",
        ),
        (
            node("rospy.Timer(0.5, print)\nrospy.spin()"),
            "done, but with an error",
            "rospy.Timer(rospy.Duration(0.5), callback)",
        ),
        ("import rospy\nprint('a'\n", "error", "SyntaxError: '(' was never closed\nPython could not read"),
        ("import numpy\n", "error", "but no numpy. Run the node on your own computer"),
        ("import rospy\nrospy.Rate(2)\n", "error", 'Call rospy.init_node("a_name") before you use anything else'),
        ("import std_srvs.srv\n", "error", "python -m rosspin run --ros1 FILE"),
        ("import std_srvs.srv\n", "error", "std_srvs is not simulated; run this node on a real ROS"),
        (node("rospy.Service"), "error", "node.py:4: rospy.Service is not simulated; run this node on a real ROS"),
        (node("while True: pass"), "error", "node.py:4: simulated time stands still at 0.0 s"),
        (node("while not rospy.is_shutdown(): rospy.sleep(0)"), "error", "node.py:4: simulated time stands still"),
        (
            node("import threading\nwhile True: threading.Thread(target=rospy.sleep, args=[1]).start()"),
            "error",
            "node.py:5: simulated time stands still at 0.0 s, because 1,000 threads have not ended",
        ),
        (
            node("def callback(event):\n    import tf2_ros\nrospy.Timer(rospy.Duration(1), callback)\nrospy.spin()"),
            "error",
            "node.py:5: tf2_ros is not simulated; run this node on a real ROS",
        ),
        (node("1 / 0"), "error", "ZeroDivisionError"),
        (node("input()"), "error", "EOFError"),
    ],
)
def test_errors_end_in_a_sentence_that_helps(page: Page, code: str, status: str, sentence: str) -> None:
    cell = Cell(page, TIMER)
    cell.write(code)
    cell.run(2)
    console = cell.ends(status)
    assert sentence in console
    assert "rosspin/" not in console and "pyodide" not in console
    assert cell.console.locator(".stderr").count()


PROCESSES = {
    "multiprocessing.Process(target=print).start()": "multiprocessing.Process",
    "multiprocessing.get_context('fork').Process(target=print).start()": r"multiprocessing.Process \(fork\)",
    "multiprocessing.Pool(2)": "multiprocessing.Pool",
    "multiprocessing.Manager()": "multiprocessing.Manager",
    "multiprocessing.Queue()": "multiprocessing.Queue",
    "ProcessPoolExecutor(2).submit(pow, 2, 3)": "ProcessPoolExecutor",
    "subprocess.run(['ls'])": "subprocess",
    "os.fork()": r"os\.fork",
}


@pytest.mark.parametrize("where", ["main", "thread"])
@pytest.mark.parametrize("call", PROCESSES)
def test_a_process_is_named(page: Page, call: str, where: str) -> None:
    """In the same line as in simulated time elsewhere. To import what could start one is no fault."""
    cell = Cell(page, TIMER)
    body = call if where == "main" else f"threading.Thread(target=lambda: {call}).start()\nrospy.spin()"
    cell.write(
        "import multiprocessing, os, subprocess, threading; from concurrent.futures import ProcessPoolExecutor\n"
        + node(body)
    )
    cell.run(2)
    assert re.fullmatch(
        rf"\S+\.py:5: {PROCESSES[call]} is not simulated; run this node on the wall clock or on a real ROS\n"
        r"On a computer, run: python -m rosspin run FILE\n",
        cell.ends("error"),
    )


def test_traceback_shows_the_readers_lines_only(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.write(node("def f(event):\n    g()\ndef g():\n    raise KeyError('mine')\nf(None)"))
    cell.run(2)
    lines = re.findall(r'  File "(.*)", line (\d+)', cell.ends("error"))
    assert lines == [("spinner_py_node.py", line) for line in ("8", "5", "7")]


def test_last_line_without_its_end_is_shown(page: Page) -> None:
    cell = Cell(page, TIMER)
    cell.write("import sys\nprint('out', end='')\nprint('err', end='', file=sys.stderr)")
    cell.run(2)
    assert cell.ends("done") == "outerr"
    assert cell.console.locator(".stderr").all_text_contents() == ["err"]


def test_output_is_text(page: Page) -> None:
    cell = Cell(page, TIMER)
    html = "<img src=x onerror=\"document.title='taken'\"><b>bold</b>"
    cell.write(f"print('''{html}''')")
    cell.run(2)
    assert cell.ends("done") == html + "\n"
    assert cell.console.locator("img, b").count() == 0


def test_a_run_finds_a_clean_world(page: Page) -> None:
    """Whatever an earlier one has done to Python, to the stand-in, or to files."""
    cell = Cell(page, TIMER)
    cell.write(
        """
import builtins, os, pathlib, rospy
print(rospy.get_name(), os.environ.get("MINE"), hasattr(builtins, "mine"), hasattr(rospy, "mine"), os.listdir())
os.environ["MINE"] = "1"
builtins.mine = rospy.mine = True
pathlib.Path("mine.txt").touch()
rospy.init_node("a_node")
"""
    )
    for _ in range(3):
        cell.run(2)
        assert cell.ends("done") == "/unnamed None False False []\n"


# What is said where a file of the site cannot be had.
NOT_LOADED = "A part of Python could not be loaded from this site. Is its server still there?"


def test_without_the_server_runs_go_on(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    assert _first_run(page, address, "print('first')") == "first\n"
    cell = Cell(page, TIMER)

    def ends(text: str, status: str) -> str:
        cell.write(text)
        cell.run(1)
        return cell.ends(status)

    have_workers(page, 1)  # a Python whose files are still on their way might wait for them
    context.set_offline(True)
    for number in range(3):
        assert ends(f"print({number})", "done") == f"{number}\n"
    assert "IndexError: Cannot choose" in ends("import random\nrandom.choice([])", "error")
    assert ends("import csv", "error").endswith(f"{NOT_LOADED}\n")
    context.set_offline(False)
    assert ends("import csv", "done") == ""


def test_a_link_that_cannot_be_made(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    open_tutorial(page, address)
    context.set_offline(True)
    cell = Cell(page, RATE)
    cell.button("Share").click()
    expect(cell.status).to_have_text("error: the link could not be made. Is the site still there?")
    context.set_offline(False)


def test_an_editor_that_cannot_be_loaded(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    open_tutorial(page, address)
    context.set_offline(True)
    cell = Cell(page, RATE)
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


@pytest.mark.parametrize("status", [200, 404])
def test_a_wrong_file_in_the_place_of_the_library(context: BrowserContext, address: str, status: int) -> None:
    """As from a portal, or cut off; nothing of it is kept."""
    context.route("**/python_stdlib.zip*", lambda route: route.fulfill(status=status, body="PK"))
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write(TRIES_AGAIN)
    cell.run(1000, "real time")
    expect(cell.console).to_contain_text("not yet")
    context.unroute("**/python_stdlib.zip*")
    assert set(cell.ends("done").splitlines()) == {"not yet"}


def test_python_breaks_down(context: BrowserContext, address: str) -> None:
    """It says so on the console of the page, and the next run finds a Python of its own."""
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write("import os\nos.abort()")
    cell.run(2)
    assert "Python itself broke down" in cell.ends("error")
    cell.write("print('next')")
    cell.run(2)
    assert cell.ends("done") == "next\n"


# --- where Python cannot run ------------------------------------------------------------------------------------------


def _is_plain(page: Page, line: str) -> None:
    listing = page.locator("div.live").nth(1)
    expect(listing.locator("pre")).to_contain_text("class SpinnerPyNode")
    expect(page.get_by_text(line).nth(1)).to_be_visible()
    expect(listing.get_by_role("button", name="Run")).to_have_count(0)


def test_opened_as_a_file(context: BrowserContext, site: Path) -> None:
    page = context.new_page()
    page.goto((site / TUTORIAL).as_uri())
    _is_plain(page, "Serve the site instead: make serve")


def test_without_jspi(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.add_init_script("delete WebAssembly.Suspending")
    page.goto(address + TUTORIAL)
    _is_plain(page, "This browser cannot run this listing: it lacks JSPI")


def test_without_javascript(browser: Browser, address: str) -> None:
    with browser.new_context(java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + TUTORIAL)
        _is_plain(page, "To run this listing here, the page needs JavaScript.")


# --- what the page may do ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "attempt",
    [
        "fetch('https://example.org/')",
        "import('https://example.org/a.js')",
        "Promise.resolve(new Worker('data:text/javascript,'))",
        "new Promise(resolve => setTimeout(() => { resolve(); Function('') }))",
    ],
)
def test_policy_forbids(context: BrowserContext, address: str, attempt: str) -> None:
    page = context.new_page()
    page.goto(address + TUTORIAL)
    page.evaluate("window.blocked = []; addEventListener('securitypolicyviolation', e => blocked.push(e.blockedURI))")
    page.evaluate(f"async () => {{ try {{ await {attempt} }} catch {{}} }}")
    page.wait_for_function("blocked.length")
    page.wait_for_timeout(100)
    assert page.evaluate("blocked.length") == 1


def test_policy_forbids_other_inline_scripts(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(address + TUTORIAL)
    page.evaluate("document.body.append(Object.assign(document.createElement('script'), {text: 'window.mine = 1'}))")
    assert page.evaluate("window.mine") is None


def test_every_page_has_its_policy(site: Path) -> None:
    """What may be loaded comes from the site itself; inline scripts are those of the page, by their hashes."""
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            text = path.read_text(encoding="utf-8")
            (found,) = re.findall(r'<meta http-equiv="Content-Security-Policy" content="(.*?)"', text)
            assert found == policy(text)
            assert not re.search(r"https?:|\*|'unsafe-eval'|script-src[^;]*'unsafe-inline'", found)
            assert not re.search(r"<[^>]* on[a-z]+=", text), "an inline handler, which the policy forbids"


def test_lock_file_has_no_addresses() -> None:
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    assert "node_modules/pyodide" in lock["packages"]
    assert not [name for name, package in lock["packages"].items() if "resolved" in package]


# --- how it looks -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_looks(browser: Browser, address: str, width: int, scheme: Literal["light", "dark"]) -> None:
    """An open cell with its editor, console and plot fits a phone, and its text stands out in light and in dark."""
    with browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme) as context:
        page = context.new_page()
        open_tutorial(page, address)
        cell = Cell(page, TIMER)
        cell.write(node("rospy.logerr('late')\nrospy.Timer(rospy.Duration(0.1), lambda event: None)\nrospy.spin()"))
        cell.run(2)
        cell.ends("done")
        expect(cell.plot).to_be_visible()
        assert page.evaluate(TOO_WIDE) + page.evaluate(FAINT) == []
