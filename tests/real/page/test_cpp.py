"""Listings in C++ in the page: their programs, which were compiled with it, run without Python."""

from __future__ import annotations

import gzip
import re
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from rosspin import simulate
from rosspin.measures import by_source, describe_timeline
from rosspin.results.pinned import as_test
from tests.helpers.axe import in_both_schemes
from tests.helpers.listings_in_page import Cell, unfold
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(10)

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
    assert not {"worker.js", "snapshot.zst"} & {file.name for file in files}
    assert sum(len(gzip.compress(file.read_bytes())) for file in files) <= 150_000
    ticks = simulate(EXAMPLES / name, 2).ticks
    expect(cell.plot).to_have_attribute("aria-label", f"Timeline. {describe_timeline(ticks[0].source, ticks)}")
    cell.element.get_by_role("slider").press("ArrowRight")
    assert ["counter = 1" in line for line in cell.marked()] == [True]


@pytest.mark.parametrize("address_of_page", TIMER)
def test_a_run_is_gone_through_step_by_step(page: Page, address: str, address_of_page: str) -> None:
    """What it takes is loaded when the reader asks for it."""
    page.goto(address + address_of_page)
    cell = Cell(page, 0, CPP)
    cell.run(1)
    cell.ends("done: 2 ticks")
    with page.expect_request("**/stepper.js"):
        cell.button("Step through this").click()
    source = simulate(EXAMPLES / TIMER[address_of_page], 1).ticks[0].source
    said = [f"main calls {source}.", f"{source} ends.", "No callback runs until 1 s."]
    expect(cell.element.get_by_role("button", name="Forward")).to_be_focused()
    for words in said:
        page.keyboard.press("Enter")
        expect(cell.element.locator(".stepper-said")).to_have_text(words)
    assert in_both_schemes(page) == []
    cell.button("Reset").click()
    expect(cell.element.locator(".stepper")).to_have_count(0)


@pytest.mark.parametrize("address_of_page", TIMER)
def test_a_run_is_copied_as_a_test(context: BrowserContext, address: str, address_of_page: str) -> None:
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    page.goto(address + address_of_page)
    cell = Cell(page, 0, CPP)
    cell.run(2)
    cell.ends("done")
    cell.button("Copy as test").click()
    expect(cell.status).to_have_text("the test is copied: save it in a file for pytest", timeout=60_000)
    file = EXAMPLES / TIMER[address_of_page]
    run = simulate(file, 2)
    expected = as_test(file.read_text(encoding="utf-8"), file.name, 2, (), COLOURS.sub("", run.console), run.ticks)
    assert page.evaluate("navigator.clipboard.readText()") == expected


# The pages that show a launch file, and the file.
LAUNCHED = {
    "docs/tutorial.html": "my_robotics_pkg/launch/spinner.launch",
    "docs/reference/launch-files.html": "my_robotics_pkg_ros2_cpp/launch/spinner.launch.xml",
}


@pytest.mark.parametrize("address_of_page", LAUNCHED)
def test_a_launch_file_starts_a_node_in_each_language(page: Page, address: str, address_of_page: str) -> None:
    page.goto(address + address_of_page)
    cell = Cell(page, 0, "div.live.highlight-xml")
    cell.run(2)
    file = EXAMPLES / LAUNCHED[address_of_page]
    run = simulate(file, 2)
    assert cell.ends("done: 8 ticks", 60_000) == COLOURS.sub("", run.console)
    expect(cell.plot).to_contain_text("spinner_cpp_node")
    cell.write(file.read_text(encoding="utf-8").replace('"mrp"', '"lab"'))
    cell.run(1)
    assert "/lab" in cell.ends("done: 4 ticks", 60_000)
    cell.write("<launch>")
    cell.run(1)
    assert f"{Path(LAUNCHED[address_of_page]).name}:1: " in cell.ends("error", 60_000)


def test_a_launch_file_starts_the_nodes_as_they_stand_there(page: Page, address: str) -> None:
    page.goto(f"{address}docs/tutorial.html?lang=python")
    node = Cell(page, 0, "div.live:has([aria-label='Run spinner_py_node.py'])")
    text = node.element.locator(".highlight pre").text_content() or ""
    node.write(text.replace("PY NODE", "CHANGED NODE"))
    cell = Cell(page, 0, "div.live.highlight-xml")
    cell.run(1)
    console = cell.ends("done: 4 ticks", 60_000)
    assert "CHANGED NODE] counter = 2" in console and "CPP NODE] counter = 2" in console


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
    page.goto(f"{address}docs/publish-lost.html?lang=cpp")
    unfold(page)
    cell = Cell(page, 0, f"{CPP}:has([aria-label='Run eager_cpp_node.cpp'])")
    field = cell.element.get_by_role("textbox", name="Arguments")
    expect(field).to_have_attribute("placeholder", "_frequency:=5")
    field.fill("_latch:=true")
    cell.run(2)
    assert cell.ends("done") == console("topics/eager_cpp_node.cpp", 2, "_latch:=true")
    field.fill("'_latch:=true")
    cell.run(2)
    assert cell.ends("error") == "arguments: no closing quotation\n"


