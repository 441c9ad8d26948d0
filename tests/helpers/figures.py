"""The figures with a handle: their list, the runs that they should show, and what they do show."""

from __future__ import annotations

import json
import re
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from playwright.sync_api import Page, expect

from rosspin import Tick, rclpy, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.run.simulate import run_captured
from rosspin.run.source import load_source

from .tree import ROOT

SPINNER = ROOT / "examples/my_robotics_pkg/src/spinner_py_node.py"

SPINNER_ROS2 = ROOT / "examples/my_robotics_pkg_ros2/my_robotics_pkg/spinner_py_node.py"

PROBE = ROOT / "examples/timing_probes/src/timer_probe.py"

PROBE_2 = ROOT / "examples/ros2/timer_probe.py"


Runs = Mapping[str, Sequence[Tick]]


def spinner(path: Path, callback: str) -> Callable[[float], Runs]:
    text = path.read_text(encoding="utf-8")

    def run(delta: float) -> Runs:
        changed = text.replace("delta_t_in_seconds = 0.5", f"delta_t_in_seconds = {delta}")
        return {callback: run_captured(Simulation(), load_source(changed, str(path)), 2.0, []).ticks}

    return run


def probes(*words: str, seconds: float) -> Callable[[float], Runs]:
    files = {"rospy": PROBE, "roscpp": PROBE.with_suffix(".cpp")}

    def run(block: float) -> Runs:
        args = [f"_block:={block}", *words]
        return {name: simulate(file, seconds, args).ticks for name, file in files.items()}

    return run


def ros_2(*words: str, seconds: float) -> Callable[[float], Runs]:
    def run(block: float) -> Runs:
        parameters = [part for word in (f"block:={block}", *words) for part in ("-p", word)]
        return {"rclpy": simulate(PROBE_2, seconds, ["--ros-args", *parameters]).ticks}

    return run


def both_of_ros_2(name: str) -> Callable[[float], Runs]:
    """A probe whose third call, or pass, blocks, in rclpy and rclcpp."""

    def run(block: float) -> Runs:
        args = ["--ros-args", "-p", f"block:={block}", "-p", "block_call:=3"]
        files = {"rclpy": f"{name}.py", "rclcpp": f"{name}.cpp"}
        return {row: simulate(PROBE_2.with_name(file), 6, args).ticks for row, file in files.items()}

    return run


def three(*words: str, seconds: float) -> Callable[[float], Runs]:
    """One callback in rospy, roscpp and rclpy."""
    one, two = probes(*(f"_{word}" for word in words), seconds=seconds), ros_2(*words, seconds=seconds)
    return lambda block: {**one(block), **two(block)}


def loops(work: float) -> Runs:
    from rosspin import rospy

    def with_rate() -> None:
        rospy.init_node("loop")
        rate = rospy.Rate(2.0)
        while not rospy.is_shutdown():
            rospy.sleep(work)
            rate.sleep()

    passes: list[Tick] = []

    def with_sleep() -> None:
        rospy.init_node("loop")
        while not rospy.is_shutdown():
            passes.append(Tick("plain sleep", len(passes) + 1, 0.0, rospy.get_time(), work))
            rospy.sleep(work)
            rospy.sleep(0.5)

    ticks = simulate(with_rate, 3.0).ticks
    simulate(with_sleep, 3.0)
    return {"Rate": ticks, "plain sleep": passes}


def ros2_loops(work: float) -> Runs:
    def with_rate() -> None:
        def loop() -> None:
            while rclpy.ok():
                time.sleep(work)
                rate.sleep()

        rclpy.init()
        node = rclpy.create_node("loop")
        rate = node.create_rate(2.0)
        threading.Thread(target=loop, daemon=True).start()
        rclpy.spin(node)

    passes: list[Tick] = []

    def with_sleep() -> None:
        rclpy.init()
        node = rclpy.create_node("loop")
        while rclpy.ok():
            begins = node.get_clock().now().nanoseconds / 1e9
            time.sleep(work)
            passes.append(Tick("plain sleep", len(passes) + 1, 0.0, begins, work))
            time.sleep(0.5)

    ticks = simulate(with_rate, 3.0).ticks
    simulate(with_sleep, 3.0)
    return {"Rate": ticks, "plain sleep": passes}


