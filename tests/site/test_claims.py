"""What the pages say of themselves, of browsers and of releases is so."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import pytest
from bs4 import Tag

from rosspin.exercises import EXERCISES
from rosspin.rclpy import _ENDING, discovery
from tests.helpers.built_pages import parsed
from tests.helpers.commands import PAGES
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

TEXTS = [*PAGES, ROOT / "README.md"]
COURSES = [(2, "I am taking the course on ROS 2"), (2, "I know ROS 1 and move to ROS 2")]
COURSES += [(1, "I am taking the course on ROS 1")]
FIRST_SCREEN = 100  # words


TUTORIALS = ("tutorial", "tutorial-timer", "tutorial-rate", "publish")


@pytest.mark.parametrize("name", [f"{folder}{name}" for folder in ("", "ros2/") for name in TUTORIALS])
def test_a_tutorial_has_code_on_its_first_screen(site: Path, name: str) -> None:
    article = parsed(site / f"docs/{name}.html").select_one("article")
    assert article
    code = article.select_one("pre")
    assert code
    texts = [text for text in code.find_all_previous(string=True) if article in text.parents]
    before = [text for text in texts if not text.find_parent(hidden=True)]  # the paths that are not chosen
    assert len(" ".join(before).split()) <= FIRST_SCREEN


def test_what_was_not_run_is_said_at_most_twice() -> None:
    said = re.compile(r"\bnot\s+(?:be(?:en)?\s+)?run\s+(?:here|for\s+this)|\bw(?:as|ere)\s+not\s+run\b", re.IGNORECASE)
    found = [path.name for path in TEXTS for _ in said.findall(path.read_text(encoding="utf-8"))]
    assert len(found) <= 2, found


def test_the_pages_name_the_browsers_that_have_jspi() -> None:
    lacks = (ROOT / "web/src/jspi.js").read_text(encoding="utf-8")
    versions = re.findall(r"\b\d+\b", lacks)
    assert len(versions) == 3
    chrome, firefox, safari = versions
    wanted = f"Chrome or Edge {chrome}, Firefox {firefox}, Safari {safari}, or any later version"
    for name in ("index", "docs/tutorial", "docs/ros2/tutorial", "docs/for-teachers"):
        assert wanted in " ".join((ROOT / f"{name}.rst").read_text(encoding="utf-8").split()), name
    assert not [path.name for path in TEXTS if re.search(r"current browser", path.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("name", ["tutorial", "ros2/tutorial"])
def test_the_size_of_what_a_first_run_loads_is_right(site: Path, name: str) -> None:
    """The files that a browser was seen to load; gzip makes the interpreter and the worker smaller."""
    files = [
        (site / "_static/live" / file).read_bytes()
        for file in ("live.js", "runs.js", "sandbox.html", "pyodide.asm.wasm", "worker.js", "snapshot.zst")
    ]
    text = (ROOT / f"docs/{name}.rst").read_text(encoding="utf-8")
    found = re.search(r"loads\s+less\s+than\s+(\d+)\s+MB\s+from\s+this\s+site,\s+or\s+(\d+)\s+MB\s+if\s+the", text)
    assert found
    for said, sizes in zip(
        found.groups(), (map(len, files), (len(gzip.compress(file)) for file in files)), strict=True
    ):
        assert 0 <= int(said) - sum(sizes) / 1e6 < 1.5


@pytest.mark.parametrize(("ros", "name"), [(1, "tutorial"), (2, "ros2/tutorial")])
def test_the_size_of_the_compiler_is_right(site: Path, ros: int, name: str) -> None:
    parts = json.loads((site / "_static/clang/parts.json").read_text(encoding="utf-8"))
    size = sum(part["bytes"] for part in parts if part["ros"] in (0, ros)) / 1e6
    assert size < 28
    for file, before in (f"docs/{name}.rst", "compiler"), ("web/src/answers.js", "clang once"):
        found = re.search(rf"{before}[,:]\s+about\s+(\d+)\s+MB", (ROOT / file).read_text(encoding="utf-8"))
        assert found and -0.5 < int(found[1]) - size < (0.5 if name in file else 4), file


def test_the_times_of_discovery_are_right() -> None:
    text = " ".join((ROOT / "docs/simulation-limits.rst").read_text(encoding="utf-8").split())
    for said in (
        f"know each other after {discovery.PARTICIPANT / 1e9:g} simulated seconds",
        f"subscription after {discovery.ENDPOINT / 1e6:g} ms",
        f"arrives after another {discovery.KEPT / 1e6:g} ms",
        f"after {discovery.END / 1e6:g} ms that a process has ended, and after {discovery.LEASE / 1e9:g} s,",
        f"within {_ENDING / 1e9:g} s, the process aborts",
    ):
        assert said in text


@pytest.mark.parametrize(("ros", "course"), COURSES)
def test_a_path_has_what_its_pages_and_exercises_need(site: Path, ros: int, course: str) -> None:
    page = parsed(site / "docs/paths.html")
    (section,) = (tag.parent for tag in page.select("article h2") if tag.get_text().startswith(course))
    assert section
    links = [(site / "docs" / str(tag["href"]).partition("#")[0]).resolve() for tag in section.select("a.internal")]
    pages = {link.relative_to(site.resolve()).with_suffix("").as_posix() for link in links}
    needed = {need for exercise in EXERCISES if exercise.ros == ros for need in exercise.needs}
    for name in pages:
        if (notebook := ROOT / f"{name}.md").exists():
            needs = re.search(
                r"\*\*What you need\*\*: (.*?)\*\*Time\*\*", notebook.read_text(encoding="utf-8"), re.DOTALL
            )
            targets = re.findall(r"\]\(([\w./-]+)\.(?:md|rst)\)", needs[1] if needs else "")
            needed |= {(notebook.parent / target).resolve().relative_to(ROOT).as_posix() for target in targets}
    assert needed <= pages, needed - pages


# What a page may point to although a path leaves it out: what one looks up, and what teachers, or the curious, read.
BESIDE = {f"docs/{name}" for name in ("differences", "for-teachers", "glossary", "paths", "simulation-limits")}
BESIDE |= {"docs/how-to/info-lines", "docs/how-to/break-things-on-purpose"}
BESIDE |= {"docs/how-to/message-type", "docs/how-to/wait-for-a-message"}
# Those have a path of their own, for a node that stutters.
BESIDE |= {f"docs/{name}" for name in ("show-your-log", "how-to/look-at-your-log", "how-to/irregular-loop")}
BESIDE |= {"docs/how-to/why-does-it-hang"}
# A link that leads to the other ROS says so, in its paragraph.
OTHER = {1: re.compile(r"ROS 2|rclpy|each ROS"), 2: re.compile(r"ROS 1|rospy|each ROS")}


@pytest.mark.parametrize(("ros", "course"), COURSES)
def test_the_pages_of_a_path_lead_to_no_page_that_it_omits(site: Path, ros: int, course: str) -> None:
    """By any link: one that it omits is for looking up, or is said to be about the other ROS."""
    page = parsed(site / "docs/paths.html")
    (section,) = (tag.parent for tag in page.select("article h2") if tag.get_text().startswith(course))
    assert section
    pages = {target for _, target in links(site, site / "docs/paths.html", section)}
    omitted = set()
    for name in pages:
        article = parsed(site / f"{name}.html").select_one("article")
        assert article
        for tag, target in links(site, site / f"{name}.html", article):
            if target in pages | BESIDE or target.startswith(("docs/reference/", "_")):
                continue
            around = tag.find_parent(["p", "li", "dd", "div"])
            if not (around and OTHER[ros].search(around.get_text())):
                omitted.add((name, target))
    assert not omitted


def links(site: Path, page: Path, within: Tag) -> list[tuple[Tag, str]]:
    """The links to other pages of the site, and the names of these."""
    found = [(tag, str(tag["href"]).partition("#")[0]) for tag in within.select("a.internal")]
    targets = [(tag, (page.parent / href).resolve()) for tag, href in found if href]
    return [(tag, path.relative_to(site.resolve()).with_suffix("").as_posix()) for tag, path in targets]


def test_the_releases_that_were_checked_are_those_of_the_constraints() -> None:
    """The real lane holds the constraints to what is installed, and to what there is."""
    page = " ".join((ROOT / "docs/reference/rclpy-names.rst").read_text(encoding="utf-8").split())
    pins = "".join((ROOT / f"pins/ros2{other}.txt").read_text(encoding="utf-8") for other in ("", "-kilted"))
    jazzy, kilted = re.findall(r"^ros-rclpy==(\S+)", pins, re.MULTILINE)
    assert f"**Jazzy**, with rclpy {jazzy}, and **Kilted**, with rclpy {kilted}." in page
