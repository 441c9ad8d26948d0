"""Each exercise of the site has a page of its own, and stands on a list."""

from __future__ import annotations

from pathlib import Path

import pytest
from bs4 import BeautifulSoup

from rosspin.exercises import EXERCISES
from rosspin.site.exercise_pages import difference
from tests.helpers.answers import TASKS
from tests.helpers.built_pages import parsed
from tests.helpers.tree import SITE

pytestmark = pytest.mark.usefixtures("site")

DRIVEN = [task.exercise.name for task in TASKS]
LISTS = {
    "notebooks/ros2-exercises": [each.name for each in EXERCISES if each.ros == 2 and each.part],
    "notebooks/exercises": [each.name for each in EXERCISES if each.ros == 1 and each.part],
    "notebooks/drive": DRIVEN,
}
TITLES = {each.name: f"{each.number}. {each.title}".replace("10 Hz", "10\N{NO-BREAK SPACE}Hz") for each in EXERCISES}


def _page(name: str) -> BeautifulSoup:
    return parsed(SITE / f"exercises/{name}.html")


@pytest.mark.parametrize("home", LISTS)
def test_a_list_has_titles_times_and_the_anchors_that_it_always_had(home: str) -> None:
    page = parsed(SITE / f"{home}.html")
    items = page.select("ul.exercise-list > li")
    assert len(items) == len(LISTS[home])
    for name, item in zip(LISTS[home], items, strict=True):
        [link] = item.select("a")
        assert (link.get_text(), link["href"], link["data-exercise"]) == (
            TITLES[name],
            f"../exercises/{name}.html",
            name,
        )
        assert item.select_one("small").get_text().endswith(" minutes")  # type: ignore[union-attr]
        assert name in [tag["id"] for tag in item.select("[id]")]
    assert not [pre for pre in page.select("pre") if pre.get_text().startswith("%%answer ")]


@pytest.mark.parametrize(("home", "name"), [(home, name) for home, names in LISTS.items() for name in names])
def test_a_page_has_one_answer_for_each_language_hints_and_the_solution_and_knows_its_place(
    home: str, name: str
) -> None:
    page, names = _page(name), LISTS[home]
    place = names.index(name)
    assert page.select_one("h1").get_text() == f"{TITLES[name]}#"  # type: ignore[union-attr]
    [way] = page.select("nav.exercise-way")
    assert f", {place + 1} of {len(names)}" in way.get_text()
    assert [link["data-exercise"] for link in way.select("li a")] == names
    assert [link["data-exercise"] for link in way.select("[aria-current]")] == [name]
    assert way.select_one("p a")["href"] == f"../{home}.html"  # type: ignore[index]
    [onward] = page.select("p.exercise-next[hidden] a")
    assert onward["href"] == (f"{names[place + 1]}.html" if place + 1 < len(names) else f"../{home}.html")
    languages = next(each.languages for each in EXERCISES if each.name == name)
    answers = [pre for pre in page.select("div.live pre") if pre.get_text().startswith("%%answer ")]
    assert len(answers) == len(languages)
    for language, answer in zip(languages, answers, strict=True):
        assert answer.get_text().startswith(f"%%answer {name}\n") and not answer.find_parent(class_="cell_output")
        assert bool(answer.find_parent(class_="highlight-cpp")) is (language == "cpp")
        tab = answer.find_parent(class_="sd-tab-content")
        assert (tab is None) is (len(languages) == 1)
        folded = (tab or page.select_one("article")).select("details")  # type: ignore[union-attr]
        *hints, solution = [each.select_one("summary").get_text() for each in folded]  # type: ignore[union-attr]
        assert hints == [f"Hint {number}" for number in range(1, len(hints) + 1)] and len(hints) >= 2
        assert solution == "Show the solution"
    for tabs in page.select(".sd-tab-set"):  # what chooses a tab stands right before its name
        parts = [part.name for part in tabs.find_all(recursive=False)]
        assert parts == ["input", "label", "div"] * len(languages)


def test_no_page_is_left_of_an_exercise_that_is_gone(site: Path) -> None:
    assert {path.stem for path in site.glob("exercises/*.html")} == {name for names in LISTS.values() for name in names}


def test_a_solution_is_a_difference_unless_all_of_it_is_new() -> None:
    start = "".join(f"line {number}\n" for number in range(20))
    shown = difference(start, start.replace("line 3\n", "three\n").replace("line 15\n", ""))
    assert shown["language"] == "diff"
    lines = [" line 1", " line 2", "-line 3", "+three", " line 4", " line 5", "..."]
    assert shown.astext().splitlines() == [*lines, " line 13", " line 14", "-line 15", " line 16", " line 17"]
    other = difference(start, "something\nelse\n")
    assert (other["language"], other.astext()) == ("ipython3", "something\nelse")
