"""The paths through the site: what each page says of them, where its links lead, and how long they take."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from bs4 import BeautifulSoup, Tag

from rosspin.site.times import EXERCISE
from tests.helpers.built_pages import parsed
from tests.helpers.small_sites import build
from tests.helpers.small_sites import site as small_site
from tests.helpers.tree import SITE

pytestmark = [pytest.mark.usefixtures("site"), pytest.mark.shares(3)]


def _page(name: str) -> BeautifulSoup:
    return parsed(SITE / f"{name}.html")


def _target(page: str, link: Tag) -> str:
    """Where a link of a page leads, without the path that it chooses."""
    address, mark, section = str(link["href"]).partition("#")
    file = (SITE / page).parent / address.partition("?")[0]
    return str(file.resolve().relative_to(SITE)) + mark + section


NAMES = ["quarter", "evening", "ros-2", "from-1-to-2", "ros-1", "stutters"]


def _rows(name: str) -> list[Tag]:
    return _page("docs/paths").select(f"table[id='{name}'] tbody tr")


def _steps(name: str) -> list[str]:
    return [_target("docs/paths", row.select("a.internal")[0]) for row in _rows(name)]


def _lines(name: str) -> Iterator[tuple[str, Tag]]:
    """The lines about a path on the pages that are on it.

    Links of exercises count for the list that has them, unless they lead from one of several, or from the list, to the
    next.
    """
    pages = [SITE / step for step in dict.fromkeys(step.partition("#")[0] for step in _steps(name))]
    for path in [*pages, *sorted(SITE.glob("exercises/*.html"))]:
        page = parsed(path)
        home = page.select_one(".exercise-way p a")
        for line in page.select(f".rosspin-path[data-path='{name}']"):
            found = _target("exercises/x", home) if home else path.relative_to(SITE).as_posix()
            onward = str(line.select("a")[-1]["href"])
            if "/" not in onward if home else onward.startswith("../exercises/"):
                continue
            yield found.removesuffix(".html"), line


def _minutes(name: str) -> int:
    return sum(int(row.select("td")[0].get_text()) for row in _rows(name))


@pytest.mark.parametrize("name", NAMES)
def test_each_page_says_where_on_a_path_it_is_and_what_comes_next(name: str) -> None:
    steps = _steps(name)
    assert len(steps) > 2
    found = {}
    for page, line in _lines(name):
        number, count = map(int, re.findall(r"(\d+) of (\d+)", line.get_text())[0])
        assert count == len(steps)
        assert steps[number - 1].startswith(f"{page}.html")
        home, *onward = line.select("a")
        assert _target(page, home) == f"docs/paths.html#{name}"
        assert [_target(page, link) for link in onward] == steps[number : number + 1]
        found[number] = line
    assert sorted(found) == list(range(1, len(steps) + 1))


def test_a_path_says_where_it_ends() -> None:
    [line] = _page("exercises/look-while-driving").select(".rosspin-path[data-path=evening]")
    assert line.get_text().endswith(" 8 of 8, part 4 of 4. You have reached its end.")
    [line] = _page("notebooks/drive").select(".rosspin-path[data-path=evening]")
    assert _target("notebooks/drive", line.select("a")[-1]) == "exercises/follow-the-line.html"


def test_a_page_shows_one_path_without_a_script() -> None:
    """A course, where there is one; of several steps on a page, each has its line where it ends."""
    lines = _page("notebooks/ros2-timer").select(".rosspin-path")
    assert [line["data-path"] for line in lines if not line.has_attr("hidden")] == ["ros-2"]
    assert len(lines) == 3
    onward = {}
    for name in "first-call", "call-back-once", "who-calls":
        [shown] = [line for line in _page(f"exercises/{name}").select(".rosspin-path") if not line.has_attr("hidden")]
        assert shown["data-path"] == "ros-2"
        onward[name] = _target(f"exercises/{name}", shown.select("a")[-1])
    assert list(onward.values()) == [f"exercises/{each}.html" for each in ("two-timers", "who-calls")] + [
        "docs/ros2/tutorial-rate.html"
    ]


@pytest.mark.parametrize("name", ["ros-2", "ros-1"])
def test_next_leads_along_the_course(name: str) -> None:
    steps = _steps(name)
    own = {page for page, line in _lines(name) if not line.has_attr("hidden")}
    pages = [step.partition("#")[0] for step in steps]
    assert len(own) > 10
    for page in own:
        places = [place for place, step in enumerate(pages) if step == f"{page}.html"]
        for place, selector in (places[0] - 1, "a.left-prev"), (places[-1] + 1, "a.right-next"):
            if 0 <= place < len(steps):
                assert [_target(page, link) for link in _page(page).select(selector)] == [steps[place]]


def test_the_sidebar_has_the_pages_in_the_order_of_the_course() -> None:
    course = [step for step in _steps("ros-2") if "#" not in step]
    listed = [_target("index", link) for link in _page("index").select("nav.bd-docs-nav a.internal")]
    shared = [page for page in course if page in listed[: listed.index("docs/catkin-workspace.html")]]
    in_sidebar = [page for page in listed if page in shared]
    assert len(shared) > 8
    first, *_ = (place for place, page in enumerate(in_sidebar) if page == "notebooks/drive.html")
    assert in_sidebar[:first] == [page for page in shared if page in in_sidebar[:first]]


def test_the_paths_take_as_long_as_they_say() -> None:
    assert _minutes("quarter") == 15
    assert abs(_minutes("evening") - 120) <= 15  # "about two hours"
    assert 4 <= _minutes("ros-2") / 120 <= 5
    assert _steps("evening")[-1] == "notebooks/drive.html" == _steps("ros-2")[-1]


@pytest.mark.parametrize(("name", "page"), [("ros-2", "ros2-exercises"), ("ros-1", "exercises")])
def test_each_exercise_follows_a_lesson_of_the_course(name: str, page: str) -> None:
    found = []
    for row in _rows(name):
        links = [link for link in row.select("a.internal") if "exercises.html" in str(link["href"])]
        found += [_target("docs/paths", link) for link in links]
        if links:
            assert int(row.select("td")[0].get_text()) == EXERCISE // 60 * len(links)
    headings = _page(f"notebooks/{page}").select(".exercise-list a")
    assert len({*found}) == len(found) == len(headings)


PATH = """

.. list-table:: {title}
   :name: way
   :class: path

   * - 5
     - :doc:`notebooks/book`
   * - 5
     - :doc:`index`
"""


def test_a_path_that_has_changed_is_told_anew(tmp_path: Path) -> None:
    """On a page that was not read again."""
    folder = small_site(tmp_path / "site", {})
    conf, index = folder / "conf.py", folder / "index.rst"
    conf.write_text(
        conf.read_text().replace('"rosspin.site.pages"', '"rosspin.site.pages", "rosspin.site.paths"')
        + "html_theme = 'basic'\n"
    )
    before = index.read_text()
    for title in ("A way", "Another way"):
        index.write_text(before + PATH.format(title=title))
        assert build(folder, "html").returncode == 0
        book = (folder / "build/html/notebooks/book.html").read_text()
        assert f'<a href="../index.html#way">{title}</a>, 1 of 2.' in book
        assert 'Next: <a href="../index.html?path=way">Page</a>' in book
