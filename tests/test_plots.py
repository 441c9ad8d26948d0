"""Timing plots: pictures that say what they show, and fit into any page."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
import pytest
from matplotlib.figure import Figure as Canvas

from rosspin import Tick, plots
from rosspin.plots import Figure, lateness, period_histogram, timeline

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


def test_a_period_draws_the_whole_grid_and_crosses_out_the_lost_ticks() -> None:
    late = [Tick("A", 1, 0.5, 0.5, 2.2), Tick("A", 2, 1.0, 2.7, 0), Tick("A", 3, 1.5, 3.2, 0)]
    assert timeline(late, 0.5).alt.endswith("Lost ticks: 3.")
    assert "lost" in timeline(late, 0.5).svg
    assert "lost" not in timeline(late).svg.lower()


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
    root = parse(plot(ticks()))
    assert "viewBox" in root.attrib and "width" not in root.attrib and "height" not in root.attrib


def test_it_loads_nothing(plot: Callable[..., Figure]) -> None:
    for element in parse(plot(ticks())).iter():
        for name, value in element.attrib.items():
            if name.endswith(("href", "src")) or "url(" in value:
                assert "#" in value and "//" not in value
    # The only addresses are the names of XML's own namespaces.
    assert set(re.findall(r"https?://[^\"' ]*", plot(ticks()).svg)) <= {
        "http://www.w3.org/2000/svg",
        "http://www.w3.org/1999/xlink",
    }


def test_ids_are_unique_on_a_page_with_many_plots() -> None:
    figures = [plot(ticks(late=late)) for plot in PLOTS for late in (0.0, 0.01)]
    ids = [element.attrib["id"] for figure in figures for element in parse(figure).iter() if "id" in element.attrib]
    assert len(ids) == len(set(ids))
    for figure in figures:
        own = set(re.findall(r'id="([^"]+)"', figure.svg))
        assert set(re.findall(r'href="#([^"]+)"', figure.svg)) <= own
        assert set(re.findall(r"url\(#([^)]+)\)", figure.svg)) <= own


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
    def bars(durations: list[float]) -> int:
        return len(re.findall(r"opacity: 0\.45", timeline([Tick("A", 1, 1, 1, d) for d in durations]).svg))

    assert bars([0.0, float("nan")]) == 0
    assert bars([0.5, 0.2]) == 2


def test_many_ticks_are_drawn_by_as_few_artists_as_few(monkeypatch: pytest.MonkeyPatch) -> None:
    """An artist for each tick makes a plot of thousands slow."""
    counts = []

    def count_artists(canvas: Canvas, alt: str) -> Figure:
        counts.append(len(canvas.axes[0].get_children()))
        return Figure("", alt)

    monkeypatch.setattr(plots, "_figure", count_artists)
    for count in (2, 300):
        timeline(ticks(count=count) + ticks("Rate", count=count), 0.5)
    assert counts[0] == counts[1]


def test_one_tick_is_enough_and_none_are_too_few(plot: Callable[..., Figure]) -> None:
    alt = plot(ticks(count=1)).alt
    assert "1 tick" in alt or "The only tick" in alt or "no second tick" in alt
    nothings: list[Any] = [[], {"a": []}]
    for nothing in nothings:
        with pytest.raises(ValueError, match="there are no ticks to plot"):
            plot(nothing)


def test_plotting_leaves_matplotlib_s_settings_alone(plot: Callable[..., Figure]) -> None:
    before = dict(matplotlib.rcParams)
    plot(ticks())
    assert dict(matplotlib.rcParams) == before
