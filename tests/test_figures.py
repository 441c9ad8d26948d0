"""The figures with a handle: moved in Chromium by pointer and by keyboard, they show the ticks of CPython's runs."""

from __future__ import annotations

import gzip
import json
import re
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple

import pytest
from bs4 import BeautifulSoup
from conftest import ROOT, faults
from playwright.sync_api import Browser, BrowserContext, Locator, Page, expect
from test_browser import FAINT, TOO_WIDE

from rosspin import Tick, rclpy, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.plots import with_handle
from rosspin.process import load_source
from rosspin.roscpp import timer_probe
from rosspin.run import run_captured

SPINNER = ROOT / "examples/my_robotics_pkg/src/spinner_py_node.py"
SPINNER_ROS2 = ROOT / "examples/my_robotics_pkg_ros2/my_robotics_pkg/spinner_py_node.py"
PROBE = ROOT / "examples/timing_probes/src/timer_probe.py"
PROBE_2 = ROOT / "examples/ros2/timer_probe.py"

Runs = Mapping[str, Sequence[Tick]]
Scheme = Literal["light", "dark"]


def spinner(path: Path, callback: str) -> Callable[[float], Runs]:
    text = path.read_text(encoding="utf-8")

    def run(delta: float) -> Runs:
        changed = text.replace("delta_t_in_seconds = 0.5", f"delta_t_in_seconds = {delta}")
        return {callback: run_captured(Simulation(), load_source(changed, str(path)), 2.0, []).ticks}

    return run


def probes(*words: str, seconds: float) -> Callable[[float], Runs]:
    def run(block: float) -> Runs:
        args = [f"_block:={block}", *words]
        return {"rospy": simulate(PROBE, seconds, args).ticks, "roscpp": timer_probe(seconds, args)}

    return run


def ros_2(*words: str, seconds: float) -> Callable[[float], Runs]:
    def run(block: float) -> Runs:
        parameters = [part for word in (f"block:={block}", *words) for part in ("-p", word)]
        return {"rclpy": simulate(PROBE_2, seconds, ["--ros-args", *parameters]).ticks}

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
    Kind("docs/tutorial.html", 0, "Time delta", spinner(SPINNER, "timerCallback")),
    Kind("notebooks/rate.html", 0, "Work in each pass", loops),
    Kind("notebooks/slow-callback.html", 0, "The third call takes", three("block_call:=3", seconds=6.2)),
    Kind("notebooks/slow-callback.html", 1, "Every call takes", three(seconds=6.2)),
    Kind("notebooks/ros2-rate.html", 0, "Work in each pass", ros2_loops),
    Kind("notebooks/ros2-executors.html", 0, "Work of the slow timer", executors),
    Kind("docs/how-timing-works.html", 0, "Every call takes", probes(seconds=6)),
    Kind("docs/how-timing-works.html", 1, "The third call takes", probes("_block_call:=3", seconds=6)),
    Kind("docs/ros2/how-timing-works.html", 0, "The third call takes", ros_2("block_call:=3", seconds=6)),
    Kind("docs/ros2/from-ros-1.html", 0, "The third call takes", three("block_call:=3", seconds=6)),
    Kind("docs/ros2/from-ros-1.html", 1, "Every call takes", three(seconds=6)),
    Kind("docs/ros2/tutorial.html", 0, "Time delta", spinner(SPINNER_ROS2, "timer_callback")),
]
PAGES = sorted({kind.page for kind in FIGURES})

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
    """The ticks of a figure are those of a run at this position, and the words are about them."""
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


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    with browser.new_context(viewport={"width": 1280, "height": 800}) as context:
        yield context


def opened(page: Page, address: str, kind: Kind) -> Figure:
    page.goto(address + kind.page)
    figure = Figure(page, kind)
    figure.handle.scroll_into_view_if_needed()
    return figure


def kinds(test: Any) -> Any:
    return pytest.mark.parametrize("kind", FIGURES, ids=lambda kind: f"{Path(kind.page).stem}-{kind.number}")(test)


# --- moving -----------------------------------------------------------------------------------------------------------


