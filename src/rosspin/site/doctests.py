"""Run the examples of a page as ``sphinx.ext.doctest`` does, for the list of what no longer holds."""

from __future__ import annotations

import doctest
import textwrap
from contextlib import chdir
from pathlib import Path
from types import TracebackType
from typing import Any, cast
from unittest.mock import patch

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.ext.doctest import DocTestBuilder, SphinxDocTestRunner, TestCode, TestGroup

from .claims import Edit, Stale, one_line

__all__ = ["stale_examples"]


def stale_examples(app: Sphinx, doctree: nodes.document) -> list[Stale]:
    """Return the examples on the page being read whose runs differ. Each has its edit, unless its run failed."""
    examples = _Examples(app)
    # The builder does this for good when it begins: code blocks have more than one statement.
    with chdir(app.srcdir), patch.object(doctest, "compile", examples.compile, create=True):
        examples.test_doc(app.env.docname, doctree)
    return examples.stale


class _Failures(SphinxDocTestRunner):
    """Keeps what fails, and prints nothing."""

    def __init__(self, optionflags: int) -> None:
        super().__init__(verbose=False, optionflags=optionflags)
        self.failed: list[tuple[doctest.DocTest, doctest.Example, str, bool]] = []

    def report_failure(self, out: Any, test: doctest.DocTest, example: doctest.Example, got: str) -> None:
        self.failed.append((test, example, _without_frames(got, example), True))

    def report_unexpected_exception(
        self,
        out: Any,
        test: doctest.DocTest,
        example: doctest.Example,
        exc_info: tuple[type[BaseException], BaseException, TracebackType],
    ) -> None:
        # A missing name is due to the example that failed before.
        if not (self.failed and isinstance(exc_info[1], NameError)):
            self.failed.append((test, example, one_line(exc_info[1]), False))


class _Examples(DocTestBuilder):
    """Sphinx's own builder, with its groups, options and conditions, used while any builder reads a page."""

    def __init__(self, app: Sphinx) -> None:
        """Skip the builder's own, which would open a file for its results and set the tag ``doctest``."""
        self.config, self.env = app.config, app.env
        self.opt = self.config.doctest_default_flags
        self.total_failures = self.total_tries = self.setup_failures = self.setup_tries = 0
        self.cleanup_failures = self.cleanup_tries = 0
        self.stale: list[Stale] = []

    def _out(self, text: str) -> None:
        """Print nothing: the list says it."""

    _warn_out = _out

    @staticmethod
    def get_line_number(node: nodes.Node) -> int | None:
        """Return the line of the file, counted from 0, at which a block's content begins; None if not in the file."""
        return _first_line(cast(nodes.Element, node))

    def test_group(self, group: TestGroup) -> bool:
        """Run a group, and note what fails."""
        runner = self.setup_runner = self.test_runner = self.cleanup_runner = _Failures(self.opt)
        succeeded = super().test_group(group)
        outputs: dict[tuple[str, int | None], TestCode | None]
        outputs = {(test[0].filename, test[0].lineno): test[1] for test in group.tests if len(test) == 2}
        for test, example, now, is_output in runner.failed:
            page, edit = str(test.filename), None
            if test.name != group.name:  # in the set-up or the clean-up
                start = example.lineno or 0
            elif (page, test.lineno) in outputs:
                output = outputs[page, test.lineno]
                start = (test.lineno if output is None or output.lineno is None else output.lineno) or 0
                if is_output and output is not None and output.lineno is not None:
                    edit = _below_code(page, start, example.want, now)
            else:
                start = (test.lineno or 0) + example.lineno + example.source.count("\n")
                if is_output and test.lineno is not None:
                    edit = _below_prompt(page, start, example, now)
            stands = example.want or example.source.partition("\n")[0] + " (prints nothing)"
            now = now or "nothing is printed"
            edits = (edit,) if edit else ()
            self.stale.append(Stale(page, start + 1, stands, now, edits=edits, failed=not is_output))
        return succeeded


def _first_line(node: nodes.Element) -> int | None:
    """Return where the text of a block begins in its file: at the line of its directive, or below."""
    file = Path(node.source or "")
    if not file.is_file():  # in a docstring
        return None
    block = [line.strip() for line in str(node.get("test", node.astext())).splitlines()]
    lines = [line.strip() for line in file.read_text(encoding="utf-8").splitlines()]
    found = [at for at in range(len(lines)) if block and lines[at : at + len(block)] == block]
    return next((at for at in found if at + 1 >= (node.line or 0)), found[-1] if found else None)


def _below_prompt(page: str, start: int, example: doctest.Example, now: str) -> Edit:
    """Replace an example's output, as ``doctest`` reads it."""
    margin = _margin(Path(page).read_text(encoding="utf-8").splitlines()[start - 1])
    lines = (margin + (line.rstrip() or "<BLANKLINE>") for line in now.splitlines())
    return Edit(page, start, start + example.want.count("\n"), tuple(lines))


def _below_code(page: str, start: int, want: str, now: str) -> Edit | None:
    """Replace the content of ``testoutput``; None if it cannot hold this output."""
    if now.strip("\n") != now.removesuffix("\n") or textwrap.dedent(now) != now or "```" in now:
        return None
    old = textwrap.dedent(want).splitlines()
    margin = _margin(Path(page).read_text(encoding="utf-8").splitlines()[start])[: -len(_margin(old[0])) or None]
    lines = (margin + line.rstrip() if line.strip() else "" for line in now.splitlines())
    return Edit(page, start, start + len(old), tuple(lines))


def _margin(line: str) -> str:
    return line[: len(line) - len(line.lstrip())]


def _without_frames(got: str, example: doctest.Example) -> str:
    """Return what an example printed; an error without its frames, as the page shows errors."""
    frames = [number for number, line in enumerate(got.splitlines()) if line.startswith("  ")]
    if example.exc_msg is None or not got.startswith("Traceback") or not frames:
        return got
    message = "\n".join(got.splitlines()[frames[-1] + 1 :])
    return f"{example.want.removesuffix(example.exc_msg)}{message}\n"
