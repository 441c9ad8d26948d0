"""The cells of the exercises, and answers to them as texts."""

from __future__ import annotations

import re
from typing import Any

import jupytext
from answers_ros1 import Answer
from tree import ROOT

from rosspin.exercises import EXERCISES

NUMBERS = list(range(1, len(EXERCISES) + 1))

NOTEBOOKS = {1: ROOT / "notebooks" / "exercises.md", 2: ROOT / "notebooks" / "ros2-exercises.md"}

ON_PAGE = {ros: [exercise.number for exercise in EXERCISES if exercise.ros == ros] for ros in NOTEBOOKS}


def _cells() -> dict[int, list[Any]]:
    """The cells of each exercise in the notebooks that hold an answer."""
    found: dict[int, list[Any]] = {number: [] for number in NUMBERS}
    for notebook in NOTEBOOKS.values():
        for cell in jupytext.read(notebook).cells:
            if match := re.match(r"%%answer (\d+)\n", cell.source):
                found[int(match[1])].append(cell)
    return found


CELLS = _cells()


def answer_in(cell: Any) -> str:
    """What a cell answers."""
    text: str = cell.source.partition("\n")[2]
    return text


def written(number: int, answer: Answer) -> str:
    """An answer as a text."""
    if isinstance(answer, str):
        return answer
    text = answer_in(CELLS[number][1])
    for old, new in answer.items():
        assert old in text, old
        text = text.replace(old, new)
    return text


PAGES = {ros: notebook.read_text(encoding="utf-8") for ros, notebook in NOTEBOOKS.items()}


def section(number: int) -> str:
    """The text of an exercise on the page."""
    page = PAGES[EXERCISES[number - 1].ros]
    return re.split(r"^##+ ", page.partition(f"### {number}. ")[2], maxsplit=1, flags=re.MULTILINE)[0]


def solution_of(number: int) -> dict[str, list[float]]:
    """The predictions that are right."""
    found: dict[str, list[float]] = {}
    exec(answer_in(CELLS[number][1]), found)
    return found