@kinds
def test_by_keyboard(context: BrowserContext, address: str, kind: Kind) -> None:
    page = context.new_page()
    wrong = faults(page, address)
    figure = opened(page, address, kind)
    first, before = figure.check(), figure.markup()
    figure.handle.focus()
    found = []
    for key in ("Home", "ArrowRight", "PageUp", "End", "ArrowLeft"):
        page.keyboard.press(key)
        found.append(figure.check())
    assert found[0] < found[1] < found[2] < found[3] > found[4] and first not in (found[0], found[3])
    # Moved back, it is as matplotlib drew it.
    while figure.value() > first:
        page.keyboard.press("ArrowLeft")
    assert figure.markup() == before
    assert not wrong


@kinds
def test_by_pointer(context: BrowserContext, address: str, kind: Kind) -> None:
    page = context.new_page()
    wrong = faults(page, address)
    figure = opened(page, address, kind)
    box = figure.handle.bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] / 2, y)
    page.mouse.down()
    found = []
    for share in (0.1, 0.45, 0.8):
        page.mouse.move(box["x"] + box["width"] * share, y, steps=3)
        found.append(figure.check())
    page.mouse.up()
    assert found == sorted(set(found))
    assert not wrong


def test_by_touch(browser: Browser, address: str) -> None:
    with browser.new_context(viewport={"width": 390, "height": 844}, has_touch=True) as context:
        figure = opened(context.new_page(), address, FIGURES[0])
        first = figure.value()
        box = figure.handle.bounding_box()
        assert box and box["height"] >= 24
        figure.handle.tap(position={"x": box["width"] - 5, "y": box["height"] / 2})
        assert figure.check() > first


def test_the_number_in_the_code_follows(context: BrowserContext, address: str) -> None:
    """What is moved is the number that stands in the lines beside the figure, and nothing else in them."""
    figure = opened(context.new_page(), address, FIGURES[0])
    code = context.pages[0].locator(".rosspin-beside pre")
    before = code.inner_text()
    assert before in "\n".join(line[8:] for line in SPINNER_ROS2.read_text(encoding="utf-8").splitlines())
    figure.handle.press("End")
    assert figure.value() != 0.5
    assert code.inner_text() == before.replace("0.5", f"{figure.value():g}")


@pytest.mark.parametrize("width", [358, 764])
def test_the_page_draws_each_position_as_matplotlib_does(browser: Browser, site: Path, width: int) -> None:
    """Also with ticks at one time or overlapping, with names that are no HTML, and with fewer kinds of rows."""
    blocks = [0.0, 0.7, 1.2, 1.499, 2.2]
    run = probes("_block_call:=3", seconds=6)
    runs = {
        block: {
            **run(block),
            "a<b & c": [tick._replace(real=tick.real + 0.0123456) for tick in run(block)["rospy"]],
            "at once": [Tick("A", n, n * 0.5, n * 0.5, block) for n in range(1, 7)],
        }
        for block in blocks
    }
    with browser.new_context(viewport={"width": width, "height": 800}) as context:
        page = context.new_page()
        for block in blocks:
            still = with_handle("The third call takes", "s", runs, at=block, period=0.5, kinds=2)
            page.set_content(f"<style>body{{margin:0}}</style>{still.html}")
            figure = Figure(page, FIGURES[3])
            by_matplotlib, alternative = figure.element.evaluate(SHOWN), figure.picture.get_attribute("aria-label")
            box = figure.picture.bounding_box()
            other = with_handle("The third call takes", "s", runs, at=blocks[block == 0.0], period=0.5, kinds=2)
            page.set_content(f"<style>body{{margin:0}}</style>{other.html}")
            page.add_script_tag(path=site / "_static/handles/handles.js")
            figure.handle.press("Home")
            for _ in range(blocks.index(block)):
                figure.handle.press("ArrowRight")
            assert figure.value() == block and figure.picture.get_attribute("aria-label") == alternative
            moved = figure.picture.bounding_box()
            assert box and moved and (moved["width"], moved["height"]) == (box["width"], box["height"])
            for here, there in zip(figure.element.evaluate(SHOWN), by_matplotlib, strict=True):
                assert (here.pop("drawn_by"), there.pop("drawn_by")) == ("the page", "matplotlib")
                for what in ("marks", "bars", "crosses"):
                    assert here.pop(what) == pytest.approx(there.pop(what), abs=0.1)
                assert here.pop("heights") == pytest.approx(there.pop("heights"), abs=1.5)
                assert here == there


