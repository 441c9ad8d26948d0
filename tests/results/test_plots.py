"""Timing plots: Axes of matplotlib's that say what they show, and figures that fit into any page."""

from __future__ import annotations

import gzip
import html
import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import matplotlib
import nbclient
import nbformat
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.colors import to_hex

from rosspin import FaultEvent, Run, Tick, plots, simulate
from rosspin.plots import Movable, picture, pictures, with_handle
from rosspin.plots.pictures import alternative, figure_of, page, save

pytestmark = pytest.mark.shares(3)


# Much of Axes is typed as "object".
compare: Any = plots.compare
timeline: Any = plots.timeline
lateness: Any = plots.lateness
period_histogram: Any = plots.period_histogram

PLOTS = [timeline, lateness, period_histogram]
BLUE, VERMILION, GREEN = "#0072b2", "#d55e00", "#009e73"


def ticks(source: str = "timerCallback", late: float = 0.0, count: int = 4) -> list[Tick]:
    return [Tick(source, n, n * 0.5, n * 0.5 + late * n, 0.1) for n in range(1, count + 1)]


@pytest.fixture(autouse=True)
def closed() -> Iterator[None]:
    pyplot.switch_backend("agg")
    pyplot.close("all")  # of what other tests have left open
    yield
    pyplot.close("all")


@pytest.fixture(params=PLOTS, ids=lambda plot: plot.__name__)
def plot(request: pytest.FixtureRequest) -> Any:
    return request.param


def marks(ax: Any) -> list[list[tuple[float, float]]]:
    """Where the marks of each row of a timeline are; the crosses are left out."""
    lines = [line for line in ax.lines if line.get_marker() in ("o", "s")]
    return [[(float(x), float(y)) for x, y in line.get_xydata()] for line in lines]


def lines(ax: Any) -> list[list[float]]:
    """Where the lines for expected times are in each row."""
    return [[round(float(path[0][0]), 6) for path in found.get_segments()] for found in ax.collections]


def bars(ax: Any) -> list[tuple[float, float]]:
    return [(round(bar.get_x(), 6), round(bar.get_width(), 6)) for bar in ax.patches]


def pictures_in(ax: Any) -> list[ElementTree.Element]:
    return [ElementTree.fromstring(svg) for svg in re.findall(r"<svg.*?</svg>(?=<svg class|<fig|</fig)", html_of(ax))]


def html_of(ax: Any) -> str:
    return re.sub(r'<svg xmlns="[^"]*" ', "<svg ", page(figure_of(ax)))


# --- what is drawn ----------------------------------------------------------------------------------------------------


def test_a_plot_is_axes_of_a_figure_of_its_own(plot: Callable[..., Any]) -> None:
    axes = [plot(ticks()), plot(ticks())]
    assert all(isinstance(ax, Axes) for ax in axes)
    assert [ax.figure.number for ax in axes] == pyplot.get_fignums() == [1, 2]  # plt.show() shows them


def test_it_is_drawn_where_one_wants_it(plot: Callable[..., Any]) -> None:
    figure, (above, below) = pyplot.subplots(2)
    assert plot(ticks(), ax=below) is below
    assert below.has_data() and not above.has_data()
    assert len(pyplot.get_fignums()) == 1
    assert figure.get_size_inches() == pytest.approx(pyplot.rcParams["figure.figsize"])


def test_an_overview_is_all_three_and_the_rows_name_the_colours() -> None:
    figure = plots.overview({"one": ticks(), "other": ticks(late=0.01)})
    assert [ax.get_xlabel().partition(" (")[0] for ax in figure.axes] == ["time", "time expected", "period"]
    assert not any(ax.get_legend() for ax in figure.axes)
    assert pyplot.get_fignums() == []


def test_panels_that_share_their_time_have_room_for_both() -> None:
    figure, (above, below) = pyplot.subplots(2, sharex=True)
    timeline(ticks(count=9), ax=above)
    timeline(ticks(count=2), ax=below)
    assert above.get_xlim() == below.get_xlim() and above.get_xlim()[1] > 4.5


