"""The plot of a run, and the way from its ticks, from errors and from logged lines to the code."""

from __future__ import annotations

import re
from html import unescape

import pytest
from playwright.sync_api import Browser, Page, expect

from rosspin import simulate
from rosspin.measures import describe_timeline
from rosspin.site.live import plot
from tests.helpers.listings_in_page import (
    LISTINGS,
    TIMER,
    Cell,
    node,
    node2,
    open_tutorial,
)
from tests.helpers.readers import reader, until
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)


@pytest.mark.parametrize("index", range(len(LISTINGS)))
def test_plot_is_there_before_the_first_run(tutorial: Page, index: int) -> None:
    """It makes way for a run's, and comes back."""
    cell = Cell(tutorial, index)
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


def test_the_axis_goes_to_the_end_of_the_run(tutorial: Page) -> None:
    """Where nothing ticks any more, that is seen: in the plot that was made, and in a run's."""
    text = node("timer = rospy.Timer(rospy.Duration(0.5), lambda event: timer.shutdown())\nrospy.spin()")
    cell = Cell(tutorial, TIMER)
    cell.write(text)
    cell.run(10)
    cell.ends("done: 1 tick")
    assert cell.plot.locator("circle").get_attribute("cx") == "5%"
    wide, narrow = (float(x) for x in re.findall(r'<circle cx="([\d.]+)"', plot(text)))
    assert 0.05 < wide / 760 < 0.07 and 0.05 < narrow / 365 < 0.07


LATE = {
    "ROS 1": """
import rospy

rospy.init_node("a_node")
rospy.Timer(rospy.Duration(0.5), lambda event: rospy.sleep(9))
rate = rospy.Rate(2)
for work in (0.1, 9, 9):
    rospy.sleep(work)
    if rospy.is_shutdown():
        break
    rate.sleep()
""",
    "ROS 2": """
import threading
import time

import rclpy

rclpy.init()
node = rclpy.create_node("a_node")
node.create_timer(0.5, lambda: time.sleep(9))

def loop():
    rate = node.create_rate(2)
    while rclpy.ok():
        rate.sleep()

threading.Thread(target=loop, daemon=True).start()
rclpy.spin(node)
""",
}


@pytest.mark.parametrize(("ros", "axis"), [("ROS 1", 9.5), ("ROS 2", 3.0)])
def test_a_run_has_crosses_up_to_its_end(tutorial: Page, ros: str, axis: float) -> None:
    """For what its timers and loops lost by the rule of their ROS: the same as below the listing, when it was made.

    In ROS 1 Ctrl-C does not end the last pass, so the axis continues.
    """
    cell = Cell(tutorial, TIMER)
    cell.write(LATE[ros])
    cell.run(3)
    cell.ends("done")
    made = plot(f"%%simulate 3\n{LATE[ros]}")
    said = cell.plot.first.get_attribute("aria-label")
    assert said and "Lost ticks: " in said and said in unescape(made)
    crosses = cell.plot.locator("svg > path")
    expect(crosses).to_have_count(sum(map(int, re.findall(r"Lost ticks: (\d+)", said))))
    shares = [float(str(cross.get_attribute("x"))[:-1]) for cross in cell.plot.locator("g svg").all()]
    # Each is drawn around its place: to all sides of it, whatever is cut off there by default.
    cut = "all => all.filter(each => getComputedStyle(each).overflow !== 'visible').length"
    assert cell.plot.locator("g svg").evaluate_all(cut) == 0
    assert max(shares) == pytest.approx(100 * 3 / axis, abs=1e-3)
    expect(cell.plot.first).to_contain_text("cross: lost")


def test_a_finger_chooses_a_tick(browser: Browser, address: str) -> None:
    with reader(browser, viewport={"width": 390, "height": 800}, has_touch=True, is_mobile=True) as context:
        page = context.new_page()
        open_tutorial(page, address)
        cell = Cell(page, TIMER)
        cell.run(2)
        cell.ends("done")
        cell.element.get_by_role("slider").tap()
        expect(cell.element.locator(".live-tick")).to_have_text(re.compile("tick 2"))


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


