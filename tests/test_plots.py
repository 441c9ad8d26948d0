"""Timing plots: pictures that say what they show, and fit into any page."""

from __future__ import annotations

import html
import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from rosspin import Tick, simulate
from rosspin.plots import Figure, lateness, period_histogram, timeline, with_handle

PLOTS = [timeline, lateness, period_histogram]
SVG = "{http://www.w3.org/2000/svg}"


def ticks(source: str = "timerCallback", late: float = 0.0, count: int = 4) -> list[Tick]:
    return [Tick(source, n, n * 0.5, n * 0.5 + late * n, 0.1) for n in range(1, count + 1)]


def parse(figure: Figure) -> ElementTree.Element:
    return ElementTree.fromstring(figure.svg)


@pytest.fixture(params=PLOTS, ids=lambda plot: plot.__name__)
def plot(request: pytest.FixtureRequest) -> Any:
    return request.param


def test_the_text_alternative_is_made_from_the_ticks() -> None:
    assert timeline(ticks()).alt == (
        "Timeline. timerCallback: 4 ticks from 0.500 s to 2.000 s. All 4 ticks were on time."
    )
    assert lateness(ticks(late=0.001)).alt == (
        "Lateness of each tick. timerCallback: Half of the 4 ticks were at most 2.5 ms late; the latest was 4 ms late."
    )
    assert period_histogram(ticks()).alt == (
        "Distribution of periods. timerCallback: Every period was 0.5 s; there was no jitter."
    )
    assert timeline(ticks(count=1)).alt.startswith("Timeline. timerCallback: 1 tick at 0.500 s.")
    assert timeline(ticks() + ticks("Rate")).alt.count("4 ticks from") == 2


def test_ticks_at_the_same_time_stay_in_their_row() -> None:
    """They are drawn one above the other, but not over what stands above the plot."""
    drawn = parse(timeline([Tick("A", n, 0.5, 0.5, 0) for n in range(1, 50)]))
    assert {dot.attrib["cy"] for dot in drawn.iter(f"{SVG}circle")} == {"34", "24", "14"}


def test_the_axis_goes_to_the_end_of_the_run() -> None:
    (dot,) = parse(timeline(ticks(count=1), end=2.0)).iter(f"{SVG}circle")
    assert dot.attrib["cx"] == "25%"
    assert timeline(ticks(), end=1.0).svg == timeline(ticks()).svg


def test_a_period_draws_the_whole_grid_and_crosses_out_the_lost_ticks() -> None:
    late = [Tick("A", 1, 0.5, 0.5, 2.2), Tick("A", 2, 1.0, 2.7, 0), Tick("A", 3, 1.5, 3.2, 0)]
    crossed = parse(timeline(late, 0.5))
    assert timeline(late, 0.5).alt.endswith("Lost ticks: 3.")
    assert [cross.attrib["x"] for cross in crossed.iter(f"{SVG}svg") if "x" in cross.attrib] == share(1.5, 2.0, 2.5)
    assert [line.attrib["x1"] for line in crossed.findall(f"{SVG}g/{SVG}line")] == share(0.5, 1.0, 1.5, 2.0, 2.5, 3.0)
    assert "lost" in timeline(late, 0.5).svg
    assert "lost" not in timeline(late).svg.lower()


def share(*times: float, end: float = 3.2) -> list[str]:
    """Where times are across a timeline that ends at 3.2 s."""
    return [f"{round(100 * time / end, 3):g}%" for time in times]


def test_the_alternative_is_on_the_picture(plot: Callable[..., Figure]) -> None:
    figure = plot(ticks('a<b & "c"'))
    root = parse(figure)
    assert root.attrib["role"] == "img"
    assert root.attrib["aria-label"] == figure.alt
    assert 'a<b & "c"' in figure.alt
    assert repr(figure) == f"<Figure: {figure.alt}>"
    assert figure._repr_html_() == f'<figure class="rosspin-plot">{figure.svg}</figure>'


def test_it_takes_its_colours_and_type_from_the_page(plot: Callable[..., Figure]) -> None:
    svg = plot(ticks()).svg
    assert "currentColor" in svg
    assert set(re.findall(r"font-family: ([^;\"]*)", svg)) == {"inherit"}
    assert "<style" not in svg  # it would style the whole page
    assert not re.search(r"#000000|#ffffff|\bwhite\b|\bblack\b", svg)


def test_it_fills_its_place_and_its_text_keeps_its_size(plot: Callable[..., Figure]) -> None:
    """All that is drawn within is placed in percent of the width, but for names and numbers that stand beside it."""
    root = parse(plot({"Rate": ticks(), "Timer": ticks(late=0.1)}))
    assert root.attrib["width"] == "100%" and "viewBox" not in root.attrib
    places = [(name, at) for part in root.iter() for name, at in part.attrib.items() if name in ("x", "cx", "x1", "x2")]
    fixed = {at for _, at in places if not at.endswith("%")}
    assert len(places) > 20
    assert all(float(at) <= 0 for at in fixed)


