"""The checks of the exercises in ``notebooks/exercises.md`` and ``notebooks/ros2-exercises.md``, and of a teacher's.

An answer is a text: a node file, or predictions as assignments. A check runs it in simulated time and says what is
right, what is wrong, and how to continue. It raises nothing, whatever the answer is. It looks at what the node did,
such as which timers were still alive in the end, not at how the node is written.

Running and judging can be done in two Pythons: :func:`trace` runs the answer and writes down what it did;
:func:`judge` judges that, in a Python in which the answer has never run.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from ..vehicle.drawn import drawn
from .feedback import Feedback, Finding
from .judging import Answer, Fails
from .observed import ObservedRun
from .own import EXERCISES, Exercise
from .reach import reaches_for
from .running import Runner
from .traces import Misfit, Outcome, Request, Trace, read, write

__all__ = ["EXERCISES", "Exercise", "Feedback", "Finding", "Misfit", "check", "judge", "trace"]

_NOTHING = ObservedRun(0.0, (), (), (), (), (), (), (), (), 0, (), False, None, False, ())
_CUT = "the node did so much that not all of it was looked at."
_LESS = "It should print and publish no more than the exercise asks for."


def check(which: int | str, answer: Any) -> Feedback:
    """Check the answer to an exercise, a text. The answer ``...`` is not right yet.

    The exercise is given by its number or its name. Raises ValueError if there is no such exercise.
    """
    return judge(which, answer, trace(which, answer))


def code(answer: str) -> str:
    """Return what of an answer is checked, in the same lines: its first line is not, if it begins with %%."""
    return f"\n{answer.partition(chr(10))[2]}" if answer.startswith("%%") else answer


def trace(which: int | str, answer: Any) -> str:
    """Run an answer, and write down what it did as JSON, in not much more than 2 MB.

    Raises ValueError if there is no such exercise.
    """
    exercise = _exercise(which)
    runner = Runner(answer, exercise.ros)
    outcomes: list[Outcome] = []

    def ask(request: Request) -> Outcome:
        outcomes.append(runner(request))
        return outcomes[-1]

    _find(exercise, Answer(answer, exercise.ros, exercise.languages, ask))  # to hear what it asks for
    return write(Trace(exercise.name, runner.console, runner.cut, tuple(outcomes)))


def judge(which: int | str, answer: Any, traced: str) -> Feedback:
    """Judge an answer by the trace of its runs, without running any of it.

    Raises ValueError if there is no such exercise, and :class:`Misfit` for what is no trace of this one. An answer that
    took over the Python in which it ran can have forged its trace, which then describes the runs of another answer.
    """
    exercise = _exercise(which)
    _, console, cut, outcomes = read(traced, exercise.name)
    left = list(reversed(outcomes))

    def ask(request: Request) -> Outcome:
        if not left or left[-1].request != request:
            raise Misfit("its runs are not those that this exercise asks for")
        return left.pop()

    given = Answer(answer, exercise.ros, exercise.languages, ask)
    findings = _find(exercise, given)
    early = given.hint_for_early_end()
    if early and all(finding.right for finding in findings):
        findings.append(Finding(False, "the node ended by itself."))
    if left:
        raise Misfit("it has more runs than this exercise asks for")
    whole = not cut or any(finding.right is False for finding in findings)
    if not whole:
        findings.append(Finding(False, _CUT, _LESS))
    first = next((finding.hint for finding in findings if not finding.right), "")
    hint = given.hint_for_uncalled() or (console and first) or early or first or exercise.hint(answer)
    return Feedback(exercise.number, tuple(findings), hint, console, whole=whole, drive=_first_run(outcomes).drive)


def drawing(name: str, traced: str) -> list[str]:
    """Draw what a vehicle did in the first run of an answer: what :func:`rosspin.vehicle.drawn.drawn` returns.

    It raises nothing, and returns nothing for what is no trace of the exercise of this name.
    """
    try:
        run = _first_run(read(traced, name).outcomes)
        ticks = sorted(time for timer in run.timers for time in timer.calls)
        return drawn(run.drive, ticks, run.seconds)
    except Exception:  # a trace may be made of anything
        return []


def _first_run(outcomes: Sequence[Outcome]) -> ObservedRun:
    return outcomes[0].run or _NOTHING if outcomes else _NOTHING


class Verdict(NamedTuple):
    """What is said of an answer that was handed in.

    The ``verdict`` is "solved", "not yet", "open" (not answered yet), "to read" (by the teacher, as not all of it was
    looked at) or "not judged". ``status`` is the verdict in a line, ``console`` what the answer printed, and ``said``
    the feedback. Of an answer that is wrong, ``why`` is the first thing that is, and ``hint`` how to continue. If
    a vehicle ran with it, ``off`` is how far (m) that came off its line in the first run.
    """

    verdict: str
    solved: bool
    status: str
    console: str
    said: str
    why: str = ""
    hint: str = ""
    off: float | None = None


def verdict(which: int | str, answer: str, traced: str) -> Verdict:
    """Judge an answer by the trace of its runs as :func:`judge` does, whatever both are. It raises nothing."""
    try:
        feedback, found = judge(which, answer, traced), reaches_for(answer)
    except Exception as error:  # a trace may be made of anything
        said = str(error if isinstance(error, ValueError) else Misfit("it is damaged"))
        return Verdict("not judged", False, f"Exercise {which}: not judged.", "", said)
    said = _plain(str(feedback))
    if found:
        said += f"\n\nThe answer uses {found}, which no exercise needs."
    kind = _kind(feedback)
    wrong = [finding.text for finding in feedback.findings if finding.right is False]
    why, hint = (_plain(wrong[0]), _plain(feedback.hint)) if kind == "not yet" else ("", "")
    off = round(feedback.drive.worst.off, 3) if feedback.drive.spots else None
    return Verdict(kind, feedback.passed, feedback.verdict, feedback.console, said, why, hint, off)


def _plain(text: str) -> str:
    """Return a text without the marks of Markdown."""
    return text.replace("`", "")


def _kind(feedback: Feedback) -> str:
    if feedback.passed:
        return "solved"
    if feedback.is_open:
        return "open"
    *findings, last = feedback.findings
    return "not yet" if feedback.whole or not all(finding.right for finding in findings) else "to read"


def _exercise(which: int | str) -> Exercise:
    for exercise in EXERCISES:
        if which in (exercise.number, exercise.name):
            return exercise
    raise ValueError(
        f"there is no exercise {which!r}: they are numbered 1 to {len(EXERCISES)}, and have the names in the first "
        "lines of their cells"
    )


def _find(exercise: Exercise, answer: Answer) -> list[Finding]:
    findings: list[Finding] = []
    try:
        # One by one: what was found before an answer fails is kept.
        found = exercise.judge(answer)
        if found is None or isinstance(found, Finding):
            raise TypeError(f"check returned {'a Finding' if found else 'nothing'}: let it yield each Finding")
        for finding in found:
            findings.append(finding)
    except Fails as failure:
        findings.append(failure.finding)
    return findings
