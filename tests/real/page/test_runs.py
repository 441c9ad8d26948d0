"""Runs in the page: what they print and draw is what the same file gives elsewhere; with arguments, and stopped."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from rosspin import simulate
from rosspin.measures import describe_timeline
from tests.helpers.listings_in_page import (
    IN_PYTHON,
    LISTINGS,
    OTHER,
    ROS2,
    TIMER,
    Cell,
    node,
    node2,
    unfold,
)
from tests.helpers.notebook_nodes import NODES
from tests.helpers.readers import reader
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


@pytest.mark.parametrize("index", range(len(LISTINGS)))
def test_run(tutorial: Page, index: int) -> None:
    """The page prints what the same file prints in simulated time elsewhere, and draws its ticks."""
    cell = Cell(tutorial, index)
    cell.run(2)
    run = simulate(EXAMPLES / LISTINGS[index], 2)
    assert cell.ends("done") == run.console
    if run.ticks:
        expect(cell.status).to_have_text(f"done: {len(run.ticks)} ticks")
        expect(cell.plot).to_have_attribute("aria-label", re.compile(f"{run.ticks[0].source}: {len(run.ticks)} ticks"))
    else:
        expect(cell.plot).to_have_count(0)


@pytest.mark.parametrize("name", ["docs/ros2/tutorial", "docs/tutorial"])
def test_run_is_on_the_first_screen_and_so_is_what_it_gives(browser: Browser, address: str, name: str) -> None:
    with reader(browser, viewport={"width": 1280, "height": 800}) as context:
        page = context.new_page()
        page.goto(f"{address}{name}.html?lang=python")
        cell = Cell(page, 0)
        expect(cell.button("Run")).to_be_in_viewport(ratio=1)
        assert page.evaluate("scrollY") == 0
        cell.button("Run").click()
        cell.ends("done: 20 ticks")
        for shown in cell.button("Run"), cell.plot, cell.console:
            expect(shown).to_be_in_viewport(ratio=1)


def test_a_run_that_prints_nothing_can_be_reset(page: Page, address: str) -> None:
    page.goto(f"{address}docs/publish-lost.html")
    unfold(page)
    cell = Cell(page, 0, "div.live:has([aria-label='Run slowing_py_node.py'])")
    made, reset = cell.element.locator("figure.live-made"), cell.button("Reset")
    expect(reset).to_have_attribute("aria-disabled", "true")
    cell.button("Run").click()
    assert cell.ends("done: 101 ticks") == ""
    expect(made).to_be_hidden()
    expect(reset).to_have_attribute("aria-disabled", "false")
    reset.click()
    expect(made).to_be_visible()
    expect(reset).to_have_attribute("aria-disabled", "true")


def test_run_in_real_time(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.status.evaluate(
        """status => {
            window.said = []
            new MutationObserver(() => said.push(status.textContent)).observe(status, { childList: true })
        }"""
    )
    expect(cell.element.get_by_role("combobox")).to_have_value("0")  # it is a choice: a run is shown instantly
    cell.run(1.5, "real time")
    axis = cell.plot.locator("text")
    axis.first.wait_for()
    begun = axis.all_text_contents()
    assert cell.ends("done") == simulate(EXAMPLES / LISTINGS[TIMER], 1.5).console
    assert begun == axis.all_text_contents()  # it has not moved while ticks came
    assert tutorial.evaluate("said.includes('running')")
    ticks = cell.plot.locator("circle")
    expect(ticks).to_have_count(3)


def test_two_at_once(tutorial: Page) -> None:
    cells = [Cell(tutorial, TIMER), Cell(tutorial, OTHER)]
    for cell in cells:
        cell.run(3, "real time")
    for cell, index in zip(cells, (TIMER, OTHER), strict=True):
        assert cell.ends("done") == simulate(EXAMPLES / LISTINGS[index], 3).console


def test_bad_seconds(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.run(1)
    assert cell.ends("done")
    cell.run(-1)
    assert cell.ends("error: seconds") == ""
    cell.button("Reset").click()
    expect(cell.element.get_by_role("spinbutton")).to_have_value("10")


# --- arguments --------------------------------------------------------------------------------------------------------


def test_arguments_are_offered_where_a_node_reads_parameters(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
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
def test_words_that_ros2_does_not_read_are_named(tutorial: Page, words: str) -> None:
    cell = Cell(tutorial, TIMER)
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


# --- nodes of ROS 2 ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", ROS2, ids=lambda path: path.stem)
def test_node_of_ros2(tutorial: Page, path: Path) -> None:
    """It is as good as one of ROS 1; INFO lines, which ROS 2 puts on stderr, do not look like errors."""
    cell = Cell(tutorial, TIMER)
    cell.write(path.read_text(encoding="utf-8"))
    cell.run(2)
    run = simulate(path, 2)
    assert cell.ends(f"done: {len(run.ticks)} ticks$") == run.console
    expect(cell.plot).to_have_attribute("aria-label", f"Timeline. {describe_timeline(run.ticks[0].source, run.ticks)}")
    expect(cell.console.locator(".stderr")).to_have_count(0)
    cell.element.get_by_role("slider").press("ArrowRight")
    assert [line[-12:] for line in cell.marked()] == ["counter = 1\n"]
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_be_visible(visible=path.stem.startswith("spinner_param"))


def test_arguments_set_a_parameter_of_ros2(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
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


LOOP_IN_MAIN = "rate = node.create_rate(2)\nwhile rclpy.ok():\n    rate.sleep()"

SPIN = "import threading\nthreading.Thread(target=rclpy.spin, args=[node], daemon=True).start()\n"


@pytest.mark.parametrize(("spin", "ticks"), [("", "1 tick"), (SPIN, "4 ticks|5 ticks")])
def test_rate_that_nobody_wakes(tutorial: Page, spin: str, ticks: str) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(node2(spin + LOOP_IN_MAIN))
    cell.run(2)
    console = cell.ends(f"done: ({ticks}), ended by Ctrl-C")
    assert ("another one has to spin the node" in console) == (not spin)


@pytest.mark.parametrize("seconds", [0.4, 2])
def test_nobody_is_told_to_spin_who_does(tutorial: Page, seconds: float) -> None:
    cell = Cell(tutorial, TIMER)
    cell.run(seconds)
    assert "missing" not in cell.ends("done")


# --- two listings that run together -----------------------------------------------------------------------------------

PUBLISHER, SUBSCRIBER = (EXAMPLES / f"my_robotics_pkg/src/{name}_py_node.py" for name in ("publisher", "subscriber"))


@pytest.fixture
def both(context: BrowserContext, address: str) -> tuple[Cell, Cell]:
    """The publisher and the subscriber of the tutorial on topics."""
    page = context.new_page()
    page.goto(f"{address}docs/publish.html?lang=python")
    unfold(page)
    publisher, subscriber, *_ = (Cell(page, index) for index in range(page.locator(IN_PYTHON).count()))
    return publisher, subscriber


def test_two_listings_run_together(both: tuple[Cell, Cell]) -> None:
    for cell, paths in zip(both, ([PUBLISHER, SUBSCRIBER], [SUBSCRIBER, PUBLISHER]), strict=True):
        run = simulate(paths, 2)
        cell.run(2)
        assert "counter" not in cell.ends("done")  # alone
        cell.button("Run both").click()
        assert cell.ends(f"done: {len(run.ticks)} ticks") == run.console
        assert "counter = 4" in run.console
        expect(cell.button("Copy as test")).to_be_hidden()
    expect(both[0].element.page.get_by_role("button", name=re.compile("^Run both"))).to_have_count(2)


def test_they_run_as_they_stand_there(both: tuple[Cell, Cell]) -> None:
    publisher, subscriber = both
    publisher.write(
        node(
            "publisher = rospy.Publisher('counter', UInt32, queue_size=1)\nrospy.sleep(1)\n"
            "publisher.publish(42)\nrospy.spin()"
        ).replace("import rospy", "import rospy\nfrom std_msgs.msg import UInt32", 1)
    )
    subscriber.button("Run both").click()
    assert "counter = 42" in subscriber.ends("done")
    publisher.write("print(")
    subscriber.button("Run both").click()
    assert "publisher_py_node.py" in subscriber.ends("error")
    publisher.write("import rospy\nrospy.init_node('faulty')\n1 / 0\n")
    subscriber.button("Run both").click()
    assert "ZeroDivisionError" in subscriber.ends("done, but with an error")


def test_a_page_may_have_several_pairs(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(f"{address}docs/ros2/publish-qos.html")
    unfold(page)
    cells = [Cell(page, index) for index in range(page.locator(IN_PYTHON).count())]
    paths = [EXAMPLES / f"topics/ros2/{name}_py_node.py" for name in ("thirty", "slow", "eager", "late")]
    assert len(cells) == len(paths)
    for index, beside in enumerate((1, 0, 3, 2)):
        cells[index].run(0.1)
        cells[index].ends("done")
        cells[index].element.get_by_role("spinbutton").fill("3")
        cells[index].button("Run both").click()
        assert cells[index].ends("done") == simulate([paths[index], paths[beside]], 3).console


# --- cells of notebooks -----------------------------------------------------------------------------------------------


@pytest.mark.shares(10)
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


def test_stop_ends_a_busy_loop_and_the_next_run_starts(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write("print('busy')\nsum(iter(int, 1))\n")  # which no watchdog can interrupt
    cell.run(2)
    expect(cell.console).to_contain_text("busy")
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")
    cell.write("print('next')\n")
    cell.button("Run").click()
    assert cell.ends("done") == "next\n"


def test_stop_in_real_time(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.run(1000, "real time")
    expect(cell.plot.locator("circle")).not_to_have_count(0)
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")
    before = cell.text()
    tutorial.wait_for_timeout(700)
    assert cell.text() == before
    handle = cell.element.get_by_role("slider")
    handle.press("Home")
    said = "timerCallback, tick 1: expected 0.5 s, real 0.5 s, on time"
    expect(handle).to_have_attribute("aria-valuetext", re.compile(said))


def test_a_run_finds_a_clean_world(tutorial: Page) -> None:
    """Whatever an earlier one has done to Python, to the stand-in, or to files."""
    cell = Cell(tutorial, TIMER)
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


def test_what_is_drawn_at_random_differs(tutorial: Page) -> None:
    """Though each run begins with the same snapshot."""
    cell = Cell(tutorial, TIMER)
    cell.write("import random\nprint(random.random())\n")
    drawn = set()
    for _ in range(2):
        cell.run(2)
        drawn.add(cell.ends("done"))
    assert len(drawn) == 2


def test_module_that_is_not_in_the_snapshot(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write("import sys\nprint('csv' in sys.modules)\nimport csv\nprint(csv.reader(['a,b']).__next__())\n")
    cell.run(2)
    assert cell.ends("done") == "False\n['a', 'b']\n"
