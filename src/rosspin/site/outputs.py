"""Find and rewrite what follows from runs, besides the outputs of the pages' examples.

These are the copies of ``examples/`` in notebooks, and the README's picture.
"""

from __future__ import annotations

import difflib
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from contextlib import chdir
from pathlib import Path

from ..results.saving import save_whole
from .claims import Edit, Stale, one_line
from .vehicle import drawing

__all__ = ["differences", "stale_copies", "stale_picture", "write"]

_PICTURE = "docs/vehicle.svg"  # in the README

# A notebook's cell with the option `copy-of`, the path of the copied file. The cell's first line may be a magic.
_COPY = re.compile(
    r"^```\{code-cell\}.*\n(?:(?!:copy-of:):.*\n)*:copy-of: (?P<file>.*)\n(?::.*\n)*\n?"
    r"(?:%%.*\n)?(?P<code>(?:.*\n)*?)```$",
    re.MULTILINE,
)


def stale_copies(root: Path) -> list[Stale]:
    """Return the places in ``root``/notebooks where the copy of a node differs from the node."""
    with chdir(root):
        return [stale for notebook in sorted(Path("notebooks").glob("*.md")) for stale in _copies(notebook.as_posix())]


def stale_picture(root: Path) -> list[Stale]:
    """Return the README's picture, if it does not show its run any more."""
    with chdir(root):
        return list(_picture("README.md"))


def _copies(notebook: str) -> Iterator[Stale]:
    text = Path(notebook).read_text(encoding="utf-8")
    for cell in _COPY.finditer(text):
        file = Path(notebook).parent / cell["file"]
        there, here = file.read_text(encoding="utf-8").splitlines(), cell["code"].splitlines()
        start = text.count("\n", 0, cell.start("code"))
        for _, i1, i2, j1, j2 in differences(here, there):
            edit = Edit(notebook, start + i1, start + i2, tuple(there[j1:j2]))
            stands = "\n".join(here[i1:i2]) or "a line is missing"
            yield Stale(notebook, start + i1 + 1, stands, "\n".join(there[j1:j2]) or "no such line", edits=(edit,))


def differences(old: list[str], new: list[str]) -> list[tuple[str, int, int, int, int]]:
    """Return difflib's opcodes for what differs between two texts."""
    codes = difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
    return [code for code in codes if code[0] != "equal"]


def _picture(readme: str) -> Iterator[Stale]:
    """Compare the picture, and its text alternative in the README, with the run."""
    lines = Path(readme).read_text(encoding="utf-8").splitlines()
    number = next(number for number, line in enumerate(lines) if f"]({_PICTURE})" in line)
    try:
        new, alternative = drawing(Path())
    except Exception as error:  # whatever the author's node raises, all else is listed, too
        yield Stale(readme, number + 1, lines[number], one_line(error), failed=True)
        return
    old = Path(_PICTURE).read_text(encoding="utf-8").splitlines()
    words = f"![{alternative}]({_PICTURE})"
    if (old, lines[number]) != (new.splitlines(), words):
        drawn = Edit(_PICTURE, 0, len(old), tuple(new.splitlines()))
        edits = drawn, Edit(readme, number, number + 1, (words,))
        yield Stale(readme, number + 1, lines[number], words, edits=edits)


def write(root: Path, edits: Iterable[Edit]) -> None:
    """Make the edits in the folder ``root``. Two groups of examples may have the same edit: it is made once."""
    by_file: dict[str, dict[int, Edit]] = defaultdict(dict)
    for edit in edits:
        by_file[edit.file][edit.start] = edit
    for file, group in by_file.items():
        lines = (root / file).read_text(encoding="utf-8").splitlines()
        for _, edit in sorted(group.items(), reverse=True):
            lines[edit.start : edit.end] = edit.lines
        save_whole(root / file, ("\n".join(lines) + "\n").encode())
