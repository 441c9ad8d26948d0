"""The checks of the exercises in ``notebooks/exercises.md`` and ``notebooks/ros2-exercises.md``.

An answer is a text: a node file, or predictions as assignments. A check runs it in simulated time and says what is
right, what is wrong, and how to go on; whatever the answer is, it raises nothing. It looks at what the node did, such
as which timers were still alive in the end, not at how the node is written.
"""

from __future__ import annotations

from typing import Any

from . import questions, questions_ros2
from .exercise import Exercise
from .feedback import Feedback, Finding
from .judging import Answer, Fails

__all__ = ["EXERCISES", "Exercise", "Feedback", "Finding", "check"]

EXERCISES: tuple[Exercise, ...] = (*questions.EXERCISES, *questions_ros2.EXERCISES)
"""All exercises, in the order of their numbers."""

_ENDS_EARLY = "The node ended by itself, before its time was over. Does its main part come to `{}`?"


def check(number: int, answer: Any) -> Feedback:
    """Check the answer to an exercise, a text; one that is ``...`` is not right yet.

    Raises ValueError for a number that no exercise has.
    """
    if number not in range(1, len(EXERCISES) + 1):
        raise ValueError(f"there is no exercise {number!r}: they are numbered 1 to {len(EXERCISES)}")
    exercise = EXERCISES[number - 1]
    given = Answer(answer, exercise.ros)
    findings: list[Finding] = []
    try:
        # One by one: what was found before an answer fails is kept.
        for finding in exercise.find(given):
            findings.append(finding)
    except Fails as failure:
        findings.append(failure.finding)
    hints = [finding.hint for finding in findings if not finding.right and finding.hint]
    if given.ended_early:
        # Said first of a node that did nothing, and last of one that did something.
        hints.insert(len(hints) if given.console else 0, _ENDS_EARLY.format(given.ros.SPINS))
    return Feedback(number, tuple(findings), [*hints, exercise.hint][0], given.console)
