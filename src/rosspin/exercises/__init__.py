"""The checks of the exercises in ``notebooks/exercises.md`` and ``notebooks/ros2-exercises.md``.

An answer is a text: a node file, or predictions as assignments. A check runs it in simulated time and says what is
right, what is wrong, and how to go on; whatever the answer is, it raises nothing. It looks at what the node did, such
as which timers were still alive in the end, not at how the node is written.

The two can be done in two Pythons: :func:`trace` runs the answer and writes down what it did, and :func:`judge` says
what is to be said of that, in a Python that the answer has never run in.
"""

from __future__ import annotations

from typing import Any

from .feedback import Feedback, Finding
from .judging import Answer, Fails
from .questions import EXERCISES, Exercise
from .running import Runner
from .traces import Misfit, Outcome, Request, Trace, read, write

__all__ = ["EXERCISES", "Exercise", "Feedback", "Finding", "Misfit", "check", "judge", "trace"]

_CUT = "the node did so much that not all of it was looked at."
_LESS = "Let it print and publish no more than the exercise asks for."


def check(which: int | str, answer: Any) -> Feedback:
    """Check the answer to an exercise, a text; one that is ``...`` is not right yet.

    The exercise is given by its number or its name. Raises ValueError for one that there is not.
    """
    return judge(which, answer, trace(which, answer))


def trace(which: int | str, answer: Any) -> str:
    """Run an answer, and write down what it did, as JSON; what it shows is not much larger than 2 MB.

    Raises ValueError for an exercise that there is not.
    """
    exercise = _exercise(which)
    run = Runner(answer, exercise.ros)
    outcomes: list[Outcome] = []

    def ask(request: Request) -> Outcome:
        outcomes.append(run(request))
        return outcomes[-1]

    _find(exercise, Answer(answer, exercise.ros, ask))  # for what it asks
    return write(Trace(exercise.number, run.console, run.cut, tuple(outcomes)))


def judge(which: int | str, answer: Any, traced: str) -> Feedback:
    """What is to be said of an answer by the trace of its runs. Nothing of it is run.

    Raises ValueError for an exercise that there is not, and :class:`Misfit` for what is no trace of this one. A trace
    that was forged, by an answer that took over the Python that it ran in, can describe the runs of another.
    """
    exercise = _exercise(which)
    _, console, cut, outcomes = read(traced, exercise.number)
    left = list(reversed(outcomes))

    def ask(request: Request) -> Outcome:
        if not left or left[-1].request != request:
            raise Misfit("it is not of what this exercise asks for")
        return left.pop()

    given = Answer(answer, exercise.ros, ask)
    findings = _find(exercise, given)
    if left:
        raise Misfit("there is more in it than this exercise asks for")
    if cut:
        findings.append(Finding(False, _CUT, _LESS))
    hints = [finding.hint for finding in findings if not finding.right and finding.hint]
    if early := given.hint_for_early_end():
        # Said first of a node that did nothing, and last of one that did something.
        hints.insert(len(hints) if console else 0, early)
    return Feedback(exercise.number, tuple(findings), [*hints, exercise.hint][0], console, whole=not cut)


def _exercise(which: int | str) -> Exercise:
    for exercise in EXERCISES:
        if which in (exercise.number, exercise.name):
            return exercise
    raise ValueError(f"there is no exercise {which!r}: they are numbered 1 to {len(EXERCISES)}")


def _find(exercise: Exercise, answer: Answer) -> list[Finding]:
    findings: list[Finding] = []
    try:
        # One by one: what was found before an answer fails is kept.
        for finding in exercise.judge(answer):
            findings.append(finding)
    except Fails as failure:
        findings.append(failure.finding)
    return findings
