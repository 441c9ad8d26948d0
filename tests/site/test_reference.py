"""The reference: what it lists is what there is."""

from __future__ import annotations

import inspect
import re
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from bs4 import BeautifulSoup

import rosspin
from rosspin import exercises, measures, plots, rclpy, rospy
from rosspin.results import console, machine
from tests.helpers.built_pages import parsed
from tests.helpers.names_of_rclpy import names_on_page
from tests.helpers.tree import ROOT

PAGES = [ROOT / "index.rst", *sorted(ROOT.glob("docs/**/*.rst")), *sorted(ROOT.glob("notebooks/*.md"))]


def _page(site: Path, name: str) -> BeautifulSoup:
    return parsed(site / f"docs/{name}.html")


def test_every_name_of_the_package_is_documented(site: Path) -> None:
    documented = {tag["id"] for tag in _page(site, "reference/api").select("dt[id]")}
    public = {f"rosspin.{name}" for name in rosspin.__all__}
    for module in (console, measures, plots, exercises):
        public |= {f"{module.__name__}.{name}" for name in module.__all__}
    assert public <= documented


@pytest.mark.parametrize("arguments", [[], ["run"], ["doctor"]])
def test_the_command_line_is_the_one_on_the_page(
    site: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "72")
    command = [sys.executable, "-m", "rosspin", *arguments, "--help"]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert said.strip() in [tag.get_text().strip() for tag in _page(site, "reference/command-line").select("pre")]


def test_every_name_of_the_stand_in_is_listed_once(site: Path) -> None:
    page = _page(site, "reference/rospy-names")
    tables = (page.select_one(f"#{name} > table, #{name} > div table") for name in ("supported", "supported-in-part"))
    has, part = ([code.get_text() for code in table.select("td:first-child code")] for table in tables if table)
    lacks = [code.get_text() for code in page.select("#not-supported > p:nth-of-type(2) code")]
    assert sorted(has + part) == sorted(rospy.__all__)
    assert set(part) == rospy.IN_PART.keys()
    assert set(lacks) == rospy.NOT_SIMULATED
    assert all(row.get_text().strip() for row in page.select("td:last-child"))


def test_every_name_of_the_stand_in_for_rclpy_is_listed_once(site: Path) -> None:
    page, found = _page(site, "reference/rclpy-names"), names_on_page(site)
    assert found.keys() == {module for module, file in rclpy.MODULES.items() if file.__all__}
    assert all(found.values())
    assert {name for names in found.values() for name in names} == {
        name for file in rclpy.MODULES.values() for name in file.__all__
    }
    part = [code.get_text() for code in page.select("#supported-in-part td:first-child code")]
    assert sorted(part) == sorted(rclpy.IN_PART)
    lacks = [code.get_text() for code in page.select("#not-supported > p:nth-of-type(2) code")]
    assert sorted(lacks) == sorted(f"{where}.{name}" for where, names in rclpy.LACKING.items() for name in names)


def test_docstrings_say_something() -> None:
    for name in sorted(set(rospy.__all__)):
        value = getattr(rospy, name)
        assert isinstance(value, int) or inspect.getdoc(value), name


def test_status_page(site: Path) -> None:
    text = _page(site, "status").get_text()
    for notebook in ROOT.glob("notebooks/*.md"):
        assert f"notebooks/{notebook.stem}" in text
    for name, value in machine.describe(["rosspin", "sphinx"]).items():
        assert name in text
        assert value in text
    assert "❌" not in text


def test_the_machine_is_not_named() -> None:
    assert socket.gethostname() not in " ".join(machine.describe().values()).split()


def test_a_package_that_is_not_installed_is_left_out() -> None:
    assert "no-such-package" not in machine.describe(["no-such-package"])


@pytest.mark.parametrize("page", PAGES[1:], ids=lambda page: page.stem)
def test_each_page_says_where_to_go_next(site: Path, page: Path) -> None:
    """At its end, or next to its place on a path, which JupyterLab does not show."""
    _, _, rest = page.read_text(encoding="utf-8").partition("See also\n")
    if page.suffix == ".md":
        assert re.search(r"\]\([^)]+\.(md|rst)\)", rest)
    else:
        built = parsed(site / page.relative_to(ROOT).with_suffix(".html"))
        assert re.search(r":(doc|ref):`", rest) or built.select(".rosspin-path:not([hidden]) a + a")


def test_glossary_words_are_linked_to(site: Path) -> None:
    words = [tag["id"] for tag in _page(site, "glossary").select("dt[id^=term-]")]
    pages = [path.read_text(encoding="utf-8") for path in site.rglob("*.html") if path.name != "glossary.html"]
    linked = {word for word in words if any(f"glossary.html#{word}" in page for page in pages)}
    assert {"term-tick", "term-period", "term-lateness", "term-jitter", "term-drift", "term-overrun"} <= linked
    assert len(words) == 30