def test_it_loads_nothing(plot: Callable[..., Figure]) -> None:
    for element in parse(plot(ticks())).iter():
        for name, value in element.attrib.items():
            if name.endswith(("href", "src")) or "url(" in value:
                assert "#" in value and "//" not in value
    # The only address is the name of XML's own namespace.
    assert set(re.findall(r"https?://[^\"' ]*", plot(ticks()).svg)) == {"http://www.w3.org/2000/svg"}


def test_a_page_can_have_many_plots(plot: Callable[..., Figure]) -> None:
    assert " id=" not in plot(ticks()).svg


def test_the_same_ticks_give_the_same_bytes(plot: Callable[..., Figure]) -> None:
    assert plot(ticks()).svg == plot(ticks()).svg


def test_axes_have_units() -> None:
    texts = {plot: "".join(parse(plot(ticks())).itertext()) for plot in PLOTS}
    assert "time (s)" in texts[timeline]
    assert "lateness (ms)" in texts[lateness] and "time expected (s)" in texts[lateness]
    assert "period (ms)" in texts[period_histogram] and "number of periods" in texts[period_histogram]


def test_a_saved_file_stands_alone_in_light_and_dark(tmp_path: Path, plot: Callable[..., Figure]) -> None:
    path = tmp_path / "plot.svg"
    plot(ticks()).save(path)
    root = ElementTree.parse(path).getroot()
    style = root.find(f"{SVG}style")
    assert style is not None and style.text
    assert "prefers-color-scheme:dark" in style.text
    assert "inherit" not in path.read_text()


def test_names_can_be_given(plot: Callable[..., Figure]) -> None:
    figure = plot({"with Rate": ticks(), "with sleep": ticks(late=0.01), "empty": []})
    assert "with Rate: " in figure.alt and "with sleep: " in figure.alt
    assert "with Rate" in "".join(parse(figure).itertext())


def test_bars_are_as_long_as_the_callbacks() -> None:
    def bars(*durations: float) -> list[str]:
        root = parse(timeline([Tick("A", n, n, n, long) for n, long in enumerate(durations)]))
        return [bar.attrib["width"] for bar in root.iter(f"{SVG}rect")]

    assert bars(0.0, float("nan")) == []
    assert bars(0.5, 1.0) == share(0.5, 1.0, end=2.0)


def test_ticks_at_the_same_time_stand_one_above_the_other() -> None:
    at_once = parse(timeline([Tick("A", n, n * 0.5, 2.0, 0.0) for n in (1, 2, 3)]))
    heights = [float(mark.attrib["cy"]) for mark in at_once.iter(f"{SVG}circle")]
    assert heights[0] > heights[1] > heights[2]


def test_calls_that_overlap_are_in_lanes() -> None:
    def bars(ticks: list[Tick]) -> list[tuple[float, float]]:
        found = re.findall(r'<rect x="[^"]*" y="([^"]*)" width="[^"]*" height="([^"]*)"', timeline(ticks).svg)
        return [(float(y), float(y) + float(height)) for y, height in found]

    def calls(duration: float) -> list[Tick]:
        return [Tick("A", n, n * 0.5, n * 0.5, duration) for n in range(1, 7)]

    assert len(set(bars(calls(0.5)))) == 1
    for count, duration in ((2, 0.8), (3, 1.2), (4, 1.7)):
        found = bars(calls(duration))
        lanes = sorted(set(found))
        assert found == [lanes[n % count] for n in range(6)]
        assert all(above[1] <= below[0] for above, below in pairwise(lanes))


def test_rows_take_turns_with_their_marks() -> None:
    runs = {name: [Tick("A", 1, 0.5, 0.5, 0.0)] for name in "abcd"}
    for kinds, wanted in {3: ["circle", "rect", "circle", "circle"], 2: ["circle", "rect", "circle", "rect"]}.items():
        assert re.findall("<(circle|rect)", timeline(runs, kinds=kinds).svg) == wanted


@pytest.mark.parametrize("values", [[0.5], [0.0], [1e-9, 2e-9], [-3.0, 4.0], [12345.6, 12345.7], [0.0, 1e6]])
def test_an_axis_has_a_few_round_numbers(values: list[float]) -> None:
    axis = parse(lateness([Tick("A", 1, value, value, 0.0) for value in values]))
    numbers = [text.text or "" for text in axis.iter(f"{SVG}text") if text.attrib.get("text-anchor") == "middle"]
    assert 1 <= len(numbers) <= 8
    assert all(re.fullmatch(r"-?[\d.e+-]+", number) for number in numbers)


