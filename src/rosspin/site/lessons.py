"""Sphinx extension: a teacher's own exercises on a page, and what was forgotten, for the list at the end of a build."""

from __future__ import annotations

import os
import re
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.docutils import SphinxDirective
from sphinx.util.typing import ExtensionMetadata
from sphinx_design.shared import create_component

from ..exercises import EXERCISES, check
from ..exercises.own import FAULTS, FOLDER, LESSONS, Answer, Lesson
from .claims import Stale
from .exercise_pages import difference
from .notes import note

__all__ = ["counted", "setup", "shown_on", "stale_files", "stale_lessons"]

# So many answers an exercise has at least, for its check to be believed.
_RIGHT, _WRONG = 2, 3

# Where a page shows an exercise: by the directive, or in a cell.
_SHOWN = re.compile(r"^ *(?:\.\. exercise::|%%answer|```\{exercise\}) +(\S+) *$", re.MULTILINE)

_NUMBERS = "no one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen".split()
_NUMBERS += "seventeen eighteen nineteen twenty".split()
_WORDS = "|".join([*(f"twenty-{each}" for each in _NUMBERS[1:10]), *_NUMBERS])
_COUNTED = re.compile(rf"\b({_WORDS}|\d+)\s+exercises?\b")


def shown_on(page: str) -> list[str]:
    """Return the exercises on a page, by its source."""
    return _SHOWN.findall(page)


class ExerciseDirective(SphinxDirective):
    """``.. exercise:: NAME``: an exercise, with its hints; ``:solution:`` adds its first right answer.

    One that is offered in several languages has a tab for each.
    """

    required_arguments = 1
    option_spec: ClassVar = {"solution": directives.flag}

    def run(self) -> list[nodes.Node]:
        """Show the title, the cell that runs in the page, and below it what is folded; nothing of no such exercise."""
        lesson = next((each for each in LESSONS if each.exercise.name == self.arguments[0]), None)
        if lesson is None:
            if not any(fault.file.stem.replace("_", "-") == self.arguments[0] for fault in FAULTS):
                file = f"lessons/{self.arguments[0].replace('-', '_')}.py"
                note(self.env, self.lineno, f".. exercise:: {self.arguments[0]}", f"there is no {file}")
            return []
        number = next(each.number for each in EXERCISES if each.name == lesson.exercise.name)
        title = f"Exercise {number}: {lesson.exercise.title}"
        task = self.parse_text_to_nodes(lesson.text)
        for node in (listing for part in task for listing in part.findall(nodes.literal_block)):
            if node.astext().startswith("%%simulate "):
                node["classes"].append("live")
                node["language"] = "ipython3"
        tabs = [self._tab(each) for each in (lesson, *lesson.others)] if lesson.others else []
        answer = [create_component("tab-set", ["sd-tab-set"], children=tabs)] if tabs else self._answer(lesson)
        shown: list[nodes.Node] = [nodes.rubric(title, title), *task, *answer]
        return [nodes.container("", *shown, classes=["exercise"], ids=[lesson.exercise.name])]

    def _tab(self, lesson: Lesson) -> nodes.Node:
        """Make a tab like those that choose the language elsewhere."""
        label = nodes.rubric("", {"python": "Python", "cpp": "C++"}[lesson.language], classes=["sd-tab-label"])
        label["sync_group"], label["sync_id"] = "lang", lesson.language
        content = create_component("tab-content", ["sd-tab-content"], children=self._answer(lesson))
        return create_component("tab-item", ["sd-tab-item"], children=[label, content], selected=False)

    def _answer(self, lesson: Lesson) -> list[nodes.Node]:
        """Show the cell that runs in the page, and below it what is folded."""
        text = f"%%answer {lesson.exercise.name}\n{lesson.node.rstrip()}"
        classes = ["live", *(["highlight-cpp"] if lesson.language == "cpp" else [])]
        shown: list[nodes.Node] = [nodes.literal_block(text, text, language="ipython3", classes=classes)]
        for number, hint in enumerate(lesson.hints, 1):
            shown += self._folded(f"Hint {number}", self.parse_text_to_nodes(hint))
        if "solution" in self.options and lesson.right:
            shown += self._folded(
                "Show the solution",
                [difference(lesson.node, lesson.written(lesson.right[0])), *self.parse_text_to_nodes(lesson.after)],
            )
        return shown

    @staticmethod
    def _folded(summary: str, inner: list[nodes.Node]) -> list[nodes.Node]:
        start = f"<details><summary>{summary}</summary>"
        return [nodes.raw("", start, format="html"), *inner, nodes.raw("", "</details>", format="html")]


def _changed(app: Sphinx, env: BuildEnvironment, *pages: set[str]) -> list[str]:
    """Name the pages that show an exercise whose file is new, gone, or another one than in the last build."""
    folder = Path(app.srcdir, "lessons")
    now = {file.stem.replace("_", "-"): file.read_bytes() for file in folder.glob("*.py")}
    before = env.__dict__.get("rosspin_lessons", {})
    env.__dict__["rosspin_lessons"] = now
    names = {**before, **now}  # whose numbers are others if there are more or fewer
    changed = {name for name in names if before.keys() != now.keys() or before[name] != now[name]}
    shown = _pages(Path(app.srcdir)) if changed else ()
    found = {app.project.path2doc(page) for page, text in shown if changed.intersection(shown_on(text))}
    return sorted(page for page in found if page in env.found_docs)