def executors(work: float) -> Runs:
    ways = {
        "spin": [],
        "default": ["executor:=multi"],
        "own": ["executor:=multi", "group:=own"],
        "reentrant": ["executor:=multi", "group:=reentrant"],
    }
    rows = {}
    for way, parameters in ways.items():
        words = [f"block:={work}", "second_timer:=true", *parameters]
        args = ["--ros-args", *(part for word in words for part in ("-p", word))]
        ticks = simulate(ROOT / "examples/ros2/timer_probe.py", 6.2, args).ticks
        for name, source in (("slow", "timer_callback"), ("quick", "second_callback")):
            rows[f"{way}: {name}"] = [tick for tick in ticks if tick.source == source]
    return rows


class Kind(NamedTuple):
    """A figure: its page, which one of the page's it is, what it says of itself, and its runs by the handle's value."""

    page: str
    number: int
    label: str
    runs: Callable[[float], Runs]


FIGURES = [
    Kind("index.html", 0, "Time delta", spinner(SPINNER_ROS2, "timer_callback")),
    Kind("docs/tutorial-timer.html", 0, "Time delta", spinner(SPINNER, "timerCallback")),
    Kind("notebooks/rate.html", 0, "Work in each pass", loops),
    Kind("notebooks/slow-callback.html", 0, "The third call takes", three("block_call:=3", seconds=6.2)),
    Kind("notebooks/ros2-rate.html", 0, "Work in each pass", ros2_loops),
    Kind("notebooks/ros2-groups.html", 0, "Work of the slow timer", executors),
    Kind("docs/how-timing-works.html", 0, "Every call takes", probes(seconds=6)),
    Kind("docs/how-timing-works.html", 1, "The third call takes", probes("_block_call:=3", seconds=6)),
    Kind("docs/ros2/how-timing-works.html", 0, "The third call takes", both_of_ros_2("timer_probe")),
    Kind("docs/ros2/how-timing-works.html", 1, "The third pass takes", both_of_ros_2("rate_probe")),
    Kind("docs/ros2/from-ros-1.html", 0, "The third call takes", three("block_call:=3", seconds=6)),
    Kind("docs/ros2/from-ros-1.html", 1, "Every call takes", three(seconds=6)),
    Kind("docs/ros2/tutorial-timer.html", 0, "Time delta", spinner(SPINNER_ROS2, "timer_callback")),
    Kind("docs/slides/ros2.html", 0, "Time delta", spinner(SPINNER_ROS2, "timer_callback")),
    Kind("docs/slides/ros1.html", 0, "Time delta", spinner(SPINNER, "timerCallback")),
    Kind("docs/slides/ros1.html", 1, "The third call takes", probes("_block_call:=3", seconds=6)),
]

# What a figure shows, whether matplotlib drew it or the page: the words of each row; where its marks, bars and crosses
# are, across in percent of its axis, and how far down its marks are, in units of the picture.
SHOWN = """figure => {
    const picture = [...figure.querySelectorAll("svg[role=img]")].find(one => one.getBoundingClientRect().width)
    const all = (of, selector, get) => [...of.querySelectorAll(selector)].map(get)
    const of = (name) => (part) => Number(part.getAttribute(name).replace("%", ""))
    const rows = [...picture.querySelectorAll(":scope > svg > g")]
    if (rows.length) {
        const [, ...texts] = all(picture, ":scope > text", text => text.textContent)
        return rows.map((row, number) => ({
            drawn_by: "the page",
            name: texts[2 * number],
            words: texts[2 * number + 1],
            marks: [...all(row, "circle", of("cx")), ...all(row, "rect[transform]", of("x"))],
            heights: [...all(row, "circle", of("cy")), ...all(row, "rect[transform]", square => of("y")(square) + 4)],
            bars: all(row, "rect:not([transform])", of("width")),
            crosses: all(row, "svg", of("x")),
        }))
    }
    const { first, span } = JSON.parse(figure.dataset.positions)
    const styled = (selector, ...words) => [...picture.querySelectorAll(selector)].filter(part =>
        words.every(word => part.getAttribute("style").includes(word)))
    const numbers = styled("text", "middle").map(text => [of("x")(text), Number(text.textContent)])
    const [[left, least], [right, most]] = [numbers[0], numbers.at(-1)]
    const scale = (most - least) / (right - left)
    const across = x => 100 * ((x - left) * scale + least - first) / span
    const moved = part => part.getAttribute("transform").match(/[\\d.]+/g).map(Number)
    const bars = styled("path", "opacity: 0.45").map(bar => bar.getAttribute("d").match(/[\\d.]+/g).map(Number))
    const marks = [
        ...all(picture, "circle", mark => [of("cx")(mark), of("cy")(mark)]),
        ...styled("path[transform]", "fill: #").map(moved),
    ]
    const crosses = styled("path[transform]", "stroke: currentColor", "stroke-width: 2").map(moved)
    const names = styled("text", "700")
    const words = styled("text", "text-anchor: end").filter(text => !text.textContent.startsWith("time (s)"))
    return names.map((name, number) => {
        const top = of("y")(name) - 12
        const next = number + 1 < names.length ? of("y")(names[number + 1]) - 12 : top + 60
        const here = y => top < y && y < next
        return {
            drawn_by: "matplotlib",
            name: name.textContent,
            words: words.filter(text => here(of("y")(text))).map(text => text.textContent).join(),
            marks: marks.filter(([, y]) => here(y)).map(([x]) => across(x)),
            heights: marks.filter(([, y]) => here(y)).map(([, y]) => y),
            bars: bars.filter(([, y]) => here(y)).map(([x, , end]) => across(end) - across(x)),
            crosses: crosses.filter(([, y]) => here(y)).map(([x]) => across(x)),
        }
    })
}"""