def test_only_marks_within_the_limits_are_on_a_page() -> None:
    ax = timeline(ticks(count=9))
    ax.set_xlim(0.9, 2.1)
    assert html_of(ax).count("<circle") == 2 * 3


def test_the_label_is_made_from_the_ticks() -> None:
    assert timeline(ticks()).get_label() == (
        "Timeline. timerCallback: 4 ticks from 0.500 s to 2.000 s. All 4 ticks were on time."
    )
    assert lateness(ticks(late=0.001)).get_label() == (
        "Lateness of each tick. timerCallback: Half of the 4 ticks were at most 2.5 ms late; the latest was 4 ms late."
    )
    assert period_histogram(ticks()).get_label() == (
        "Distribution of periods. timerCallback: Every period was 0.5 s; there was no jitter."
    )
    assert str(timeline(ticks(count=1)).get_label()).startswith("Timeline. timerCallback: 1 tick at 0.500 s.")
    assert str(timeline(ticks() + ticks("Rate")).get_label()).count("4 ticks from") == 2


def test_marks_and_lines_are_where_the_ticks_are() -> None:
    ax = timeline({"Timer": ticks(), "Rate": ticks(late=0.1)})
    assert [[x for x, _ in row] for row in marks(ax)] == [[0.5, 1.0, 1.5, 2.0], [0.6, 1.2, 1.8, 2.4]]
    assert lines(ax) == [[0.5, 1.0, 1.5, 2.0]] * 2
    assert [label.get_text() for label in ax.get_yticklabels()] == ["Timer", "Rate"]
    first, second = (row[0][1] for row in marks(ax))
    assert 0 < first < 1 < second < 2 and ax.get_ylim() == (2, 0)  # from above


def test_rows_take_turns_with_their_marks_and_colours() -> None:
    runs = {name: [Tick("A", 1, 0.5, 0.5, 0.0)] for name in "abcd"}
    for kinds, wanted in {3: [BLUE, VERMILION, GREEN, BLUE], 2: [BLUE, VERMILION, BLUE, VERMILION]}.items():
        found = [line for line in timeline(runs, kinds=kinds).lines if line.get_marker() in ("o", "s")]
        assert [to_hex(line.get_color()) for line in found] == wanted
        assert [line.get_marker() for line in found][:2] == ["o", "s"]


def test_ticks_at_the_same_time_stand_one_above_the_other_in_their_row() -> None:
    [row] = marks(timeline([Tick("A", n, 0.5, 0.5, 0) for n in range(1, 50)]))
    heights = [y for _, y in row]
    assert heights[0] > heights[1] > heights[2] > 0 and set(heights) == set(heights[:3])


def test_the_axis_goes_to_the_end_of_the_run() -> None:
    for ax in (timeline(ticks(count=1), end=2.0), timeline(Run("", ticks(count=1), 0, "simulated", 2.0))):
        assert 2.0 < ax.get_xlim()[1] < 2.1 and -0.1 < ax.get_xlim()[0] < 0
    assert timeline(ticks(), end=1.0).get_xlim() == timeline(ticks()).get_xlim()
    assert timeline(Run("", ticks(), 0, "wall", math.inf)).get_xlim() == timeline(ticks()).get_xlim()


def test_a_period_draws_the_whole_grid_and_crosses_out_the_lost_ticks() -> None:
    late = [Tick("A", 1, 0.5, 0.5, 2.2), Tick("A", 2, 1.0, 2.7, 0), Tick("A", 3, 1.5, 3.2, 0)]
    ax = timeline(late, 0.5)
    assert str(ax.get_label()).endswith("Lost ticks: 3.")
    [crosses] = [line for line in ax.lines if line.get_marker() == "x"]
    assert list(crosses.get_xdata()) == [1.5, 2.0, 2.5]
    assert lines(ax) == [[0.5, 1.0, 1.5, 2.0, 2.5, 3.0]]
    assert "cross: lost" in ax.get_xlabel() and "cross" not in timeline(late).get_xlabel()


