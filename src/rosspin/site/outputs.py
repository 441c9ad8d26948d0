"""What stands in the pages and follows from a run: ``python -m rosspin.site.outputs`` writes it anew.

That is the expected output of the doctests, the nodes that notebooks copy from ``examples/``, and the README's picture.
The author reads the difference in ``git diff``, and changes the sentences around it.
"""

from __future__ import annotations

import difflib
import doctest
import re
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterable, Iterator
from contextlib import chdir
from pathlib import Path
from types import TracebackType
from typing import Any

from ..plots import timeline
from ..run import simulate
from .claims import Edit, Stale, one_line, report

__all__ = ["differences", "stale_outputs", "write"]

# What the README shows is the plot of this run.
_PICTURE, _PICTURED = "docs/timing.svg", ("examples/my_robotics_pkg/src/spinner_py_node.py", 5.0)

# A notebook's cell with the option `copy-of`, the path of a file; the cell's first line may be a magic.
_COPY = re.compile(
    r"^```\{code-cell\}.*\n(?:(?!:copy-of:):.*\n)*:copy-of: (?P<file>.*)\n(?::.*\n)*\n?"
    r"(?:%%.*\n)?(?P<code>(?:.*\n)*?)```$",
    re.MULTILINE,
)


def stale_outputs(root: Path) -> list[Stale]:
    """All of it in the folder ``root`` that is not as a run now has it. Each has its edits, unless the run failed."""
    with chdir(root):
        pages = ["index.rst", *sorted(path.as_posix() for path in Path("docs").rglob("*.rst"))]
        notebooks = sorted(path.as_posix() for path in Path("notebooks").glob("*.md"))
        found = [stale for page in pages for stale in _doctests(page)]
        found += [stale for notebook in notebooks for stale in _copies(notebook)]
        return found + list(_picture("README.md"))


class _Runner(doctest.DocTestRunner):
    """Keeps what fails, and prints nothing."""

    def __init__(self) -> None:
        super().__init__(verbose=False, optionflags=doctest.DONT_ACCEPT_TRUE_FOR_1)
        self.failed: list[tuple[doctest.Example, str, bool]] = []

    def report_failure(self, out: Any, test: doctest.DocTest, example: doctest.Example, got: str) -> None:
        self.failed.append((example, got, True))

    def report_unexpected_exception(
        self,
        out: Any,
        test: doctest.DocTest,
        example: doctest.Example,
        exc_info: tuple[type[BaseException], BaseException, TracebackType],
    ) -> None:
        # A name that is not there is missing because of the example that failed before.
        if not (self.failed and isinstance(exc_info[1], NameError)):
            self.failed.append((example, one_line(exc_info[1]), False))


def _doctests(page: str) -> Iterator[Stale]:
    text = Path(page).read_text(encoding="utf-8")
    test = doctest.DocTestParser().get_doctest(text, {"__name__": "__main__"}, page, page, 0)
    runner = _Runner()
    runner.run(test, out=lambda text: None)
    for example, got, is_output in runner.failed:
        start = example.lineno + example.source.count("\n")
        margin = " " * example.indent
        lines = (margin + (line.rstrip() or "<BLANKLINE>") for line in got.splitlines())
        edit = Edit(page, start, start + example.want.count("\n"), tuple(lines))
        stands = example.want or example.source.partition("\n")[0] + " (prints nothing)"
        yield Stale(page, start + 1, stands, got or "nothing is printed", edits=(edit,) if is_output else ())


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
    """The opcodes of what is not equal in two texts, as difflib has them."""
    codes = difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
    return [code for code in codes if code[0] != "equal"]


def _picture(readme: str) -> Iterator[Stale]:
    """The picture, and the words that stand for it in the README."""
    node, seconds = _PICTURED
    lines = Path(readme).read_text(encoding="utf-8").splitlines()
    number = next(number for number, line in enumerate(lines) if f"]({_PICTURE})" in line)
    try:
        ticks = simulate(node, seconds).ticks
    except Exception as error:  # whatever the author's node raises: all else is listed, too
        yield Stale(readme, number + 1, lines[number], one_line(error))
        return
    if not ticks:
        yield Stale(readme, number + 1, lines[number], f"the node has no tick in {seconds:g} s")
        return
    plot = timeline(ticks)
    with tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder, "plot.svg")
        plot.save(drawn)
        new = drawn.read_text(encoding="utf-8")
    old = Path(_PICTURE).read_text(encoding="utf-8")
    words = f"![{plot.alt}]({_PICTURE})"
    if (old, lines[number]) != (new, words):
        picture = Edit(_PICTURE, 0, len(old.splitlines()), tuple(new.splitlines()))
        edits = picture, Edit(readme, number, number + 1, (words,))
        yield Stale(readme, number + 1, lines[number], words, edits=edits)


def write(root: Path, edits: Iterable[Edit]) -> None:
    """Make the edits, in the folder ``root``. Those of one file must not overlap."""
    by_file = defaultdict(list)
    for edit in edits:
        by_file[edit.file].append(edit)
    for file, group in by_file.items():
        lines = (root / file).read_text(encoding="utf-8").splitlines()
        for edit in sorted(group, key=lambda edit: edit.start, reverse=True):
            lines[edit.start : edit.end] = edit.lines
        (root / file).write_text("\n".join(lines) + "\n", encoding="utf-8")


def main() -> int:
    """Write them anew in this folder, and name the files. The status is 1 if a run failed, which is listed."""
    root = Path.cwd()
    stale = stale_outputs(root)
    edits = [edit for entry in stale for edit in entry.edits]
    write(root, edits)
    for file in sorted({edit.file for edit in edits}):
        print(f"written: {file}")
    print("Read `git diff`, change the sentences around it, and run `make html`." if edits else "Nothing to write.")
    if failed := [entry for entry in stale if not entry.edits]:
        print(f"\n{report(failed)}", file=sys.stderr)
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
