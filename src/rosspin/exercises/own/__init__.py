"""Exercises that are one file each: the site's own in this folder, and a teacher's.

A teacher's are in the folder ``lessons`` of the site, or in ``ROSSPIN_LESSONS``. A file holds what the exercise
is called, what it begins with, how an answer is checked, and answers that are right and wrong.
``docs/how-to/add-a-lesson.rst`` goes through one. The page's Python has all these files in this folder.
"""

from __future__ import annotations

import importlib
import os
import pkgutil
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from ..judging import Judge, language_of, plain

__all__ = ["EXERCISES", "FAULTS", "FOLDER", "LESSONS", "Answer", "Exercise", "Fault", "Lesson"]

Answer = str | Mapping[str, str]
"""A text; or what should be replaced in the solution, or else in that with which the exercise begins, and by what."""


class Exercise(NamedTuple):
    """An exercise.

    ``name`` stays, whatever comes before it: answers, files and links know it. ``number`` is what is shown, and
    ``part`` the heading below which it stands on the list of its ``ros``, 1 or 2; empty for one that is on neither.
    ``needs`` are the pages to read first, as paths without a suffix. ``reveals`` is the misconception that a wrong
    answer gives away, as its holder would put it. It takes answers in the languages of ``hints``, which are for answers
    about which there is nothing more to say.
    """

    title: str
    needs: tuple[str, ...]
    reveals: str
    hints: Mapping[str, str]
    judge: Judge
    name: str = ""
    part: str = ""
    ros: int = 0
    number: int = 0

    @property
    def languages(self) -> tuple[str, ...]:
        """The languages of its answers, as Pygments has them."""
        return tuple(self.hints)

    def hint(self, answer: Any) -> str:
        """Return the hint for an answer in its language, or in the first for any other."""
        language = language_of(answer)
        return self.hints.get(language.name if language else "python", [*self.hints.values()][0])


class Fault(NamedTuple):
    """What a file lacks, or has wrong: the file and the line, the text there, and what of it is not right."""

    file: Path
    line: int
    stands: str
    now: str


class Lesson(NamedTuple):
    """An exercise that is one file: its text, the node that it begins with, its hints, and answers, right and wrong.

    ``changed`` is what the answers change: the solution, where the file has one, or the node. With each wrong answer
    comes a part of what should be said of it, and maybe one of the hint. The first right one is the solution; ``after``
    is what is said below it. ``others`` are the same exercise in other languages than its ``language``.
    """

    exercise: Exercise
    file: Path
    text: str
    node: str
    changed: str
    hints: tuple[str, ...]
    right: tuple[Answer, ...]
    wrong: tuple[tuple[Any, ...], ...]
    after: str
    language: str = "python"
    others: tuple[Lesson, ...] = ()

    def written(self, answer: Answer) -> str:
        """Write an answer out. Raises ValueError if it replaces what is not there."""
        return _written(self.changed, answer)


def _written(text: str, answer: Answer) -> str:
    if isinstance(answer, str):
        return answer.lstrip("\n")
    for old, new in answer.items():
        if old not in text:
            raise ValueError(f"NODE has no {old!r}")
        text = text.replace(old, new)
    return text


# What a file has to say, of which type, and what that is.
_ASKED: Mapping[str, tuple[type | tuple[type, ...], str]] = {
    "TITLE": (str, "what the exercise is called"),
    "NODE": (str, "what the student begins with"),
    "HINTS": ((list, tuple), "a list of hints, one after the other"),
    "RIGHT": ((list, tuple), "a list of right answers, the first of which is the solution"),
    "WRONG": ((list, tuple), "a list of wrong answers, each with a part of what is said of it"),
}

_LISTS: Mapping[tuple[int, str], Sequence[str]] = {
    (2, "Start"): (
        *("make-it-10-hz", "first-call", "two-timers", "call-back-once", "period-parameter", "move-to-ros-2"),
    ),
    (2, "Predict"): ("who-calls", "slow-timer"),
    (2, "Publish"): ("publish-a-counter", "late-listener", "match-the-qos", "only-the-newest"),
    (2, "Wait"): (
        *("starving-neighbour", "ask-without-hanging", "let-a-callback-wait", "slow-service", "cancel-a-goal"),
        "find-the-order",
    ),
    (2, "End"): ("wake-a-rate", "end-without-a-traceback", "outlive-nothing"),
    (1, "Predict"): ("first-ticks", "after-a-slow-callback", "cpp-ticks"),
    (1, "Change"): (
        *("ten-hertz", "fire-once", "stop-after-five", "loop-to-timer", "frequency-parameter", "two-rates"),
        *("survive-an-overrun", "share-data", "stop-the-motor"),
    ),
    (1, "Diagnose"): ("missing-ticks", "name-the-fault"),
    (1, "Publish"): (*("what-is-heard", "publish-the-counter", "late-subscriber", "newest-position", "rostopic-hz"),),
}
"""The exercises of ``notebooks/ros2-exercises.md`` and ``notebooks/exercises.md``, by ROS and part, in their order."""

_IN_ORDER = (
    *("follow_the_line", "lose_the_line", "look_while_driving", "stop_when_blind", "stop_at_ctrl_c", "share_the_wheel"),
)
"""The tasks of ``notebooks/drive.md`` in this folder, in the order of their page."""