def test_bars_are_as_long_as_the_callbacks() -> None:
    def of(*durations: float) -> list[tuple[float, float]]:
        return bars(timeline([Tick("A", n, n, n, long) for n, long in enumerate(durations)]))

    assert of(0.0, math.nan) == []
    assert of(0.5, 1.0, math.nan) == [(0.0, 0.5), (1.0, 1.0)]


def test_calls_that_overlap_are_in_lanes() -> None:
    def of(duration: float) -> list[tuple[float, float]]:
        ax = timeline([Tick("A", n, n * 0.5, n * 0.5, duration) for n in range(1, 7)])
        return [(bar.get_y(), bar.get_y() + bar.get_height()) for bar in ax.patches]

    assert len(set(of(0.5))) == 1
    for count, duration in ((2, 0.8), (3, 1.2), (4, 1.7)):
        found = of(duration)
        lanes = sorted(set(found))
        assert found == [lanes[n % count] for n in range(6)]
        assert all(above[1] <= below[0] for above, below in pairwise(lanes))


def test_axes_have_units() -> None:
    assert timeline(ticks()).get_xlabel().startswith("time (s)")
    assert (lateness(ticks()).get_xlabel(), lateness(ticks()).get_ylabel()) == ("time expected (s)", "lateness (ms)")
    histogram = period_histogram(ticks())
    assert (histogram.get_xlabel(), histogram.get_ylabel()) == ("period (ms)", "number of periods")


def test_lateness_is_in_milliseconds() -> None:
    ax = lateness({"a": ticks(), "b": ticks(late=0.01)})
    found = {line.get_label(): [tuple(point) for point in line.get_xydata()] for line in ax.lines[1:]}
    assert found["b"] == [pytest.approx((n * 0.5, n * 10.0)) for n in range(1, 5)]
    legend = ax.get_legend()
    assert legend and [text.get_text() for text in legend.get_texts()] == ["a", "b"]


@pytest.mark.parametrize("values", [[0.5], [0.0], [1e-9, 2e-9], [-3.0, 4.0], [12345.6, 12345.7], [0.0, 1e6]])
def test_an_axis_has_a_few_numbers(plot: Callable[..., Any], values: list[float]) -> None:
    ax = plot([Tick("A", 1, value, value, 0.0) for value in values])
    low, high = ax.get_xlim()
    assert 1 <= len([place for place in ax.get_xticks() if low <= place <= high]) <= 12


def test_a_histogram_counts_every_period() -> None:
    reals = [0.0, 0.4, 0.9, 1.4, 2.0]
    heights = [
        bar.get_height() for bar in period_histogram([Tick("A", n, 0, t, 0) for n, t in enumerate(reals)]).patches
    ]
    assert [height for height in heights if height] == [1, 2, 1]


def test_compare_puts_runs_below_each_other() -> None:
    timer, rate = Run("", ticks(), 0, "simulated", 2.0), Run("", ticks("Rate", count=9), 0, "simulated", 5.0)
    ax = compare({"Timer": timer, "Rate": rate})
    assert [label.get_text() for label in ax.get_yticklabels()] == ["Timer", "Rate"]
    assert 5.0 < ax.get_xlim()[1] < 5.2
    assert "Timer: 4 ticks" in ax.get_label() and "Rate: 9 ticks" in ax.get_label()
    assert "<figcaption>simulated</figcaption>" in html_of(ax)


def test_compare_gives_a_source_its_colour_in_each_run() -> None:
    one, other = [*ticks("slow"), *ticks("quick")], [*ticks("quick"), *ticks("slow")]
    ax = compare({"spin": one, "own": other, "none": []}, 0.5)
    names = [label.get_text() for label in ax.get_yticklabels()]
    assert names == ["spin: slow", "spin: quick", "own: slow", "own: quick", "none: slow", "none: quick"]
    found = [to_hex(line.get_color()) for line in ax.lines if line.get_marker() in ("o", "s")]
    assert found == [BLUE, VERMILION] * 3


# --- what is odd ------------------------------------------------------------------------------------------------------


