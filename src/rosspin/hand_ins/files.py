"""Read what a student hands in: the file that the site saves, a node file, or a notebook. Nothing of it is run."""

from __future__ import annotations

import codecs
import json
import re
import unicodedata
from collections.abc import Iterator
from datetime import datetime
from typing import Any, NamedTuple

from ..exercises import EXERCISES
from . import MOST_FILE, MOST_NAME

__all__ = ["MOST_PLAIN", "NUMBERED", "SUFFIXES", "HandIn", "Refused", "plain", "read"]

MOST_PLAIN = 1000
"""So many characters of a name are looked at."""

_MOST_ANSWERS = 100

SUFFIXES = (".json", ".py", ".cpp", ".ipynb", ".md")
"""The files that can hold answers."""

NUMBERED = (
    *("first-ticks", "after-a-slow-callback", "cpp-ticks", "ten-hertz", "fire-once", "stop-after-five"),
    *("loop-to-timer", "frequency-parameter", "two-rates", "survive-an-overrun", "share-data", "stop-the-motor"),
    *("missing-ticks", "name-the-fault", "what-is-heard", "publish-the-counter", "late-subscriber"),
    *("newest-position", "rostopic-hz", "slow-timer", "call-back-once", "period-parameter", "move-to-ros-2"),
    *("starving-neighbour", "wake-a-rate", "end-without-a-traceback", "ask-without-hanging"),
    *("let-a-callback-wait", "slow-service", "cancel-a-goal"),
)
"""The exercises that had numbers before they had names, from 1 on. This list never changes."""

