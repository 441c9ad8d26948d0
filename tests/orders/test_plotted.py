"""The two orders as a picture: on one timeline, and step by step where they differ."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import rosspin
from benchmarks.planted_orders import PLANTS
from rosspin import plots
from rosspin.__main__ import main
from rosspin.plots import pictures
from rosspin.results.orders import Instant, Orders, Step


def explored(name: str, folder: Path) -> rosspin.Exploration:
    plant = PLANTS[name]
    nodes = plant.write(folder, mended=False)
    found = rosspin.explore(nodes if nodes[1:] else nodes[0], plant.seconds, plant.check, deep=plant.deep)
    assert found.orders is not None
    return found


def made(usual: str, here: str, *deviations: tuple[str, str], time: float = 0.5) -> Instant:
    """An instant: each letter is a thread, which runs the line of its place."""
    steps = [[Step(thread, str(line), "") for line, thread in enumerate(order, 1)] for order in (usual, here)]
    return Instant(time, steps[0], steps[1], deviations)


def test_the_alternative_says_both_orders_and_where_they_part(tmp_path: Path) -> None:
    found = explored("ros1-lost-update", tmp_path)
    assert found.orders
    ax = plots.orders(found.orders, ax=pictures.new_axes(300))
    assert ax.get_label() == (
        "Two orders of one run, step by step. At 0.5 s, lines in the usual order: Thread-1: 11, 12, then Thread-2: 11, "
        "12; lines in this order: Thread-1: 11, then Thread-2: 11, 12, then Thread-1: 11, 12. "
        "They part: usually Thread-1, here Thread-2."
    )


def test_there_is_a_row_for_each_thread_of_each_order_and_a_mark_for_each_step() -> None:
    orders = Orders(None, None, [made("aabb", "abba", ("a", "b"))])
    ax = plots.orders(orders, ax=pictures.new_axes(300))
    names = [label.get_text() for label in ax.get_yticklabels()]
    assert names == ["the usual order: a", "the usual order: b", "this order: a", "this order: b"]
    points: list[Any] = [line.get_xydata() for line in ax.lines]
    marks = [(n, round(down, 3)) for line in points for n, down in line]
    rows = sorted({down for _, down in marks})
    assert [n for n, down in sorted(marks) if down in rows[:2]] == [0, 1, 2, 3]
    assert {n: rows.index(down) for n, down in marks if down in rows[2:]} == {0: 2, 1: 3, 2: 3, 3: 2}
    assert "usually a,\nhere b" in [text.get_text() for text in ax.texts]
    assert [label.get_text() for label in ax.get_xticklabels()] == ["0.5"]


def test_what_changed_nothing_where_it_was_chosen_is_told_where_the_orders_part() -> None:
    orders = Orders(None, None, [made("ab", "ab", ("x", "y"), time=0.25), made("ab", "a", time=0.5)])
    ax = plots.orders(orders, ax=pictures.new_axes(300))
    assert "at 0.25 s usually x,\nhere y" in [text.get_text() for text in ax.texts]


def test_of_many_steps_the_first_that_differ_are_drawn() -> None:
    orders = Orders(None, None, [made("a" * 40 + "b" * 40, "a" * 40 + "c" * 30)])
    ax = plots.orders(orders, ax=pictures.new_axes(300))
    assert ax.get_xlabel().endswith("\n64 more steps not drawn")
    assert "a: 39, 40, then b: 41, " in str(ax.get_label())


@pytest.mark.parametrize("instants", [[], [made("ab", "ab", ("a", "b"))]])
def test_without_lines_that_differ_there_is_nothing_to_plot(instants: list[Instant]) -> None:
    with pytest.raises(ValueError, match="no lines that differ"):
        plots.orders(Orders(None, None, instants), ax=pictures.new_axes(300))
    with pytest.raises(ValueError, match="no ticks to plot, and no lines that differ"):
        plots.both_orders(Orders(None, None, instants))


@pytest.mark.parametrize("name", ["ros1-lock-order", "ros1-late-connection", "ros2-late-discovery", "ros2-two-topics"])
def test_a_figure_of_both_has_what_there_is_to_show(name: str, tmp_path: Path) -> None:
    found = explored(name, tmp_path)
    assert found.orders and found.orders.usual
    figure = plots.both_orders(found.orders)
    assert len(figure.axes) == 1 + bool(found.orders.usual.ticks)
    words = pictures.alternative(figure)
    assert words in pictures.page(figure).replace("&amp;", "&").replace("&gt;", ">")
    for instant in found.orders.instants:
        assert all(usually in words and here in words for usually, here in instant.deviations[:1])


def test_the_command_line_plots_both(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plant, plot = PLANTS["ros1-lost-update"], tmp_path / "orders.svg"
    found = explored("ros1-lost-update", tmp_path)
    (node,) = plant.write(tmp_path, mended=False)
    given = ["run", node, "--simulated", "--seconds", f"{plant.seconds}", "--plot", str(plot)]
    assert main([*given, "--schedule", found.token]) == 0
    out, err = capsys.readouterr()
    assert found.run and out == found.run.console
    assert err == f"{plot}:\n  at 0.5 s{str(found).partition('  at 0.5 s')[2]}\n"
    assert "They part: usually Thread-1, here Thread-2." in plot.read_text(encoding="utf-8")
    assert main([*given, "--schedule", ""]) == 1
    assert capsys.readouterr().err.startswith("rosspin: '' is no schedule")


def test_a_clock_that_begins_later_moves_nothing(tmp_path: Path) -> None:
    from rosspin.clocks.explored import Order
    from rosspin.orders.exploring import compare_orders

    plant = PLANTS["ros1-lost-update"]
    found = explored("ros1-lost-update", tmp_path)
    again = compare_orders(plant.write(tmp_path, mended=False)[0], plant.seconds, Order.of(found.token), start=1.7e9)
    assert found.orders and again.instants == found.orders.instants