def test_one_tick_is_enough_and_none_are_too_few(plot: Callable[..., Any]) -> None:
    label = str(plot(ticks(count=1)).get_label())
    assert "1 tick" in label or "The only tick" in label or "no second tick" in label
    nothings: list[Any] = [[], {"a": []}, {}, Run("", [], 0, "simulated", 1.0)]
    for nothing in nothings:
        with pytest.raises(ValueError, match="there are no ticks to plot"):
            plot(nothing)
    with pytest.raises(ValueError, match="there are no ticks to plot"):
        compare({})


@pytest.mark.parametrize("period", [0, 0.0, -0.5, math.nan, math.inf])
def test_a_period_is_above_0(period: float) -> None:
    with pytest.raises(ValueError, match=rf"a period is above 0 s, not {period!r}"):
        timeline(ticks(), period)


def test_a_period_is_not_too_short_to_draw() -> None:
    with pytest.raises(ValueError, match="a period of 1e-09 s is too short for ticks up to 2 s"):
        timeline(ticks(), 1e-9)


@pytest.mark.parametrize("time", [math.nan, math.inf])
def test_a_time_is_finite(plot: Callable[..., Any], time: float) -> None:
    for tick in (Tick("A", 2, time, 1.0, 0.1), Tick("A", 2, 1.0, time, 0.1)):
        with pytest.raises(
            ValueError, match=r"a time that is not finite cannot be plotted: Tick\(source='A', number=2"
        ):
            plot([*ticks("A"), tick])


def test_of_very_many_ticks_those_are_drawn_that_stand_out(plot: Callable[..., Any]) -> None:
    many = [Tick("A", n, n * 1e-3, n * 1e-3 + (0.3 if n == 54_321 else 1e-4), 5e-4) for n in range(100_000)]
    ax = plot(many)
    assert len(gzip.compress(page(figure_of(ax)).encode())) < 12_000
    assert "100000 ticks" in ax.get_label() or "periods" in ax.get_label()
    if plot is not period_histogram:
        said = re.search(r"\n([\d,]+) of 100,000 ticks drawn", ax.get_xlabel())
        assert said and 100 < int(said[1]) < 600
    if plot is lateness:
        assert max(y for line in ax.lines for y in line.get_ydata()) == pytest.approx(300)


def test_names_can_be_given(plot: Callable[..., Any]) -> None:
    ax = plot({"with Rate": ticks(), "with sleep": ticks(late=0.01), "empty": []})
    assert "with Rate: " in ax.get_label()
    assert "with Rate" in html_of(ax)


# --- on a page --------------------------------------------------------------------------------------------------------


def test_a_page_has_it_wide_and_narrow(plot: Callable[..., Any]) -> None:
    ax = plot({"Rate": ticks(), "Timer": ticks(late=0.1)})
    size = figure_of(ax).get_size_inches()
    drawn = pictures_in(ax)
    assert [svg.attrib["class"] for svg in drawn] == ["rosspin-wide", "rosspin-narrow"]
    for svg, width, place in zip(drawn, (760, 365), (764, 312), strict=True):
        assert svg.attrib["width"] == "100%" and svg.attrib["viewBox"].split()[2] == str(width)
        sizes = [
            float(size)
            for text in svg.iter("text")
            for size in re.findall(r"font-size: ([\d.]+)px", text.attrib["style"])
        ]
        assert sizes and min(sizes) * place / width >= 11
    assert list(figure_of(ax).get_size_inches()) == list(size)


def test_the_alternative_is_on_the_picture(plot: Callable[..., Any]) -> None:
    ax = plot(ticks('a<b & "c"'))
    assert 'a<b & "c"' in ax.get_label()
    for svg in pictures_in(ax):
        assert (svg.attrib["role"], svg.attrib["aria-label"]) == ("img", ax.get_label())