def test_a_histogram_counts_every_period() -> None:
    reals = [0.0, 0.4, 0.9, 1.4, 2.0]
    bars = parse(period_histogram([Tick("A", n, 0.0, real, 0.0) for n, real in enumerate(reals)])).iter(f"{SVG}rect")
    heights = [float(bar.attrib["height"]) for bar in bars]
    assert len(heights) == 3
    assert heights[1] == max(heights) == 2 * heights[0] == 2 * heights[2]


def test_one_tick_is_enough_and_none_are_too_few(plot: Callable[..., Figure]) -> None:
    alt = plot(ticks(count=1)).alt
    assert "1 tick" in alt or "The only tick" in alt or "no second tick" in alt
    nothings: list[Any] = [[], {"a": []}]
    for nothing in nothings:
        with pytest.raises(ValueError, match="there are no ticks to plot"):
            plot(nothing)


def test_plotting_needs_no_other_package() -> None:
    code = "import sys; before = set(sys.modules); import rosspin.plots; print(*set(sys.modules) - before)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {module.partition(".")[0] for module in modules} - sys.stdlib_module_names <= {"rosspin", "greenlet"}


# --- a plot with a handle ---------------------------------------------------------------------------------------------


def node(work: float) -> Any:
    def loop() -> None:
        from rosspin import rospy

        rospy.init_node("loop")
        rate = rospy.Rate(2)
        while not rospy.is_shutdown():
            rospy.sleep(work)
            rate.sleep()

    return loop


def carried(figure: Figure) -> Any:
    """What the page's script is given."""
    (data,) = re.findall(r" data-positions='([^']*)'", figure._repr_html_())
    return json.loads(html.unescape(data))


@pytest.fixture(scope="module")
def runs() -> dict[float, list[Tick]]:
    return {work: list(simulate(node(work), 3.0).ticks) for work in (0.0, 0.1, 0.6, 1.7)}


def test_a_handle_carries_the_ticks_of_every_position(runs: dict[float, list[Tick]]) -> None:
    data = carried(with_handle("Work & rest", "s", runs, at=0.1))
    assert [value for value, *_ in data["positions"]] == ["0", "0.1", "0.6", "1.7"]
    assert [words for _, words, *_ in data["positions"]] == ["0 s", "0.1 s", "0.6 s", "1.7 s"]
    for group, (*_, alternative, [row]) in zip(runs.values(), data["positions"], strict=True):
        assert [tuple(tick) for tick in row[4]] == [
            (round(tick.real, 6), round(tick.duration, 6) if tick.duration > 0 else 0) for tick in group
        ]
        assert f"Rate: {len(group)} ticks" in alternative
    assert data["positions"][2][3][0][1] == "6 ticks, one every 0.6 s"


def test_a_handle_stands_at_its_first_position(runs: dict[float, list[Tick]]) -> None:
    """As it does without the page's script, in print and in JupyterLab: the handle itself is hidden there."""
    figure = with_handle('Work "here"', "s", runs, at=0.6)
    assert figure.alt.startswith('Timeline, Work "here": 0.6 s. Rate: 6 ticks')
    assert parse(figure).attrib["aria-label"] == figure.alt
    label = re.search(r"<label (.*?)>(.*?)<input (.*?)></label>", figure._repr_html_())
    assert label
    assert "hidden" in label[1]
    assert label[2] == 'Work &quot;here&quot; (s) <b aria-hidden="true">0.6 s</b> '
    assert all(part in label[3] for part in ('type="range"', 'max="3"', 'value="2"', 'aria-valuetext="0.6 s"'))
    marks = [float(mark.attrib["cx"][:-1]) for mark in parse(figure).iter(f"{SVG}circle")]
    assert [round(mark * carried(figure)["span"] / 100, 3) for mark in marks] == [0.0, 0.6, 1.2, 1.8, 2.4, 3.0]


def test_with_a_period_a_handle_says_who_keeps_the_grid(runs: dict[float, list[Tick]]) -> None:
    words = [rows[0][1] for *_, rows in carried(with_handle("Work", "s", runs, at=0.0, period=0.5))["positions"]]
    assert words[:3] == [
        "keeps its grid, no tick lost",
        "keeps its grid, no tick lost",
        "back to back, every 0.6 s, no tick lost",
    ]


def test_a_handle_needs_its_position_and_ticks(runs: dict[float, list[Tick]]) -> None:
    with pytest.raises(ValueError, match=r"0\.2 is no position of the handle: they are 0\.0, 0\.1"):
        with_handle("Work", "s", runs, at=0.2)
    with pytest.raises(ValueError, match="there are no ticks"):
        with_handle("Work", "s", {**runs, 2.0: []}, at=0.1)


def test_what_a_handle_says_is_text(runs: dict[float, list[Tick]]) -> None:
    figure = with_handle("<b>'", "<i>", {0.0: {"<u>'": runs[0.0]}}, at=0.0)
    assert not re.search(r"<i>|<u>|<b>'", figure._repr_html_())
    assert carried(figure)["positions"][0][3][0][0] == "<u>'"