def setup(app: Sphinx) -> ExtensionMetadata:
    """Add the directive, and connect the function above."""
    app.add_directive("exercise", ExerciseDirective)
    app.connect("env-get-outdated", _changed)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


# --- what was forgotten -----------------------------------------------------------------------------------------------


def stale_lessons(root: Path) -> Iterator[Stale]:
    """Yield what a teacher's exercises lack: what their files say is run, and looked for on the pages."""
    shown = {name for _, text in _pages(root) for name in shown_on(text)}
    for fault in FAULTS:
        yield Stale(os.path.relpath(fault.file, root), fault.line, fault.stands, fault.now)
    for lesson in (each for each in LESSONS if each.file.parent == FOLDER):  # the site's own have tests
        file, text = os.path.relpath(lesson.file, root), lesson.file.read_text(encoding="utf-8")
        if lesson.exercise.name not in shown:
            yield Stale(file, 1, "no page shows it", f"write .. exercise:: {lesson.exercise.name} on one")
        if _line(text, "RIGHT") < _line(text, r"(def )?check"):
            now = "it comes after check: the page gets only what is above"
            yield Stale(file, _line(text, "RIGHT"), "RIGHT", now)
        for what, stands, now in (*_too_few(lesson), *_misjudged(lesson, text)):
            yield Stale(file, what if isinstance(what, int) else _line(text, what), stands, now)


def _too_few(lesson: Lesson) -> Iterator[tuple[str, str, str]]:
    for what, answers, least in (("RIGHT", lesson.right, _RIGHT), ("WRONG", lesson.wrong, _WRONG)):
        if len(answers) < least:
            yield what, f"{what} has {len(answers)} answer{'s' * (len(answers) != 1)}", f"give at least {least}"


def _misjudged(lesson: Lesson, text: str) -> Iterator[tuple[str | int, str, str]]:
    """Yield the answers on which the check does not say what it should: in which list, or line, which one, and what.

    A node that is no Python, and a check that fails, are told once, without all that follows from them.
    """
    try:
        compile(lesson.node, "NODE", "exec")
    except SyntaxError as error:
        at = lesson.node.splitlines()[(error.lineno or 1) - 1]
        yield next(number for number, line in enumerate(text.splitlines(), 1) if line == at), at, "NODE is not Python"
        return
    wanted: list[tuple[str, str, Answer, bool, str]] = [("NODE", "NODE", lesson.node, False, "")]
    wanted += [("RIGHT", f"RIGHT[{number}]", right, True, "") for number, right in enumerate(lesson.right)]
    wanted += [("WRONG", f"WRONG[{n}]: {part}", wrong, False, part) for n, (wrong, part, *_) in enumerate(lesson.wrong)]
    failed = set()
    for what, stands, answer, right, part in wanted:
        try:
            written = lesson.written(answer)
        except ValueError as error:
            yield what, stands, str(error)
            continue
        try:
            feedback = check(lesson.exercise.name, written)
        except Exception as error:
            line = _line_of(error, lesson.file) or _line(text, "(def )?check")
            if line not in failed:
                yield line, "check", f"{type(error).__name__}: {error}"
            failed.add(line)
            continue
        said = str(feedback)
        if what == "NODE" and feedback.passed:
            yield what, stands, "it is right as it is: there is nothing to do"
        elif feedback.passed is not right or part.replace("`", "") not in said.replace("`", ""):
            yield what, stands, said


def _line_of(error: Exception, file: Path) -> int:
    """Return the line of the file in which an error was raised, the innermost; 0 if it was nowhere in it."""
    frames = traceback.walk_tb(error.__traceback__)
    return ([line for frame, line in frames if frame.f_code.co_filename == str(file)] or [0])[-1]


def _line(text: str, name: str) -> int:
    """Return the line of a file that begins with a name."""
    found = re.search(rf"^{name}\b", text, re.MULTILINE)
    return text.count("\n", 0, found.start()) + 1 if found else 1


def counted(root: Path) -> Iterator[Stale]:
    """Yield the sentences that count the exercises on their page, and miscount."""
    for page, text in _pages(root):
        there = len(dict.fromkeys(shown_on(text)))
        found = _COUNTED.search(text)
        if there and found and there != _number(found[1]):
            line = text.count("\n", 0, found.start()) + 1
            shown = _NUMBERS[there] if there < len(_NUMBERS) else there
            yield Stale(page, line, " ".join(found[0].split()), f"the page has {shown}")


def _number(word: str) -> int:
    if word.isdecimal():
        return int(word)
    return _NUMBERS.index(word) if word in _NUMBERS else 20 + _NUMBERS.index(word.removeprefix("twenty-"))


def stale_files(root: Path) -> Iterator[Stale]:
    """Yield the scripts in ``examples`` that cannot be run as programs: ROS starts nodes so."""
    for path in sorted(root.glob("examples/**/*")):
        if path.is_file() and not os.access(path, os.X_OK):
            with open(path, "rb") as file:
                if file.read(2) == b"#!":
                    name = path.relative_to(root).as_posix()
                    yield Stale(name, 1, "it begins with #! and has no run bit", f"chmod +x {name}")


def _pages(root: Path) -> Iterator[tuple[str, str]]:
    for path in sorted([*root.glob("*.rst"), *root.glob("docs/**/*.rst"), *root.glob("notebooks/*.md")]):
        yield path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