def test_the_alternative_can_be_set_and_follows_the_limits() -> None:
    ax = timeline(ticks())
    ax.set_xlim(0.9, 1.6)
    assert alternative(figure_of(ax)).endswith("were on time. Shown is the part from 0.9 to 1.6.")
    ax.set_xlim(-1, 3)
    ax.set_label("My robot.")
    assert alternative(figure_of(ax)) == "My robot."
    figure, (above, below) = pyplot.subplots(2)
    timeline(ticks(), ax=above)
    lateness(ticks(), ax=below)
    assert alternative(figure) == f"{above.get_label()} {below.get_label()}"


def test_what_is_drawn_twice_in_one_place_is_said_of_both() -> None:
    ax = lateness(ticks("A"))
    lateness(ticks("B"), ax=ax)
    assert "A: All 4" in ax.get_label() and "B: All 4" in ax.get_label()


def test_a_caption_says_where_the_data_come_from() -> None:
    simulated, measured = Run("", ticks(), 0, "simulated", 2.0), Run("", ticks(), 0, "wall", 2.0)
    captions = {
        "<figcaption>simulated</figcaption>": timeline(simulated),
        "<figcaption>a &lt; b</figcaption>": timeline(simulated, caption="a < b"),
        "</svg></figure>": timeline({"a": simulated, "b": measured}),
    }
    for caption, ax in captions.items():
        assert caption in html_of(ax)
    figure, panels = pyplot.subplots(3)
    for ax, caption in zip(panels, ("above: A", "below: B", "below: B"), strict=True):
        timeline(ticks(), caption=caption, ax=ax)
    assert "<figcaption>above: A; below: B</figcaption>" in page(figure)


def test_it_takes_its_colours_and_type_from_the_page(plot: Callable[..., Any]) -> None:
    text = html_of(plot(ticks()))
    assert "currentColor" in text
    assert not re.search(r"font-family|#000000|#ffffff|\bwhite\b|\bblack\b", text)
    assert set(re.findall(r"#[0-9a-f]{6}", text)) <= {BLUE, VERMILION, GREEN}


def test_its_style_is_for_nothing_else_on_the_page(plot: Callable[..., Any]) -> None:
    [style] = re.findall("<style>(.*?)</style>", html_of(plot(ticks())))
    assert set(re.findall(r"(?:^|[{}])\s*([^@{}]+?)\s*(?=\{)", style)) == {
        ".rosspin-plot",
        ".rosspin-wide",
        ".rosspin-narrow",
    }


def test_it_loads_nothing_and_no_id_is_there_twice(plot: Callable[..., Any]) -> None:
    text = page(figure_of(plot(ticks())))
    assert not re.search(r" id=|href|src=|url\(", text)
    # The only address is the name of XML's own namespace.
    assert set(re.findall(r"https?://[^\"' ]*", text)) == {"http://www.w3.org/2000/svg"}


def test_what_is_beyond_the_limits_is_cut_off() -> None:
    """By the box of an SVG within: a clip path would need an id."""
    ax = timeline(ticks(count=8))
    ax.set_xlim(0.9, 1.6)
    for svg in pictures_in(ax):
        [clip] = [part for part in svg.iter("svg") if part is not svg and part.find("circle") is not None]
        assert "overflow" not in clip.attrib and float(clip.attrib["width"]) <= float(svg.attrib["viewBox"].split()[2])


def test_the_same_ticks_give_the_same_bytes(plot: Callable[..., Any], tmp_path: Path) -> None:
    assert html_of(plot(ticks())) == html_of(plot(ticks()))
    for suffix in pictures.SUFFIXES:
        files = [tmp_path / f"{name}{suffix}" for name in "ab"]
        for file in files:
            save(figure_of(plot(ticks())), file)
        assert files[0].read_bytes() == files[1].read_bytes()


def test_a_saved_file_is_what_its_suffix_says(tmp_path: Path, plot: Callable[..., Any]) -> None:
    begins = {".png": b"\x89PNG", ".pdf": b"%PDF", ".svg": b"<?xml"}
    for suffix in pictures.SUFFIXES:
        save(figure_of(plot(ticks())), tmp_path / f"plot{suffix}")
        assert (tmp_path / f"plot{suffix}").read_bytes().startswith(begins[suffix])


