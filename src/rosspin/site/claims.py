"""Hold what a page says about a run against the run: facts, their sentences, and the list of what is stale."""

from __future__ import annotations

import ast
import re
import textwrap
import traceback
import types
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

__all__ = ["MIME", "Edit", "Facts", "Stale", "one_line", "report", "sentence_near"]

# A notebook's cell hands its findings to the build as this: a list of (line, the text there, what the run says now).
MIME = "application/vnd.rosspin.stale+json"

_WIDTH = 200  # characters of a value or a sentence: no one would read more


@dataclass(frozen=True)
class Edit:
    """The lines of a file from ``start`` up to but not including ``end``, counted from 0, and their replacement."""

    file: str
    start: int
    end: int
    lines: tuple[str, ...]


@dataclass(frozen=True)
class Stale:
    """Something that no longer holds: where it is, the text there, and what the run says now.

    ``text`` is the sentence that a fact is about; ``edits`` are what ``make outputs`` would do about it. ``failed``
    says that it cannot, as the run ended in an error.
    """

    page: str
    line: int
    stands: str
    now: str
    text: str = ""
    edits: tuple[Edit, ...] = ()
    failed: bool = False


class Facts:
    """Statements about runs, with the names that they share.

    After one that fails the others are still run, so that all that no longer holds is found in one go. A failure is
    passed over if it only follows from an earlier one, which left a name unset.
    """

    def __init__(self, names: dict[str, object] | None = None) -> None:
        self._names: dict[str, object] = {} if names is None else names
        self._unset: set[str] = set()

    def run(self, code: str, file: str) -> Iterator[tuple[int, str, str]]:
        """Yield each statement of ``code`` that fails: its line, its text, and what the run says now."""
        for statement in ast.parse(code, file).body:
            try:
                exec(compile(ast.Module([statement], []), file, "exec", dont_inherit=True), self._names)
            except Exception as error:
                if not self._unset & _names(statement, ast.Load):
                    frame, line = _innermost(error, file)
                    failed = _smallest_statement(statement, line)
                    yield line, _first_line(failed), _says_now(error, failed, frame)
                self._unset |= _names(statement, ast.Store)

    def value(self, expression: str) -> tuple[str, str | None]:
        """Return an expression, with a format as in an f-string, as text; and why it has no value, if worth telling."""
        field = f'f"""{{{expression}}}"""'
        try:
            return str(eval(field, self._names)), None
        except Exception as error:
            try:
                follows = bool(self._unset & _names(ast.parse(field, mode="eval"), ast.Load))
            except SyntaxError:
                follows = False
            return "?", None if follows else one_line(error)


def _names(tree: ast.AST, use: type[ast.expr_context]) -> set[str]:
    return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, use)}


def _innermost(error: Exception, file: str) -> tuple[types.FrameType, int]:
    """Return the innermost frame of an error in ``file``, and its line there."""
    *_, found = ((f, n) for f, n in traceback.walk_tb(error.__traceback__) if f.f_code.co_filename == file)
    return found


def _smallest_statement(tree: ast.stmt, line: int) -> ast.stmt:
    holding = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.stmt) and node.lineno <= line <= (node.end_lineno or node.lineno)
    ]
    return holding[-1] if holding else tree  # ast.walk goes from the outside in


def _first_line(statement: ast.stmt) -> str:
    return ast.unparse(statement).partition("\n")[0]


def _says_now(error: Exception, failed: ast.stmt, frame: types.FrameType) -> str:
    if not isinstance(error, AssertionError) or not isinstance(failed, ast.Assert):
        return one_line(error)
    values = list(dict.fromkeys(_sides(failed.test, frame))) or list(dict.fromkeys(_used(failed.test, frame)))
    return "\n".join(values) or str(error) or "false"


def _sides(test: ast.expr, frame: types.FrameType) -> Iterator[str]:
    """Yield the sides of the comparisons in a test that is false, with their values."""
    if isinstance(test, ast.BoolOp):
        for part in test.values:
            if not _evaluated(part, frame):
                yield from _sides(part, frame)
    elif isinstance(test, ast.Compare):
        for side in [test.left, *test.comparators]:
            if any(isinstance(node, ast.Name) for node in ast.walk(side)):
                yield _is_now(side, frame)


def _used(test: ast.expr, frame: types.FrameType) -> Iterator[str]:
    """Yield the names in a test that stand for data, with their values."""
    known = {**frame.f_globals, **frame.f_locals}
    for node in ast.walk(test):
        if isinstance(node, ast.Name) and node.id in known and not callable(known[node.id]):
            yield _is_now(node, frame)


def _evaluated(expression: ast.expr, frame: types.FrameType) -> object:
    code = compile(ast.Expression(expression), "<fact>", "eval")
    return eval(code, {**frame.f_globals, **frame.f_locals})  # one dictionary: a comprehension sees only the globals


def _is_now(expression: ast.expr, frame: types.FrameType) -> str:
    value = repr(_evaluated(expression, frame))
    return f"{ast.unparse(expression)} is {value if len(value) <= _WIDTH else value[: _WIDTH - 1] + '…'}"


def one_line(error: BaseException) -> str:
    """Return the last line of an error's traceback."""
    return " ".join("".join(traceback.format_exception_only(error)).split())


def sentence_near(page: str, start: int, end: int) -> str:
    """Return the paragraph that the lines ``start`` to ``end`` of a page, counted from 1, are about.

    It is the one below them, or the one above them if a heading or code comes first below.
    """
    lines = page.splitlines()
    below = next(_paragraphs(lines[end:]), "")
    above = _paragraphs(lines[: start - 1])
    return below or next((text for text in reversed(list(above)) if text), "")


def _paragraphs(lines: list[str]) -> Iterator[str]:
    """Yield each block of a page as one line; "" for one that is not prose."""
    fenced = False
    for block in re.split(r"\n\s*\n", "\n".join(lines)):
        was_fenced = fenced
        fenced ^= block.count("```") % 2 == 1
        prose = not was_fenced and not re.match(r"\s*(```|\.\. |#|\||:\w+:)|\s*.+\n[=*~^-]{3,}\s*$|\s{2,}", block)
        if block.strip():
            yield textwrap.shorten(block, _WIDTH, placeholder=" …") if prose else ""


def report(entries: Iterable[Stale]) -> str:
    """Write the list for the author, by page and line."""
    stale = sorted(entries, key=lambda entry: (entry.page, entry.line))
    parts = ["What follows no longer holds:"]
    for entry in stale:
        rows = {"text": entry.text, "was": entry.stands, "now": entry.now}
        marked = " (make outputs)" if entry.edits else ""
        parts.append(f"{entry.page}:{entry.line}{marked}\n" + "".join(_row(*row) for row in rows.items() if row[1]))
    followed = sum(bool(entry.edits) for entry in stale)
    end = f"Places: {len(stale)}, pages: {len({entry.page for entry in stale})}."
    if followed:
        end += f" `make outputs` rewrites {followed} of the places."
    parts.append(f"{end} docs/how-to/adapt-a-page.rst says how to continue.")
    return "\n\n".join(part.rstrip("\n") for part in parts)


def _row(name: str, text: str) -> str:
    return textwrap.indent(text.strip("\n"), " " * 10).replace(" " * 10, f"  {name:<8}", 1) + "\n"