# How the names of what a file says again for C++ end.
_ENDS = ("_CPP",)

# The pages that an exercise needs, with links as in ``notebooks``: those there, and others.
_NEEDS = re.compile(r"\A\*\*You need\*\*:(.*?)\n\n", re.DOTALL)
_PAGE = re.compile(r"\]\((?:\.\./(docs/[\w/-]+)|([\w-]+))\.\w+\)")

FAULTS: list[Fault] = []
"""What is wrong in files that cannot be used."""


def _folder() -> Path | None:
    """Return the teacher's folder; None if there is none. In a page, the files are in this one."""
    if given := os.environ.get("ROSSPIN_LESSONS"):
        return Path(given)
    root = Path(__file__).parents[4]
    return root / "lessons" if (root / "lessons").is_dir() and (root / "conf.py").is_file() else None


def _modules() -> Iterator[tuple[str, ModuleType]]:
    found_all = sorted(pkgutil.iter_modules(__path__), key=lambda module: module.name)
    for found in sorted(found_all, key=lambda module: (*_IN_ORDER, module.name).index(module.name)):
        try:
            yield found.name, importlib.import_module(f"{__name__}.{found.name}")
        except Exception as error:
            file = Path(getattr(found.module_finder, "path", ""), f"{found.name}.py")
            trace, line = error.__traceback__, getattr(error, "lineno", None) or 1
            while trace:
                line = trace.tb_lineno if trace.tb_frame.f_code.co_filename == str(file) else line
                trace = trace.tb_next
            FAULTS.append(Fault(file, line, "it cannot be loaded", f"{type(error).__name__}: {plain(str(error))}"))


def _read(name: str, module: ModuleType) -> Lesson | None:
    """Turn a file into an exercise; None if it lacks something, which is then among ``FAULTS``."""
    file = Path(module.__file__ or name)
    before = len(FAULTS)
    for asked, (kind, what) in _ASKED.items():
        if not isinstance(getattr(module, asked, None), kind):
            FAULTS.append(Fault(file, 1, f"{asked} is missing", what))
    if not callable(getattr(module, "check", None)):
        FAULTS.append(Fault(file, 1, "check is missing", "a function that looks at an answer, and yields findings"))
    wrong = getattr(module, "WRONG", ())
    if isinstance(wrong, (list, tuple)) and not all(
        isinstance(each, Sequence) and len(each) in (2, 3) for each in wrong
    ):
        FAULTS.append(Fault(file, 1, "WRONG", "each is a pair: an answer, and a part of what is said of it"))
    if len(FAULTS) > before:
        return None
    text = getattr(module, "TEXT", "").strip()
    needs = _NEEDS.search(text)
    ends = ["", *(each for each in _ENDS if hasattr(module, f"NODE{each}"))]
    given = {_name(getattr(module, f"NODE{end}")): _hint(module, end) for end in ends}
    exercise = Exercise(
        title=module.TITLE,
        needs=tuple(folder or "notebooks/" + page for folder, page in _PAGE.findall(needs[1])) if needs else (),
        reveals=getattr(module, "REVEALS", ""),
        hints=given,
        judge=module.check,
        name=name.replace("_", "-"),
        ros=2 if re.search(r"\brclpy\b|\brclcpp/", module.NODE) else 1,
    )
    first, *others = [_in_language(exercise, file, text, module, end) for end in ends]
    return first._replace(others=tuple(others))


def _hint(module: ModuleType, end: str) -> str:
    hints = getattr(module, f"HINTS{end}")
    return str(getattr(module, f"HINT{end}", hints[0] if hints else "Look at the text of the exercise once more."))


def _in_language(exercise: Exercise, file: Path, text: str, module: ModuleType, end: str) -> Lesson:
    """Read what of a file is of one language: the names that have this ``end``."""
    node, solution = getattr(module, f"NODE{end}").lstrip("\n"), getattr(module, f"SOLUTION{end}", None)
    changed = node if solution is None else _written(node, solution)
    right = [*([] if solution is None else [changed]), *getattr(module, f"RIGHT{end}", ())]
    wrong = tuple(map(tuple, getattr(module, f"WRONG{end}", ())))
    hints, after = tuple(getattr(module, f"HINTS{end}")), getattr(module, f"AFTER{end}", "").strip()
    return Lesson(exercise, file, text, node, changed, hints, tuple(right), wrong, after, _name(node))


def _name(node: str) -> str:
    language = language_of(node)
    return language.name if language else "python"


FOLDER = _folder()
"""The teacher's folder; None if there is none."""

if FOLDER is not None:
    __path__.insert(0, str(FOLDER))

LESSONS = tuple(lesson for name, module in _modules() if (lesson := _read(name, module)))
"""These exercises: first the site's, then the teacher's, in the order of their files."""

_others = {lesson.exercise.name: lesson.exercise for lesson in LESSONS}
_listed = [_others.pop(name)._replace(ros=ros, part=part) for (ros, part), names in _LISTS.items() for name in names]
EXERCISES = tuple(each._replace(number=number) for number, each in enumerate([*_listed, *_others.values()], 1))
"""All exercises: on the two lists, with the vehicle, and then the teacher's."""