# Where the publisher and the subscriber of a page are, by their languages.
FOLDERS = {
    "docs/publish.html": {"cpp": "my_robotics_pkg/src", "py": "my_robotics_pkg/src"},
    "docs/ros2/publish.html": {
        "cpp": "my_robotics_pkg_ros2_cpp/src",
        "py": "my_robotics_pkg_ros2/my_robotics_pkg",
    },
}


@pytest.mark.parametrize("address_of_page", FOLDERS)
def test_nodes_run_together_in_one_language_or_in_two(page: Page, address: str, address_of_page: str) -> None:
    def node(kind: str, language: str) -> Path:
        return EXAMPLES / FOLDERS[address_of_page][language] / f"{kind}_{language}_node.{language}"

    page.goto(f"{address}{address_of_page}?lang=cpp")
    unfold(page)
    for own, other in (("publisher", "subscriber"), ("subscriber", "publisher")):
        cell = Cell(page, 0, f"{CPP}:has([aria-label='Run {own}_cpp_node.cpp'])")
        cell.element.get_by_role("spinbutton").fill("2")
        cell.element.get_by_role("combobox").select_option("instantly")
        for label, language in (("Run both", "cpp"), ("Run with Python", "py")):
            run = simulate([node(own, "cpp"), node(other, language)], 2)
            cell.button(label).click()
            assert cell.ends(f"done: {len(run.ticks)} ticks", 60_000) == COLOURS.sub("", run.console)
            assert "counter = 4" in run.console
            alternative = " ".join(describe_timeline(name, ticks) for name, ticks in by_source(run.ticks).items())
            expect(cell.plot).to_have_attribute("aria-label", f"Timeline. {alternative}")
    page.goto(f"{address}{address_of_page}?lang=python")
    unfold(page)
    cell = Cell(page, 0, "div.live:has([aria-label='Run publisher_py_node.py'])")
    cell.element.get_by_role("spinbutton").fill("2")
    cell.button("Run with C\\+\\+").click()
    expected = simulate([node("publisher", "py"), node("subscriber", "cpp")], 2).console
    assert cell.ends("done: 4 ticks", 60_000) == COLOURS.sub("", expected)