def test_one_figure_moves_alone(context: BrowserContext, address: str) -> None:
    one, other = FIGURES[3:5]
    figure = opened(context.new_page(), address, one)
    beside = Figure(context.pages[0], other)
    before = beside.markup()
    figure.handle.press("End")
    assert beside.markup() == before and beside.handle.input_value() != beside.handle.get_attribute("max")


# --- where nothing moves ----------------------------------------------------------------------------------------------


@kinds
def test_without_javascript_the_first_position_stands(browser: Browser, address: str, kind: Kind) -> None:
    with browser.new_context(java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + kind.page)
        figure = page.locator("figure[data-positions]").nth(kind.number)
        expect(figure.locator("input")).to_be_hidden()
        picture = figure.locator("svg[role=img]:visible")
        expect(picture).to_have_attribute("aria-label", re.compile(f"^Timeline, {kind.label}: "))
        assert figure.evaluate(SHOWN)[0]["marks"]


def test_on_paper_the_first_position_stands(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    figure = opened(page, address, FIGURES[0])
    before, code = figure.markup(), page.locator(".rosspin-beside pre").inner_text()
    figure.handle.press("End")
    moved = figure.markup()
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    expect(figure.handle).to_be_hidden()
    assert figure.markup() == before
    assert page.locator(".rosspin-beside pre").inner_text() == code
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert figure.markup() == moved


# --- what it costs ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", PAGES)
def test_a_figure_is_small_and_brings_no_script(site: Path, name: str) -> None:
    page = BeautifulSoup((site / name).read_text(encoding="utf-8"), "html.parser")
    figures = page.select("figure[data-positions]")
    assert len(figures) == sum(kind.page == name for kind in FIGURES)
    for figure in figures:
        assert len(gzip.compress(str(figure).encode())) < 30_000
        assert not figure.select("script, [onclick], [oninput]")
    policy = str(page.select_one("meta[http-equiv]"))
    assert "script-src 'self' 'wasm-unsafe-eval'" in policy
    assert "unsafe-inline" not in policy.partition("script-src")[2].partition(";")[0]


def test_all_figures_with_a_handle_are_tested(site: Path) -> None:
    pages = {path.relative_to(site).as_posix(): path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert {name for name, text in pages.items() if re.search("<figure [^>]*data-positions=", text)} == set(PAGES)


def test_a_figure_needs_no_python(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url.removeprefix(address).partition("?")[0]))
    figure = opened(page, address, FIGURES[0])
    page.wait_for_load_state("networkidle")
    already = len(asked)
    figure.handle.press("End")
    figure.check()
    assert len(asked) == already
    ours = [url for url in asked if re.search(r"live/|handles/|pyodide", url)]
    assert ours == ["_static/handles/handles.js"]


def test_only_pages_with_such_a_figure_load_the_script(site: Path) -> None:
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            loads = "handles/handles.js" in path.read_text(encoding="utf-8")
            assert loads == (path.relative_to(site).as_posix() in PAGES), path


# --- how it looks -----------------------------------------------------------------------------------------------------

# The pictures that leave more than a little of the place that they have beside them.
NARROW = """() => [...document.querySelectorAll("article svg[role=img]")].filter(picture => {
    const width = element => element.getBoundingClientRect().width
    const place = width(picture.parentElement) // in which one of two may be seen
    return place && Math.max(...[...picture.parentElement.querySelectorAll(":scope > svg")].map(width)) < place - 40
}).map(picture => picture.getAttribute("aria-label"))"""


@pytest.mark.parametrize("width", [1280, 1920])
def test_figures_fill_the_width_of_the_text(site: Path, address: str, browser: Browser, width: int) -> None:
    names = [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    wrong = {}
    with browser.new_context(viewport={"width": width, "height": 800}) as context:
        page = context.new_page()
        for name in names:
            page.goto(address + name)
            wrong[name] = page.evaluate(NARROW)
    assert not {name: found for name, found in wrong.items() if found}


# The size (px) of the smallest lettering that is seen in the plots of a page.
LETTERING = """() => Math.min(...[...document.querySelectorAll("figure.rosspin-plot svg[role=img]")]
    .filter(picture => picture.getBoundingClientRect().width)
    .flatMap(picture => [...picture.querySelectorAll("text")].map(text =>
        parseFloat(getComputedStyle(text).fontSize) * (picture.getScreenCTM().a || 1))))"""


@pytest.mark.parametrize("width", [390, 1280])
def test_lettering_is_large_enough(site: Path, address: str, browser: Browser, width: int) -> None:
    pages = {path.relative_to(site).as_posix(): path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    with browser.new_context(viewport={"width": width, "height": 844}) as context:
        page = context.new_page()
        for name in sorted(name for name, text in pages.items() if 'class="rosspin-plot"' in text):
            page.goto(address + name)
            assert 11 <= (page.evaluate(LETTERING) or 99), name


def test_plots_follow_the_switch_of_the_theme(browser: Browser, address: str) -> None:
    """Not only the system's: here that is light."""
    with browser.new_context(viewport={"width": 1280, "height": 844}, color_scheme="light") as context:
        page = context.new_page()
        page.goto(address + "notebooks/rate.html")
        for theme in ("light", "dark"):
            page.evaluate("theme => Object.assign(document.documentElement.dataset, { theme, mode: theme })", theme)
            assert page.evaluate(FAINT) == []
            colour = page.locator("figure.rosspin-plot svg[role=img]:visible text").first.evaluate(
                "text => getComputedStyle(text).fill"
            )
            assert (max(map(int, re.findall(r"\d+", colour))) > 150) == (theme == "dark")


def test_plots_are_on_paper(browser: Browser, address: str) -> None:
    with browser.new_context(viewport={"width": 1280, "height": 844}, color_scheme="dark") as context:
        page = context.new_page()
        page.goto(address + "notebooks/rate.html")
        page.emulate_media(media="print")
        plots = page.locator(".cell_output figure.rosspin-plot")
        assert plots.count() == 5
        for index in range(5):
            text = plots.nth(index).locator("svg[role=img]:visible text").first
            assert text.evaluate("text => getComputedStyle(text).fill") == "rgb(0, 0, 0)"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_moved_figures_stay_in_the_page(browser: Browser, address: str, width: int, scheme: Scheme) -> None:
    with browser.new_context(viewport={"width": width, "height": 844}, color_scheme=scheme) as context:
        page = context.new_page()
        for kind in FIGURES:
            figure = opened(page, address, kind)
            figure.handle.press("End")
            assert page.evaluate(TOO_WIDE) + page.evaluate(FAINT) == []
            widths = figure.element.evaluate(
                "figure => [figure, ...figure.querySelectorAll('text')].map(part => part.getBoundingClientRect().right)"
            )
            assert max(widths[1:]) <= min(widths[0] + 1, width), kind


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("width", "height"), [(390, 844), (1280, 800)])
def test_the_first_screen(browser: Browser, address: str, width: int, height: int, scheme: Scheme) -> None:
    """What this is, a node that ticks beside its code, and the ways in: nobody has to scroll for them."""
    with browser.new_context(viewport={"width": width, "height": height}, color_scheme=scheme) as context:
        page = context.new_page()
        page.goto(address)

        def ends(place: Locator) -> float:
            expect(place).to_be_visible()
            box = place.bounding_box()
            assert box
            return box["y"] + box["height"]

        article = page.locator("article")
        seen = [article.locator(what) for what in ("p >> nth=0", ".rosspin-beside pre", "figure svg[role=img]:visible")]
        names = "ROS 2 in Python", "ROS 1 in Python", "ROS 1 in C++", "Try an exercise"
        ways = [article.get_by_role("link", name=name) for name in names]
        assert max(map(ends, [*seen, *ways])) < height