# The name of an exercise, or in files of version 1 its old number.
_NAME = {1: re.compile(r"[1-9][0-9]{0,2}"), 2: re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")}

_FIRST_LINE = re.compile(r"%%answer[ \t]+(\S+)[^\n]*(\n|$)")

# Where cells of a notebook in Markdown begin and end, each with its options.
_FENCE = re.compile(r"^```(?:(\{code-cell\}).*|[ \t]*)$", re.MULTILINE)
_OPTIONS = re.compile(r"(---\n.*?^---\n|(?::[^\n]*\n)*)\n*", re.MULTILINE | re.DOTALL)

_NOT_JSON = "it is not a file that Save answers made (it is not JSON)"
_NO_CELL = "it has no cell that begins with %%answer and the name of an exercise"


class Refused(ValueError):
    """A file is not read; the message says why."""


class HandIn(NamedTuple):
    """What a file holds: ``answers`` are texts by the names of their exercises.

    A file of the site also has the student's ``name``, maybe a ``student`` ID, the ``id`` of a browser, and the time
    when it was saved.
    """

    answers: dict[str, str]
    name: str = ""
    student: str = ""
    id: str = ""
    date: datetime | None = None


def read(name: str, data: bytes) -> HandIn:
    """Read a file with this name. Raises :class:`Refused`."""
    if len(data) > MOST_FILE:
        raise Refused(f"it has more than {MOST_FILE / 1e6:g} MB, which is the limit")
    if name.endswith(".json"):
        return _read_saved(data)
    if name.endswith(".ipynb"):
        return HandIn(_in_cells(_cells_of_notebook(data)))
    if name.endswith(".md"):
        return HandIn(_in_cells(_cells_of_markdown(_text(data))))
    if name.endswith((".py", ".cpp")):
        return _read_node(name, _text(data))
    raise Refused("it is no file of answers: those end in .json, .py, .cpp, .ipynb or .md")


def plain(name: str) -> str:
    """Return a name in one line, without characters that are not seen or that turn the direction of a text."""
    # What is normalised is short: for marks without end, that takes the square of their number.
    line = re.sub(r"\s+", " ", unicodedata.normalize("NFC", name[:MOST_PLAIN]))
    return "".join(each for each in line if unicodedata.category(each)[0] != "C").strip()[:MOST_NAME]


def _text(data: bytes) -> str:
    """Return a file as a text: in UTF-8, or as an editor on Windows may have saved it."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", "replace")


def _whole(text: str) -> str:
    """Return a text in which no half of a character is alone, as JSON may have it."""
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "replace")


# --- the file of the site ---------------------------------------------------------------------------------------------


def _read_saved(data: bytes) -> HandIn:
    found = _json(data, _NOT_JSON)
    if not isinstance(found, dict) or found.get("format") != "rosspin-answers":
        raise Refused("it is not a file of answers to these exercises")
    version = found.get("version")
    if type(version) is not int or version not in _NAME:
        raise Refused("another version of this site wrote it")
    name, browser, answers = found.get("name"), found.get("id"), found.get("answers")
    if not isinstance(name, str) or not isinstance(browser, str) or not isinstance(answers, dict):
        raise Refused("its name or its answers are missing")
    if len(answers) > _MOST_ANSWERS:
        raise Refused(f"it has {len(answers)} answers, and at most {_MOST_ANSWERS} are read")
    is_name = _NAME[version].fullmatch
    if not all(len(key) <= MOST_NAME and is_name(key) and isinstance(answers[key], str) for key in answers):
        raise Refused("one of its answers is not a text with the name of an exercise")
    known = {_named(key): _whole(text) for key, text in answers.items()}
    student = found.get("student")
    return HandIn(
        known,
        plain(_whole(name)) or "(no name)",
        plain(_whole(student)) if isinstance(student, str) else "",
        _whole(browser),
        _date(found.get("date")),
    )


def _json(data: bytes, why: str) -> Any:
    try:
        return json.loads(data.decode("utf-8-sig", "replace"))
    except (ValueError, RecursionError):
        raise Refused(why) from None


def _named(key: str) -> str:
    """Return the name of an exercise that is known by that, or by its old number."""
    return NUMBERED[int(key) - 1] if key.isascii() and key.isdecimal() and 0 < int(key) <= len(NUMBERED) else key


def _date(text: Any) -> datetime | None:
    try:
        return datetime.fromisoformat(text).astimezone()
    except (TypeError, ValueError, OverflowError, OSError):
        return None


# --- other files ------------------------------------------------------------------------------------------------------


def _read_node(name: str, text: str) -> HandIn:
    """Read a node file. Its first line names the exercise, or else its own name does."""
    if match := _FIRST_LINE.match(text):
        return HandIn({_named(match[1]): text})
    stem = name.rpartition("/")[2].removesuffix(".py").removesuffix(".cpp").replace("_", "-")
    known = {exercise.name for exercise in EXERCISES}
    # A platform, or a browser, may have numbered what came again.
    for found in (stem, re.sub(r"( \(\d+\)|-\d+)$", "", stem)):
        if found in known:
            return HandIn({found: text})
    raise Refused("neither its name nor its first line names an exercise, as slow-timer.py does")


def _cells_of_notebook(data: bytes) -> Iterator[str]:
    found = _json(data, "it is not a notebook (it is not JSON)")
    cells = found.get("cells") if isinstance(found, dict) else None
    for cell in cells if isinstance(cells, list) else ():
        if not isinstance(cell, dict):
            continue
        source, metadata = cell.get("source"), cell.get("metadata")
        if isinstance(source, list):
            source = "".join(line for line in source if isinstance(line, str))
        tags = metadata.get("tags") if isinstance(metadata, dict) else None
        if isinstance(source, str) and not (isinstance(tags, list) and "hide-cell" in tags):
            yield _whole(source)


def _cells_of_markdown(text: str) -> Iterator[str]:
    text, begin = text.replace("\r\n", "\n"), None
    for fence in _FENCE.finditer(text):
        if fence[1]:
            begin = fence.end() + 1 if begin is None else begin
        elif begin is not None:
            cell, begin = text[begin : fence.start()], None
            options = _OPTIONS.match(cell)
            if options and "hide-cell" not in options[0]:
                yield cell[options.end() :]


def _in_cells(cells: Iterator[str]) -> dict[str, str]:
    """Find the answers in the cells of a notebook: the first to each exercise. Folded ones are solutions."""
    answers: dict[str, str] = {}
    for cell in cells:
        if match := _FIRST_LINE.match(cell):
            answers.setdefault(_named(match[1]), cell)
    if not answers:
        raise Refused(_NO_CELL)
    return dict(list(answers.items())[:_MOST_ANSWERS])