def test_a_pair_can_be_stopped_and_needs_jspi(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(f"{address}docs/publish.html?lang=cpp")
    unfold(page)
    cell = Cell(page, 0, f"{CPP}:has([aria-label='Run subscriber_cpp_node.cpp'])")
    cell.element.get_by_role("spinbutton").fill("1000")
    cell.element.get_by_role("combobox").select_option("real time")
    cell.button("Run both").click()
    expect(cell.console).to_contain_text("counter = 2", timeout=60_000)
    cell.button("Stop").click()
    expect(cell.status).to_have_text("stopped")

    page = context.new_page()
    page.add_init_script("delete WebAssembly.Suspending")
    page.goto(f"{address}docs/publish.html?lang=cpp")
    unfold(page)
    cell = Cell(page, 0, f"{CPP}:has([aria-label='Run subscriber_cpp_node.cpp'])")
    cell.button("Run both").click()
    expect(cell.status).to_contain_text("runs one node at a time: it lacks JSPI, which Chrome")
    expect(cell.button("Run with Python")).to_be_hidden()


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
    expect(cell.status).to_contain_text("loads clang once: about 28 MB")
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
    assert not [url for url in asked if "/clang/" in url and url.endswith(".xz")]


SPINS = {
    "docs/tutorial.html?lang=cpp": ("  ros::spin();\n", "ros::spin()"),
    "docs/ros2/tutorial.html?lang=cpp": ("  rclcpp::spin(spinner_cpp_node);\n", "rclcpp::spin(node)"),
}


@pytest.mark.parametrize("address_of_page", SPINS)
def test_a_node_that_forgets_to_spin_is_told_so(page: Page, address: str, address_of_page: str) -> None:
    line, spins = SPINS[address_of_page]
    page.goto(address + address_of_page)
    cell = Cell(page, 0, CPP)
    text = (EXAMPLES / TIMER[address_of_page]).read_text(encoding="utf-8")
    assert line in text
    cell.write(text.replace(line, ""))
    cell.run(2)
    said = cell.ends("done; see the console", 120_000)
    assert "\nNothing spun the node, " in said and said.endswith(f" Is {spins} missing at its end?\n")
    expect(cell.button("Copy as test")).to_be_hidden()


def test_what_clang_warns_of_is_shown_and_the_node_runs(page: Page, address: str) -> None:
    """It is no part of what the node has printed, as a copied test has that."""
    name = "docs/ros2/tutorial.html?lang=cpp"
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.goto(address + name)
    cell = Cell(page, 0, CPP)
    text = (EXAMPLES / TIMER[name]).read_text(encoding="utf-8")
    main = "  rclcpp::init(argc, argv);\n"
    assert main in text
    cell.write(text.replace(main, f'{main}  std::string text = "counter = " + argc;\n  if (argc = 1) text.clear();\n'))
    cell.run(2)
    said = cell.ends("done: 4 ticks", 120_000)
    line = text.partition(main)[0].count("\n") + 2
    assert said.startswith(f"spinner_cpp_node.cpp:{line}:35: warning: adding 'int' to a string does not append")
    assert "std::to_string(number)" in said and "silence" not in said and "counter = 4" in said
    shown = [rf"{line}:35: adding 'int' to a string", rf"{line + 1}:12: using the result of an assignment"]
    expect(cell.element.locator(".live-fault")).to_have_text([re.compile(each) for each in shown])
    cell.button("Copy as test").click()
    expect(cell.status).to_have_text("the test is copied: save it in a file for pytest", timeout=60_000)
    copied = page.evaluate("navigator.clipboard.readText()")
    assert "counter = 4" in copied and "warning" not in copied


def test_a_changed_partner(page: Page, address: str) -> None:
    """It is compiled as it stands there. One that does not compile, never ends, prints without end or uses a null
    pointer harms no page."""
    page.goto(f"{address}docs/publish.html?lang=cpp")
    unfold(page)
    publisher, subscriber = (
        Cell(page, 0, f"{CPP}:has([aria-label='Run {name}_cpp_node.cpp'])") for name in ("publisher", "subscriber")
    )
    text = publisher.element.locator(".highlight pre").text_content() or ""
    for cell in (publisher, subscriber):
        cell.element.get_by_role("spinbutton").fill("2")
    publisher.write(text.replace("ros::spin();", "ros::spin()"))
    subscriber.button("Run both").click()
    assert "publisher_cpp_node.cpp:" in subscriber.ends("error", 120_000)
    expect(subscriber.element.locator(".live-fault")).to_have_count(0)
    publisher.write(text.replace("Duration(0.5)", "Duration(0.25)").replace("= 0.5;", "= 0.25;"))
    for label in ("Run both", "Run with Python"):
        publisher.button(label).click()
        assert "counter = 8" in publisher.ends("done: 8 ticks", 120_000)
    publisher.write(text.replace("ros::spin();", "int* none = nullptr; *none = 1;"))
    subscriber.button("Run both").click()
    assert re.search(r"publisher_cpp_node\.cpp:\d+: it has used a null pointer", subscriber.ends("done|error", 120_000))
    for loop in ("for (volatile int i = 0;; i++) {}", 'for (;;) ROS_INFO("more");'):
        publisher.write(text.replace("ros::spin();", loop))
        subscriber.button("Run both").click()
        expect(subscriber.status).to_have_text("running", timeout=120_000)
        if "more" in loop:
            expect(subscriber.element).to_contain_text("left out")
        subscriber.button("Stop").click()
        expect(subscriber.status).to_have_text("stopped")
    subscriber.run(1)
    assert "SUBSCRIBER CPP NODE" in subscriber.ends("done")


LOCKED = """\
#include <mutex>
#include <ros/ros.h>
#include <thread>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::mutex one, two;
  auto lock = [](std::mutex& first, std::mutex& second)
  {
    first.lock();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    second.lock();
  };
  std::thread other(lock, std::ref(one), std::ref(two));
  lock(two, one);
}
"""


def test_a_deadlock_is_drawn(page: Page, address: str) -> None:
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, CPP)
    cell.write(LOCKED)
    cell.run(1)
    assert "rosspin: deadlock. This can never continue:" in cell.ends("done|error", 120_000)
    said = re.compile(r"^A ring of waits\. .*main waits for a lock that thread 1 holds")
    expect(cell.element.locator("svg.stepper-ring")).to_have_attribute("aria-label", said)
    expect(cell.button("Step through this")).to_have_count(0)