def test_tick_leads_to_its_lines(tutorial: Page) -> None:
    """By the arrow keys; the lines of two threads that print at the same time are told apart."""
    cell = Cell(tutorial, TIMER)
    cell.write(TWO_TIMERS)
    cell.run(1)
    cell.ends("done")
    handle = cell.element.get_by_role("slider")
    handle.focus()
    found = {}
    for _ in range(6):
        tutorial.keyboard.press("ArrowRight")
        found[handle.get_attribute("aria-valuetext")] = cell.marked()
    assert found == {
        "fast, tick 1: expected 0.25 s, real 0.25 s, on time": ["fast and more\n"],
        "slow, tick 1: expected 0.5 s, real 0.5 s, on time": ["slow begins\n", "slow ends\n"],
        "fast, tick 2: expected 0.5 s, real 0.5 s, on time": ["fast and more\n"],
        "fast, tick 3: expected 0.75 s, real 0.75 s, on time": ["fast and more\n"],
        "slow, tick 2: expected 1 s, real 1 s, on time": ["slow begins\n", "slow ends\n"],
        "fast, tick 4: expected 1 s, real 1 s, on time": ["fast and more\n"],
    }
    tutorial.keyboard.press("Home")
    expect(handle).to_have_attribute("aria-valuenow", "1")
    tutorial.keyboard.press("End")
    expect(handle).to_have_attribute("aria-valuenow", "6")
    tutorial.keyboard.press("Tab")
    assert cell.marked() == []


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
def test_pass_of_a_loop_leads_to_its_lines(tutorial: Page, loop: str) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(loop)
    cell.run(1.2)
    cell.ends("done")
    cell.element.get_by_role("slider").press("ArrowRight")
    assert cell.marked() == ["begins\n", "ends\n"]


def test_pointing_at_a_tick(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write((EXAMPLES / LISTINGS[TIMER]).read_text(encoding="utf-8").replace("0.5", "0.4"))
    cell.run(2)
    cell.ends("done: 5 ticks")

    def points_at_it() -> bool:
        """Whether that is told; what comes above the plot at the end of a run may move it away from the pointer."""
        mark = cell.plot.locator("g circle").nth(2).bounding_box()
        assert mark
        tutorial.mouse.move(mark["x"] + mark["width"] / 2 + 1, mark["y"] + mark["height"] / 2)
        told = cell.element.locator(".live-tick").text_content()
        return told == "timerCallback, tick 3: expected 1.2 s, real 1.2 s, on time"

    until(tutorial, points_at_it)
    assert cell.marked() == ["[INFO] [1.200000]: [SPINNER PY NODE] counter = 3\n"]
    tutorial.mouse.move(0, 0)
    assert cell.marked() == []


@pytest.mark.parametrize(
    ("body", "named", "line"),
    [
        ("\n\nraise KeyError('mine')", 'File "spinner_py_node.py", line 6', 6),
        ("rospy.MasterProxy", "spinner_py_node.py:4", 4),
    ],
)
def test_error_leads_to_its_line(tutorial: Page, body: str, named: str, line: int) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(node(body))
    cell.run(1)
    cell.ends("error")
    cell.console.get_by_role("button", name=named).first.click()
    expect(cell.editor).to_be_focused()
    assert tutorial.evaluate("getSelection().toString()") == node(body).splitlines()[line - 1]


@pytest.mark.parametrize(
    ("log", "level"),
    [
        ("rospy.logwarn", "WARN"),
        ("rospy.logfatal", "FATAL"),
        ("node.get_logger().error", "ERROR"),
    ],
)
def test_logged_line_leads_to_its_call(tutorial: Page, log: str, level: str) -> None:
    """Also from a timer's callback, which the stand-in calls. A line that is no warning leads nowhere."""
    cell = Cell(tutorial, TIMER)
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
    assert tutorial.evaluate("getSelection().toString()") == call