class Figure:
    """A figure of a page, as a reader sees it."""

    def __init__(self, page: Page, kind: Kind) -> None:
        self.kind = kind
        self.element = page.locator("figure[data-positions]").nth(kind.number)
        self.handle = self.element.get_by_role("slider", name=re.compile(rf"^{kind.label} \(s\)$"))
        self.picture = self.element.locator("svg[role=img]:visible")

    def markup(self) -> Any:
        return self.picture.evaluate("picture => picture.outerHTML")

    def value(self) -> float:
        """The position, as a screen reader is told."""
        said = re.fullmatch(r"([\d.]+) s", self.handle.get_attribute("aria-valuetext") or "")
        assert said
        return float(said[1])

    def check(self) -> float:
        """The figure shows what a run gives that is made here and now; the value of the handle."""
        value = self.value()
        expect(self.element.locator("b")).to_have_text(f"{value:g} s")
        shown = self.element.evaluate(SHOWN)
        check_rows(self.kind, value, shown, self.picture.get_attribute("aria-label") or "", self.span())
        return value

    def span(self) -> float:
        """How long (s) its axis is."""
        return float(json.loads(self.element.get_attribute("data-positions") or "")["span"])


def check_rows(kind: Kind, value: float, shown: Any, alternative: str, span: float) -> None:
    """The ticks of a figure come from a run at this position, and the words are about them."""
    runs = kind.runs(value)
    assert [row["name"] for row in shown] == list(runs)
    assert alternative.startswith(f"Timeline, {kind.label}: {value:g} s. ")
    for row, (name, ticks) in zip(shown, runs.items(), strict=True):
        near = 1e-4 if row["drawn_by"] == "the page" else span / 1000  # a tenth of a pixel here and there
        times = [mark / 100 * span for mark in row["marks"]]
        assert times == pytest.approx([tick.real for tick in ticks], abs=near)
        lengths = [width / 100 * span for width in row["bars"]]
        assert lengths == pytest.approx([tick.duration for tick in ticks if tick.duration > 0], abs=near)
        assert re.search(rf"{name}: {len(ticks) or 'no'} tick", alternative)
        if " lost" in row["words"]:
            count = len(row["crosses"])
            assert f"{count or 'no'} tick{'' if count < 2 else 's'} lost" in row["words"]
            assert f"Lost ticks: {count}." in alternative


def opened(page: Page, address: str, kind: Kind) -> Figure:
    page.goto(address + kind.page)
    figure = Figure(page, kind)
    figure.handle.scroll_into_view_if_needed()
    return figure


def _each(figures: Sequence[Kind]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("kind", figures, ids=lambda kind: f"{Path(kind.page).stem}-{kind.number}")


kinds = _each(FIGURES)

# One with a row of marks, one with ticks that are lost, and one with many rows and bars. All of them are moved in
# real/judge; what they carry is looked at in tests/page.
some_kinds = _each([FIGURES[0], FIGURES[3], FIGURES[6]])
