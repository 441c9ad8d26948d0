"""Have an answer run, refuse what cannot be judged, and find the words for it."""

from __future__ import annotations

import ast
from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import zip_longest
from typing import Any

from ..run.kinds import LANGUAGES, ROS, Language, words_of, written_in
from ..run.source import refuse_null_bytes
from .feedback import Finding
from .observed import Error, ObservedRun, Value
from .traces import Outcome, Request

__all__ = [
    "MADE_AGAIN",
    "MANY_TIMERS",
    "Answer",
    "Fails",
    "Judge",
    "a_value",
    "above",
    "hint_for_kept",
    "language_of",
    "not_python",
    "plain",
    "say",
    "say_error",
    "say_kept",
    "started",
]

_DAEMON = (
    "After Ctrl-C nothing wakes a Rate any more, and Python waits for the thread that is asleep. Use a Rate only in a "
    "daemon thread: `Thread(target=..., daemon=True)`."
)
_ZERO = "In Python `1 // 10` is 0, and `1 / 10` is 0.1. A decimal number has a point: `0,1` is two numbers, 0 and 1."
_ZERO_IN_CPP = "In C++, `1 / 10` is 0, as both are whole numbers, and `1 / 10.0` is 0.1."
# What to say of more timers that run in the end than an exercise needs, and how many it needs at most.
MADE_AGAIN = "Each call of a callback makes one more timer: make it once, where the node is made."
MANY_TIMERS = 9
_NAMES = {"python": "Python", "cpp": "C++"}
_NO_ANSWER = "No answer yet."
_ENDS_EARLY = "The node ended by itself, before its time was over. Does its main part come to `{}`?"


class Fails(Exception):
    """Nothing more can be found out about an answer: it is wrong, or, if ``right`` is None, not there yet."""

    def __init__(self, text: str, hint: str = "", right: bool | None = False) -> None:
        self.finding = Finding(right, text, hint)


# --- an answer --------------------------------------------------------------------------------------------------------


