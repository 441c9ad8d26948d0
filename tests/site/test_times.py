"""The minutes that pages give follow from what is on the pages, by one rule."""

from __future__ import annotations

from pathlib import Path

import pytest
from docutils import nodes

from rosspin.site import times
from rosspin.site.live import SECONDS
from rosspin.site.times import Seconds, rounded, seconds
from tests.helpers.small_sites import build, listed, site

WORDS = "word " * times.WORDS  # a minute
LINES = "x = 1\n\n" * times.LINES


def page(*parts: nodes.Node) -> Seconds:
    return seconds(nodes.section("", *parts))


def listing(text: str, language: str = "python", *classes: str) -> nodes.literal_block:
    return nodes.literal_block(text, text, language=language, classes=list(classes))


@pytest.mark.parametrize(
    ("part", "reading", "commands"),
    [
        (nodes.paragraph("", WORDS), 60, 0),
        (nodes.section("", nodes.title("", WORDS), nodes.paragraph("", WORDS)), 120, 0),
        (nodes.comment("", WORDS), 0, 0),
        (listing(LINES), 60, 0),
        (listing(LINES, "python", "live"), 60 + times.RUN + SECONDS, 0),
        (listing("%%simulate 6.2 -- _p:=1\n", "ipython3", "live"), 2 + times.RUN + 6.2, 0),
        (listing("%%answer ten-hertz\n", "ipython3", "live"), 2 + times.EXERCISE, 0),
        (listing("%%answer ten-hertz\n", "ipython3"), 2, 0),  # its solution
        (listing("# set it up\ncd ws\ncolcon build \\\n    --quick\n", "bash"), 8, 2 * times.COMMAND),
        (nodes.raw("", "<figure><svg></svg></figure>", format="html"), times.FIGURE, 0),
        (nodes.raw("", "<figure data-positions='{}'></figure>", format="html"), times.FIGURE + times.HANDLE, 0),
        (nodes.container("", listing(LINES), classes=["cell", "tag_hide-input"]), 0, 0),
        (nodes.container("", nodes.paragraph("", WORDS), classes=["cell_output"]), 0, 0),
    ],
)
def test_each_part_of_a_page_takes_its_time(part: nodes.Element, reading: float, commands: float) -> None:
    assert page(part) == pytest.approx((reading, commands))


def test_a_reader_reads_one_language() -> None:
    """Of tabs, the longest counts."""
    tabs = [nodes.container("", *[nodes.paragraph("", WORDS)] * count) for count in (1, 3, 2)]
    assert page(nodes.container("", *tabs, classes=["sd-tab-set"])).reading == 180


def test_minutes_are_rounded_to_five() -> None:
    assert [rounded([Seconds(60 * minutes, 0)]) for minutes in (0, 1, 7, 8, 12, 13)] == [5, 5, 5, 10, 10, 15]
    assert rounded([Seconds(240, 300), Seconds(60, 0)]) == 5
    assert rounded([Seconds(240, 300), Seconds(60, 0)], building=True) == 10


def test_a_page_gives_the_minutes_of_others_as_they_are_now(tmp_path: Path) -> None:
    """A page that grows is told on a page that was not read again, a notebook that says another number is listed."""
    folder = site(tmp_path / "site", {})
    conf = folder / "conf.py"
    conf.write_text(conf.read_text().replace('"rosspin.site.pages"', '"rosspin.site.pages", "rosspin.site.times"'))
    conf.write_text(f"{conf.read_text()}html_theme = 'basic'\n")
    index, book = folder / "index.rst", folder / "notebooks/book.md"
    index.write_text(f"{index.read_text()}\nIt takes :minutes:`notebooks/book` min.\n")
    book.write_text(f"{book.read_text()}\n**Time**: 5 minutes.\n")
    assert build(folder, "html").returncode == 0
    html = folder / "build/html/index.html"
    assert "It takes 5 min." in html.read_text()
    book.write_text(book.read_text() + 10 * WORDS)
    run = build(folder, "html")
    assert run.returncode == 1
    assert "It takes 10 min." in html.read_text()
    ((place, entry),) = listed(run).items()
    assert place[0] == "notebooks/book.md" and "**Time**: 10 minutes" in entry
    assert build(folder, "outputs").returncode == 0
    assert "**Time**: 10 minutes" in book.read_text()
    assert build(folder, "html").returncode == 0


def test_a_page_that_is_not_there_is_listed(tmp_path: Path) -> None:
    folder = site(tmp_path / "site", {})
    conf = folder / "conf.py"
    conf.write_text(conf.read_text().replace('"rosspin.site.pages"', '"rosspin.site.pages", "rosspin.site.times"'))
    index = folder / "index.rst"
    index.write_text(f"{index.read_text()}\n:minutes:`notebooks/gone`\n")
    run = build(folder, "dummy")
    assert run.returncode == 1
    ((place, entry),) = listed(run).items()
    assert place[0] == "index.rst" and "there is no page notebooks/gone" in run.stdout, entry
