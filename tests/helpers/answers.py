"""The cells of the exercises, and answers to them as texts."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any

import answers_ros1
import jupytext
from answers_ros1 import Answer
from tree import ROOT

from rosspin.exercises import EXERCISES
from rosspin.exercises.own import LESSONS

NAMES = [exercise.name for exercise in EXERCISES if exercise.part]  # a teacher's own have answers of their own

FILES = {lesson.exercise.name: lesson for lesson in LESSONS if lesson.exercise.name in NAMES}

TASKS = [lesson for lesson in LESSONS if "own" in lesson.file.parts and lesson.exercise.name not in NAMES]

NOTEBOOKS = {1: ROOT / "notebooks" / "exercises.md", 2: ROOT / "notebooks" / "ros2-exercises.md"}

ON_PAGE = {ros: [exercise.name for exercise in EXERCISES if exercise.ros == ros and exercise.part] for ros in NOTEBOOKS}


def _cells() -> dict[str, list[Any]]:
    """The cells of each exercise that hold an answer: in the notebooks, or made from its file."""
    found: dict[str, list[Any]] = {name: [] for name in NAMES}
    for name, file in FILES.items():
        texts = file.node, file.changed
        found[name] = [SimpleNamespace(source=f"%%answer {name}\n{text.rstrip()}") for text in texts]
    for notebook in NOTEBOOKS.values():
        for cell in jupytext.read(notebook).cells:
            if match := re.match(r"%%answer (\S+)\n", cell.source):
                found[match[1]].append(cell)
    return found


CELLS = _cells()


def answer_in(cell: Any) -> str:
    """What a cell answers."""
    text: str = cell.source.partition("\n")[2]
    return text


def written(name: str, answer: Answer) -> str:
    """An answer as a text."""
    if name in FILES:
        return FILES[name].written(answer)
    if isinstance(answer, str):
        return answer
    text = answer_in(CELLS[name][1])
    for old, new in answer.items():
        assert old in text, old
        text = text.replace(old, new)
    return text


PAGES = {ros: notebook.read_text(encoding="utf-8") for ros, notebook in NOTEBOOKS.items()}


def section(name: str) -> str:
    """The text of an exercise on the page."""
    if name in FILES:
        return f"{FILES[name].text}\n\n"
    exercise = EXERCISES[number_of(name) - 1]
    rest = PAGES[exercise.ros].partition(f"### {exercise.number}. ")[2]
    return re.split(r"^##+ ", rest, maxsplit=1, flags=re.MULTILINE)[0]


def solution_of(name: str) -> dict[str, list[float]]:
    """The predictions that are right."""
    found: dict[str, list[float]] = {}
    exec(answer_in(CELLS[name][1]), found)
    return found


def number_of(name: str) -> int:
    """The number that is shown of an exercise."""
    return NAMES.index(name) + 1


# The cases of the exercise on a late subscriber, each with the sides that have the profile of its page.
LATE = {
    "both_plain": [],
    "both_keep": ["publisher", "subscription"],
    "only_publisher": ["publisher"],
    "only_subscription": ["subscription"],
}


def late_listener(variable: str) -> str:
    """The node of that exercise, as it is in one of its cases."""
    node, profile = re.findall(r"```python\n(.*?)```", section("late-listener"), re.DOTALL)
    sides = {"publisher": 'UInt32, "counter", 10)', "subscription": "self.counter_callback, 10)"}
    for side in LATE[variable]:
        assert node.count(sides[side]) == 1
        node = node.replace(sides[side], sides[side].replace("10", profile.strip()))
    return f"from rclpy.qos import DurabilityPolicy, QoSProfile\n{node}"


RIGHT = answers_ros1.RIGHT | {name: list(file.right[1:]) for name, file in FILES.items()}
WRONG = answers_ros1.WRONG | {name: [(*wrong, "")[:3] for wrong in file.wrong] for name, file in FILES.items()}