def test_a_saved_svg_stands_alone_in_light_and_dark(tmp_path: Path, plot: Callable[..., Any]) -> None:
    save(figure_of(plot(ticks())), tmp_path / "plot.svg")
    root = ElementTree.parse(tmp_path / "plot.svg").getroot()
    style = root.find("{http://www.w3.org/2000/svg}style")
    assert style is not None and style.text
    assert "prefers-color-scheme:dark" in style.text and "font-family" in style.text
    assert root.attrib["width"].isdigit() and root.attrib["height"].isdigit()


# --- next to matplotlib -----------------------------------------------------------------------------------------------


def run_python(code: str) -> str:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout


def test_importing_and_simulating_loads_no_matplotlib() -> None:
    code = """
import sys
from rosspin import plots
from rosspin import simulate
simulate(lambda: None, 1.0)
print([name for name in sys.modules if name.partition(".")[0] in ("matplotlib", "numpy", "PIL")])
"""
    assert run_python(code) == "[]\n"


def test_without_matplotlib_it_is_said_what_to_install() -> None:
    code = """
from rosspin import Tick
from rosspin.plots import pictures
from rosspin import plots
pictures.find_spec = lambda name: None
for plot in (plots.timeline, plots.lateness, plots.period_histogram, plots.picture):
    try:
        plot([Tick("A", 1, 1.0, 1.0, 0.0)])
    except ImportError as error:
        print(error)
"""
    assert run_python(code) == "plots need matplotlib, which is not installed: pip install 'rosspin[plot]'\n" * 4


def test_no_setting_of_matplotlibs_is_changed(plot: Callable[..., Any]) -> None:
    before = dict(matplotlib.rcParams)
    page(figure_of(plot(ticks())))
    assert dict(matplotlib.rcParams) == before


def test_nor_by_its_import() -> None:
    code = (
        "import matplotlib; a = dict(matplotlib.rcParams); import rosspin.plots; print(a == dict(matplotlib.rcParams))"
    )
    assert run_python(code) == "True\n"


def test_its_style_can_be_used() -> None:
    with pyplot.style.context("rosspin.plots.rosspin"):
        assert [entry["color"] for entry in matplotlib.rcParams["axes.prop_cycle"]] == [BLUE, VERMILION, GREEN]


def test_a_picture_is_unknown_to_pyplot() -> None:
    assert picture(ticks()).axes and not pyplot.get_fignums()


# Cells of a notebook: what each shows, by its kinds.
CELLS = {
    "from matplotlib import pyplot\nfrom rosspin import Tick, plots\nT = [Tick('A', 1, 1, 1, 0)]": [],
    "plots.timeline(T)": ["text/html"],
    "ax = plots.timeline(T)\nax.set_xlim(0, 3);": ["text/html"],
    "for plot in (plots.timeline, plots.lateness): plot(T)": ["text/html", "text/html"],
    "figure, (above, below) = pyplot.subplots(2)\nplots.timeline(T, ax=above)\nplots.lateness(T, ax=below)": [
        "text/html"
    ],
    "plots.with_handle('Work', 's', {1: T}, at=1)": ["text/html"],
    "pyplot.plot([1, 2])\npyplot.show()": ["image/png"],
    "%matplotlib inline\nplots.timeline(T)": ["text/html"],
    "pyplot.figure()\nax = pyplot.gca()\nax": ["text/plain", "image/png"],
}


def test_jupyter_shows_it_as_a_page_does_and_everything_else_as_ever() -> None:
    new_code_cell: Any = nbformat.v4.new_code_cell
    new_notebook: Any = nbformat.v4.new_notebook
    cells = [new_code_cell(cell) for cell in CELLS]
    book = new_notebook(cells=cells)
    nbclient.NotebookClient(book, kernel_name="python3", timeout=300).execute()
    found = [
        [
            next(kind for kind in ("text/html", "image/png", "text/plain") if kind in output.data)
            for output in cell.outputs
        ]
        for cell in book.cells
    ]
    assert found == list(CELLS.values())
    htmls = [output.data for cell in book.cells for output in cell.outputs if "text/html" in output.data]
    assert all(data["text/html"].startswith('<figure class="rosspin-plot"') for data in htmls)
    assert not [data for data in htmls if "image/png" in data]


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


