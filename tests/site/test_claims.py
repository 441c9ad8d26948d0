"""What the pages say of themselves, of browsers and of releases is so."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from built_pages import parsed
from commands import PAGES
from tree import ROOT

from rosspin.exercises.questions import EXERCISES

TEXTS = [*PAGES, ROOT / "README.md"]
COURSES = [(2, "I am taking the course on ROS 2"), (2, "I know ROS 1 and move to ROS 2")]
COURSES += [(1, "I am taking the course on ROS 1")]
FIRST_SCREEN = 100  # words


@pytest.mark.parametrize("name", ["tutorial", "publish", "ros2/tutorial"])
def test_a_tutorial_has_code_on_its_first_screen(site: Path, name: str) -> None:
    article = parsed(site / f"docs/{name}.html").select_one("article")
    assert article
    code = article.select_one("pre")
    assert code
    before = [text for text in code.find_all_previous(string=True) if article in text.parents]
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
    files = ["runs.js", "sandbox.html", "pyodide.asm.wasm", "worker.js", "snapshot.gz"]
    found = re.search(r"loads\s+about\s+(\d+)\s+MB", (ROOT / f"docs/{name}.rst").read_text(encoding="utf-8"))
    assert found
    size = sum((site / "_static/live" / file).stat().st_size for file in files) / 1e6
    assert abs(size - int(found[1])) < 1


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


def test_the_releases_that_were_checked_are_those_of_the_constraints() -> None:
    """The real lane holds the constraints to what is installed, and to what there is."""
    page = " ".join((ROOT / "docs/reference/rclpy-names.rst").read_text(encoding="utf-8").split())
    pins = "".join((ROOT / f"constraints-ros2{other}.txt").read_text(encoding="utf-8") for other in ("", "-kilted"))
    jazzy, kilted = re.findall(r"^ros_rclpy==(.*)$", pins, re.MULTILINE)
    assert f"**Jazzy**, with rclpy {jazzy}, and **Kilted**, with rclpy {kilted}." in page
