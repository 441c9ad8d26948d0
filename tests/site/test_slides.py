"""What the build does with pages that can be shown as slides."""

from __future__ import annotations

import gzip
import re
from pathlib import Path

import pytest

from tests.helpers.built_pages import parsed
from tests.helpers.small_sites import build
from tests.helpers.small_sites import site as small_site

DECKS = ["ros2", "ros1"]


@pytest.mark.parametrize("deck", DECKS)
def test_a_session_takes_90_minutes(site: Path, deck: str) -> None:
    """Each slide has its notes, and they say how long it takes."""
    page = parsed(site / f"docs/slides/{deck}.html")
    minutes = [int(str(notes["data-minutes"])) for notes in page.select(".rosspin-notes")]
    assert sum(minutes) == 90 and min(minutes) > 0
    assert len(minutes) == len(page.select("article h1, article h2"))


@pytest.mark.parametrize("deck", DECKS)
def test_a_session_keeps_to_the_plan_for_teachers(site: Path, deck: str) -> None:
    """The minutes of the table are sums of the minutes of slides that follow each other."""
    (table,) = (
        tag for tag in parsed(site / "docs/for-teachers.html").select("table") if "What to do" in tag.get_text()
    )
    plan = [int(row.select("td")[0].get_text()) for row in table.select("tbody tr")]
    notes = parsed(site / f"docs/slides/{deck}.html").select(".rosspin-notes")
    begins = {sum(int(str(note["data-minutes"])) for note in notes[:count]) for count in range(len(notes) + 1)}
    assert {sum(plan[:count]) for count in range(len(plan) + 1)} <= begins


def test_what_slides_need_is_small_and_loaded_there_only(site: Path) -> None:
    files = [site / "_static/slides" / name for name in ("slides.js", "slides.css")]
    assert [len(gzip.compress(file.read_bytes())) < 4000 for file in files] == [True, True]
    loading = {path.stem for path in site.rglob("*.html") if "slides/slides.js" in path.read_text(encoding="utf-8")}
    assert loading == {*DECKS}


def test_a_page_and_a_notebook_are_marked(tmp_path: Path) -> None:
    folder = small_site(tmp_path / "site", {})
    conf = folder / "conf.py"
    conf.write_text(conf.read_text().replace('"rosspin.site.pages"', '"rosspin.site.pages", "rosspin.site.slides"'))
    conf.write_text(f"{conf.read_text()}html_theme = 'basic'\n")
    index, book = folder / "index.rst", folder / "notebooks/book.md"
    index.write_text(f":slides:\n\n{index.read_text()}\n.. notes::\n   :minutes: 3\n\n   Ask them *why*.\n")
    for mark, found in (("", False), ("slides: true\n", True)):
        book.write_text(re.sub("^---\n(slides: true\n)?", f"---\n{mark}", book.read_text()))
        assert build(folder, "html").returncode == 0
        assert ("slides/slides.js" in (folder / "build/html/notebooks/book.html").read_text()) == found
    page = parsed(folder / "build/html/index.html")
    assert "slides/slides.js" in str(page)
    (notes,) = page.select(".rosspin-notes")
    assert notes["data-minutes"] == "3" and notes.select("em")[0].get_text() == "why"
