"""What a build remakes after a change, and what it leaves: as little as possible, and all that follows from it."""

from __future__ import annotations

import errno
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from rosspin.results import machine
from tests.helpers.small_sites import build, listed, site

pytestmark = pytest.mark.shares(3)

THEME = """
html_theme = "basic"
html_sidebars = {"**": ["globaltoc.html"]}
"""
FACTS = "\n.. facts::\n\n   value = open('helper.txt').read()\n   assert value == 'one'\n\nIt is :fact:`value`.\n"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A built site of three pages: the first lists the others, and one says what a helper has; and a copy of it."""
    folder = site(tmp_path_factory.mktemp("edited") / "site", {})
    conf = folder / "conf.py"
    conf.write_text(f"{conf.read_text()}{THEME}what_pages_run = open('helper.txt').read()\n")
    (folder / "helper.txt").write_text("one")
    (folder / "index.rst").write_text("First\n=====\n\n.. toctree::\n   :glob:\n\n   notebooks/*\n")
    (folder / "notebooks/facts.rst").write_text(f"Facts\n=====\n{FACTS}")
    conf.write_text(conf.read_text().replace('"notebooks/*.md"', '"notebooks/*"'))
    run = build(folder, "html")
    assert run.returncode == 0, run.stdout + run.stderr
    kept = shutil.copytree(folder, folder.with_name("kept"))
    return folder, kept


@pytest.fixture
def pages(built: tuple[Path, Path]) -> Path:
    """The site as it was built, where it was built, with the times of its files."""
    folder, kept = built
    shutil.rmtree(folder)
    return shutil.copytree(kept, folder)


def touched(run: subprocess.CompletedProcess[str]) -> tuple[set[str], set[str]]:
    """The pages that a build has read, and those that it has written."""
    done = [set(re.findall(rf"{doing}\.\.\. \[ *\d+%\] (\S+)", run.stdout)) for doing in ("sources", "output")]
    return done[0], done[1]


def change(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


ALL = {"index", "notebooks/book", "notebooks/facts"}


def test_without_a_change_nothing_is_read_or_written(pages: Path) -> None:
    assert touched(build(pages, "html")) == (set(), set())


def test_a_label_may_move_from_a_page_to_one_that_is_read_before(pages: Path) -> None:
    label = "\n.. _moves:\n\nIt moves\n--------\n"
    facts, first = pages / "notebooks/facts.rst", pages / "index.rst"
    facts.write_text(facts.read_text() + label)
    assert not build(pages, "html").stderr
    facts.write_text(facts.read_text().replace(label, ""))
    first.write_text(first.read_text() + label)
    assert not build(pages, "html").stderr


def test_a_sentence_changes_its_page(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "It is", "It was")
    read, written = touched(build(pages, "html"))
    assert (read, written) == ({"notebooks/facts"}, {"notebooks/facts", "index"})  # the index lists it
    assert "It was one" in (pages / "build/html/notebooks/facts.html").read_text()


def test_a_title_changes_in_the_list_of_every_page(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "Facts\n", "Other\n")
    read, written = touched(build(pages, "html"))
    assert (read, written) == ({"notebooks/facts"}, ALL)
    assert "Other" in (pages / "build/html/notebooks/book.html").read_text()


def test_a_caption_changes_in_the_list_of_every_page(pages: Path) -> None:
    change(pages / "index.rst", ":glob:", ":glob:\n   :caption: Pages")
    assert touched(build(pages, "html"))[1] == ALL


def test_what_failed_is_run_again_although_the_page_is_the_same(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "open('helper.txt')", "open('of-this-machine.txt')")
    assert build(pages, "html").returncode == 1
    (pages / "of-this-machine.txt").write_text("one")
    run = build(pages, "html")
    assert (run.returncode, touched(run)[0]) == (0, {"notebooks/facts"})
    assert touched(build(pages, "html")) == (set(), set())


def test_a_build_that_broke_off_leaves_no_half_page(pages: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As when the disk is full: what was written by half is newer than its source."""
    page = pages / "build/html/notebooks/book.html"
    whole = page.read_text()

    def full(*about: object) -> None:
        page.write_text(whole[:100])
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as context:
        context.setattr("sphinx.builders.html.StandaloneHTMLBuilder.finish", full)
        assert build(pages, "html").returncode != 0
    assert build(pages, "html").returncode == 0
    assert page.read_text() == whole


@pytest.mark.parametrize("between", ["doctest", ""])
def test_a_helper_changes_all_pages_whoever_reads_them_first(pages: Path, between: str) -> None:
    (pages / "helper.txt").write_text("two")
    change(pages / "notebooks/facts.rst", "== 'one'", "== 'two'")
    build(pages, "html")
    (pages / "helper.txt").write_text("one")
    runs = [build(pages, builder) for builder in filter(None, [between, "html"])]
    assert touched(runs[0])[0] == touched(runs[-1])[1] == ALL
    assert "It is one" in (pages / "build/html/notebooks/facts.html").read_text()
    assert runs[-1].returncode == 1
    ((place, entry),) = listed(runs[-1]).items()
    assert place == ("notebooks/facts.rst", 7) and "value is 'one'" in entry


def test_a_fact_that_fails_is_told_again_until_it_holds(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "== 'one'", "== 'two'")
    runs = [build(pages, "html") for _ in range(2)]
    assert [touched(run)[0] for run in runs] == [{"notebooks/facts"}] * 2
    assert listed(runs[0]) == listed(runs[1]) != {}
    assert [run.returncode for run in runs] == [1, 1]
    change(pages / "notebooks/facts.rst", "== 'two'", "== 'one'")
    assert build(pages, "html").returncode == 0


def test_a_page_that_goes_takes_its_entries_along(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "== 'one'", "== 'two'")
    assert build(pages, "html").returncode == 1
    (pages / "notebooks/facts.rst").unlink()
    assert build(pages, "html").returncode == 0


def test_a_warning_is_given_again(pages: Path) -> None:
    change(pages / "notebooks/facts.rst", "It is", "See :ref:`nowhere`. It is")
    for _ in range(2):
        assert "undefined label: 'nowhere'" in build(pages, "html").stderr


def test_another_machine_is_described_anew(pages: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    change(pages / "index.rst", "=====\n", "=====\n\n.. machine::\n")
    assert touched(build(pages, "html"))[0] == {"index"}
    assert touched(build(pages, "html"))[0] == set()
    monkeypatch.setattr(machine, "describe", lambda packages: {"Processor": "another"})
    assert touched(build(pages, "html"))[0] == {"index"}
    assert "another" in (pages / "build/html/index.html").read_text()
