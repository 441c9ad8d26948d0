"""The exercises of the lists: what they begin with, their solutions, and other answers, as texts."""

from __future__ import annotations

import re
from types import SimpleNamespace

from rosspin.exercises import EXERCISES
from rosspin.exercises.own import LESSONS, Answer

from .tree import ROOT

NAMES = [exercise.name for exercise in EXERCISES if exercise.part]  # a teacher's own have answers of their own

FILES = {lesson.exercise.name: lesson for lesson in LESSONS if lesson.exercise.name in NAMES}

# Those that are in C++, too, or only.
IN_CPP = {
    lesson.exercise.name: each for lesson in LESSONS for each in (lesson, *lesson.others) if each.language == "cpp"
}

TASKS = [lesson for lesson in LESSONS if "own" in lesson.file.parts and lesson.exercise.name not in NAMES]

NOTEBOOKS = {1: ROOT / "notebooks" / "exercises.md", 2: ROOT / "notebooks" / "ros2-exercises.md"}

ON_PAGE = {ros: [exercise.name for exercise in EXERCISES if exercise.ros == ros and exercise.part] for ros in NOTEBOOKS}

# The cells of each: that with which it begins, and the solution.
CELLS = {
    name: [SimpleNamespace(source=f"%%answer {name}\n{text.rstrip()}") for text in (file.node, file.changed)]
    for name, file in FILES.items()
}


def answer_in(cell: SimpleNamespace) -> str:
    """What a cell answers."""
    text: str = cell.source.partition("\n")[2]
    return text


def written(name: str, answer: Answer) -> str:
    """An answer as a text."""
    return FILES[name].written(answer)


def listings(name: str, language: str = "python") -> list[str]:
    """The listings in the text of an exercise, without a first line for the notebook."""
    found = re.findall(rf"```{language}\n(?:%%.*\n)?((?:.*\n)*?)```", FILES[name].text)
    return found


def solution_of(name: str) -> dict[str, list[float]]:
    """The predictions that are right."""
    found: dict[str, list[float]] = {}
    exec(FILES[name].changed, found)
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
    node, profile = listings("late-listener")
    sides = {"publisher": 'UInt32, "counter", 10)', "subscription": "self.counter_callback, 10)"}
    for side in LATE[variable]:
        assert node.count(sides[side]) == 1
        node = node.replace(sides[side], sides[side].replace("10", profile.strip()))
    return f"from rclpy.qos import DurabilityPolicy, QoSProfile\n{node}"


RIGHT = {name: list(file.right[1:]) for name, file in FILES.items()}
WRONG = {name: [(*wrong, "")[:3] for wrong in file.wrong] for name, file in FILES.items()}