class Answer:
    """The answer to one exercise, which is on ROS 1 or 2 and takes answers in these ``languages``.

    ``ask`` returns the outcome of a run: it runs the answer, or looks the outcome up in a trace. Nothing is run here.
    """

    def __init__(self, text: Any, ros: int, languages: Collection[str], ask: Callable[[Request], Outcome]) -> None:
        self._text = text
        self._ros = ros
        self._languages = languages
        self._language = language_of(text)
        self._ask = ask
        self._tree: ast.Module | None = None
        self._ended_early = False

    def run(
        self,
        seconds: float,
        given: str = "",
        *,
        seed: int | None = None,
        stalls_at: float | None = None,
        allowed: str = "",
        has_to_end: bool = True,
        beside: Sequence[str] = (),
        interrupted_at: float | None = None,
    ) -> ObservedRun:
        """Run the answer as a node in simulated time, with a parameter ``given`` as in ``period:=0.5``.

        With a ``seed`` its threads take turns at any point; from ``stalls_at`` (s) on, nothing of it runs for a while.
        The nodes in ``beside`` are processes of their own: "vehicle", "silent vehicle" (its sensor is, from 3 s to
        5 s), "joystick" and others (:mod:`rosspin.vehicle.ros2`). If Ctrl-C comes earlier in the answer,
        ``interrupted_at`` (s), they continue to the end.

        The check ends if the node cannot be run, if it fails with an error whose text lacks ``allowed``, or if it
        ``has_to_end`` and Ctrl-C does not end it. An exception with which Ctrl-C ends nodes of its ROS is no failure.
        """
        args = self._args(given)
        request = Request(seconds, args, None, seed, stalls_at, (), tuple(beside), interrupted_at)
        run = self._node(request)
        if has_to_end or not run.killed:
            self._refuse(run, args, allowed)
        if any(timer.is_endless for timer in run.timers):
            zero = _ZERO_IN_CPP if self._language else _ZERO
            raise Fails(f"{started(args)} node has a timer whose period is 0 s: it is called without a pause.", zero)
        if (running := sum(timer.state == "running" for timer in run.timers)) > MANY_TIMERS:
            raise Fails(f"{started(args)} node has {running} timers.", MADE_AGAIN)
        self._ended_early |= not run.interrupted and not allowed and seed is None
        return run

    def ending(self, seconds: float, given: str = "", terminated_at: float | None = None) -> ObservedRun:
        """Run it, and let it end as it will; SIGTERM may come before Ctrl-C. If it cannot be run, the check ends."""
        return self._node(Request(seconds, self._args(given), terminated_at))

    def variables(self, *names: str) -> dict[str, Value]:
        """Return which of these variables the answer assigns. If it cannot be run, or fails, the check ends."""
        self._parse()
        run = self._look(Request(0.0, variables=names))
        self._refuse(run, (), "")
        return dict(run.variables)

    def hint_for_early_end(self) -> str:
        """Return a hint for a node that ended before its time; empty for any other."""
        return _ENDS_EARLY.format(words_of(self._language, self._ros).spins) if self._ended_early else ""

    def hint_for_uncalled(self) -> str:
        """Return a hint for a line that names a function and does not call it; empty if there is none."""
        for node in ast.walk(self._tree or ast.Module([], [])):
            if isinstance(node, ast.Expr) and isinstance(node.value, ast.Attribute):
                name = plain(ast.unparse(node.value))
                return f"Line {node.lineno} names `{name}` and does not call it: write `{name}()`."
        return ""

    def _args(self, given: str) -> tuple[str, ...]:
        """Return the command line that gives a node of this ROS a parameter."""
        return tuple(ROS[self._ros].settings("-p", [given])) if given else ()

    def _node(self, request: Request) -> ObservedRun:
        tree = self._parse()
        if tree is None:
            return self._look(request)
        if gaps := _gaps(tree):
            lines = f"line {gaps[0]}" if len(gaps) == 1 else f"lines {', '.join(map(str, gaps))}"
            raise Fails(f"There is still a gap, `...`, in {lines}.", right=None)
        if not tree.body:
            raise Fails(_NO_ANSWER, right=None)
        return self._look(request)

    def _look(self, request: Request) -> ObservedRun:
        _, run, failure = self._ask(request)
        if run is None:
            assert failure
            raise Fails(*failure)
        return run

    def _parse(self) -> ast.Module | None:
        """Parse the answer; None if it is in another language. If it is in none that it can be in, the check ends."""
        if self._tree:
            return self._tree
        source = self._text
        name = self._language.name if self._language else "python"
        if name not in self._languages and isinstance(source, str):
            raise Fails(f"This exercise takes an answer in {' or '.join(_NAMES[each] for each in self._languages)}.")
        if self._language:
            self._refuse_another_ros(self._language, source)
            return None
        if source is ... or source is None:
            raise Fails(_NO_ANSWER, "Write it in a cell that begins with `%%answer`.", right=None)
        if not isinstance(source, str):
            raise Fails(f"The answer is a text, not {a_value(type(source).__name__)}.")
        try:
            refuse_null_bytes(source, "<answer>")
            self._tree = ast.parse(source)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            raise Fails(*not_python(error)) from None
        self._refuse_the_other_ros(_imported(self._tree))
        return self._tree

    def _refuse_another_ros(self, language: Language, source: str) -> None:
        if other := language.named_in(source) - {self._ros}:
            text = f"This node is for ROS {other.pop()}, by what it includes."
            raise Fails(text, f"This exercise is on ROS {self._ros}: include what its node includes.")

    def _refuse_the_other_ros(self, imported: Collection[str]) -> None:
        own = ROS[self._ros].roots[0]
        here = f"This exercise is on ROS {self._ros}, where a node imports `{own}`."
        for ros in ROS.values():
            other = ros.roots[0]
            if other in imported and ros.number != self._ros:
                if own in imported:
                    raise Fails("The node imports both `rospy` (ROS 1) and `rclpy` (ROS 2). A node has one ROS.", here)
                raise Fails(f"This node is for ROS {ros.number}: it imports `{other}`.", here)

    def _refuse(self, run: ObservedRun, args: Sequence[str], allowed: str) -> None:
        """End the check if something went wrong in a run."""
        may_end = ROS[self._ros].raises and run.interrupted and not self._language

        def is_well(error: Error) -> bool:
            return bool(allowed and allowed in error.said) or (may_end and error.ending)

        if wrong := [error for error in run.errors if not is_well(error)]:
            raise Fails(f"{started(args)} {say_error(wrong[-1])}", run.errors[-1].hint)
        if run.killed:
            kept = say_kept(run, self._ros)
            raise Fails(f"{started(args)} node did not end at Ctrl-C: {kept}", hint_for_kept(run))
        if run.status and not run.errors and not may_end:
            raise Fails(f"{started(args)} node ended with status {run.status} instead of 0.")