def carried(figure: Movable) -> Any:
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
    for group, (*_, words, [row]) in zip(runs.values(), data["positions"], strict=True):
        assert [tuple(tick) for tick in row[4]] == [
            (round(tick.real, 6), round(tick.duration, 6) if tick.duration > 0 else 0) for tick in group
        ]
        assert f"Rate: {len(group)} ticks" in words
    assert data["positions"][2][3][0][1] == "6 ticks, one every 0.6 s"


def test_a_handle_stands_at_its_first_position(runs: dict[float, list[Tick]]) -> None:
    """As it does without the page's script, in print and in JupyterLab: the handle itself is hidden there."""
    figure = with_handle('Work "here"', "s", runs, at=0.6)
    assert figure.alt.startswith('Timeline, Work "here": 0.6 s. Rate: 6 ticks')
    first = re.search("<svg [^>]*>", figure.html)
    assert first and f'aria-label="{html.escape(figure.alt)}"' in first[0]
    assert repr(figure) == f"<Movable: {figure.alt}>"
    label = re.search(r"<label (.*?)>(.*?)<input (.*?)></label>", figure._repr_html_())
    assert label
    assert "hidden" in label[1]
    assert label[2] == 'Work &quot;here&quot; (s) <b aria-hidden="true">0.6 s</b> '
    assert all(part in label[3] for part in ('type="range"', 'max="3"', 'value="2"', 'aria-valuetext="0.6 s"'))
    wide = [float(x) for x in re.findall(r'<circle cx="([\d.]+)"', figure.html)[:6]]
    assert [b - a for a, b in pairwise(wide)] == pytest.approx([wide[1] - wide[0]] * 5, abs=0.2)


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


# --- what went wrong on purpose ---------------------------------------------------------------------------------------

FAULT_EVENTS = (
    FaultEvent(0.5, "delayed", "/scan from /a to /b", 0.25),
    FaultEvent(1.0, "delayed", "/scan from /a to /b", 0.125),
    FaultEvent(1.5, "killed", "/b"),
    FaultEvent(1.75, "set", "the clock", -0.5),
)


def test_faults_have_rows_below_the_ticks() -> None:
    run = Run("", ticks(), 0, "simulated", 2.0, faults=FAULT_EVENTS)
    ax = timeline(run)
    names = [label.get_text() for label in ax.get_yticklabels()]
    assert names == ["timerCallback", "/scan from /a to /b delayed", "/b killed", "the clock set"]
    triangles = [[float(x) for x in line.get_xdata()] for line in ax.lines if line.get_marker() == "v"]
    assert triangles == [[0.5, 1.0], [1.5], [1.75]]
    assert {to_hex(line.get_color()) for line in ax.lines if line.get_marker() == "v"} == {"#000000"}
    assert ax.get_label().endswith(
        "Faults: /scan from /a to /b delayed by 0.125 s to 0.25 s 2 times from 0.500 s to 1.000 s; "
        "/b killed at 1.500 s; the clock set by -0.5 s at 1.750 s."
    )


def test_a_picture_has_room_for_them_and_takes_them_with_bare_ticks() -> None:
    plain, wrong = picture(ticks()), picture(ticks(), faults=FAULT_EVENTS)
    assert wrong.get_figheight() > 2 * plain.get_figheight()
    assert "killed" in alternative(wrong) and "Faults" not in alternative(plain)


def test_runs_with_faults_are_compared_by_their_names() -> None:
    runs = {
        "as usual": Run("", ticks(), 0, "simulated", 2.0),
        "broken": Run("", ticks(), 0, "simulated", 2.0, faults=FAULT_EVENTS),
    }
    names = [label.get_text() for label in compare(runs).get_yticklabels()]
    assert names[:3] == ["as usual", "broken", "broken: /scan from /a to /b delayed"]