Judge = Callable[[Answer], Iterator[Finding]]
"""Looks at an answer, runs it as often as needed, and says what it finds."""


def _imported(tree: ast.Module) -> set[str]:
    """Return the first words of the names of the modules that an answer imports."""
    nodes = list(ast.walk(tree))
    names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    names += [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
    return {name.partition(".")[0] for name in names}


def _gaps(tree: ast.AST) -> list[int]:
    """Return the lines with a gap left: an ``...`` that has no meaning in Python."""
    meant: set[ast.AST] = set()
    for node in ast.walk(tree):
        match node:
            case ast.Subscript(slice=index):  # Tuple[int, ...], array[..., 0]
                meant.update(ast.walk(index))
            case ast.FunctionDef(body=body) | ast.AsyncFunctionDef(body=body) if _is_empty(body):
                meant.update(ast.walk(node))  # its defaults, too
            case ast.ClassDef(body=body) if _is_empty(body):
                meant.update(each for statement in body for each in ast.walk(statement))
    constants = [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and node.value is ...]
    return [node.lineno for node in constants if node not in meant]


def _is_empty(body: Sequence[ast.stmt]) -> bool:
    """Whether a body is no more than ``...``, maybe below a docstring."""
    return all(isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant) for each in body)


# --- words ------------------------------------------------------------------------------------------------------------


def plain(text: str) -> str:
    """Fit a text, the reader's or Python's, into a line of Markdown: without backquotes, and not too long."""
    return " ".join(text.split()).replace("`", "'")[:300]


def a_value(kind: str) -> str:
    """Say what a value is to a reader who gave one of the wrong type."""
    return f"a value of type `{plain(kind)}`"


def above(**rows: Sequence[str]) -> tuple[str, ...]:
    """Write the values of rows below each other, each row after its name."""
    table = [[name.replace("_", " "), *values] for name, values in rows.items()]
    widths = [max(map(len, column)) for column in zip_longest(*table, fillvalue="")]
    return tuple("  ".join(map(str.ljust, row, widths)).rstrip() for row in table)


def say(seconds: float) -> str:
    """Say a time (s)."""
    return f"{round(seconds, 3):.10g} s"


def started(args: Sequence[str]) -> str:
    """Begin a sentence about a run with this command line."""
    return f"Started with `{' '.join(args)}`, the" if args else "The"


def say_error(error: Error) -> str:
    """Say what an exception has ended, and where, as the rest of a sentence."""
    where = f"in line {error.line}:" if error.line else "with"
    said = plain(error.said)  # may end in a question
    return f"{error.whose} stopped {where} `{said}`{'' if said.endswith('?') else '.'}"


def language_of(answer: Any) -> Language | None:
    """Return the language of an answer, a text; None for Python, and for anything else."""
    return written_in(answer) if isinstance(answer, str) else None


def say_kept(run: ObservedRun, ros: int) -> str:
    """Say what kept a node from ending before it was killed, as the rest of a sentence."""
    if run.kept_by_rate:
        return "one of its threads was still asleep in a Rate's `sleep()`."
    language = next((each for each in LANGUAGES if each.name == run.language), None)
    asks = f"Does its loop ask `{words_of(language, ros).asks}`?"
    return f"it was still in line {run.kept_at.line}, `{plain(run.kept_at.call)}`. {asks}" if run.kept_at else asks


def hint_for_kept(run: ObservedRun) -> str:
    """Return a hint for a node that was killed; empty if nothing more is known."""
    return _DAEMON if run.kept_by_rate else ""


def not_python(error: Exception) -> tuple[str, str]:
    """Return what to say about a text that Python cannot read, and how to continue."""
    read = "Python could not read the answer, so nothing ran. The error may be in the line before."
    if not isinstance(error, SyntaxError):
        return f"This is not Python: {plain(str(error))}.", read
    said = plain(error.msg)  # may end in a question
    return f"Line {error.lineno} is not Python: {said}{'' if said.endswith('?') else '.'}", read
