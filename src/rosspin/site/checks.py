"""Sphinx extension: a build goes over all pages, and ends with a list of what no longer holds and with status 1.

The list has what the directives and the notebooks noted, the exercises that are missing, and the outputs. The builder
``doctest`` writes no page.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.builders.dummy import DummyBuilder
from sphinx.environment import BuildEnvironment
from sphinx.util.typing import ExtensionMetadata

from ..exercises import EXERCISES
from .claims import MIME, Stale, report, sentence_near
from .outputs import stale_outputs

__all__ = ["note", "setup"]

_stale: set[Stale] = set()


def note(env: BuildEnvironment, line: int, stands: str, now: str, block: tuple[int, int] | None = None) -> None:
    """Add something on the page being read to the list; ``block``: the lines whose sentence it is about."""
    path = Path(env.doc2path(env.docname))
    text = sentence_near(path.read_text(encoding="utf-8"), *block) if block else ""
    _stale.add(Stale(path.relative_to(env.srcdir).as_posix(), line, stands, now, text))


class DoctestBuilder(DummyBuilder):
    """In place of Sphinx's own, which prints frames and leaves facts out."""

    name = "doctest"
    epilog = "Every output on the pages is what its run prints, and every fact holds."

    def get_outdated_docs(self) -> set[str]:
        """None: what there is to do is done when pages are read and when the build ends."""
        return set()

    def write_documents(self, docnames: AbstractSet[str]) -> None:
        """Nothing."""


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the above."""
    app.setup_extension("sphinx.ext.doctest")
    app.add_builder(DoctestBuilder, override=True)
    app.connect("builder-inited", lambda app: _stale.clear())
    app.connect("doctree-read", _read_notebook)
    app.connect("build-finished", _list)
    return {"parallel_read_safe": False, "parallel_write_safe": True}


def _read_notebook(app: Sphinx, doctree: nodes.document) -> None:
    """Note which cells failed or found a fact that does not hold, in the notebook that myst-nb has just executed."""
    executed = Path(app.outdir).parent / "jupyter_execute" / f"{app.env.docname}.ipynb"
    page = Path(app.env.doc2path(app.env.docname))
    if page.suffix != ".md" or not executed.is_file():
        return
    lines = page.read_text(encoding="utf-8").splitlines()
    notebook = json.loads(executed.read_text(encoding="utf-8"))
    cells = zip(notebook["cells"], notebook["metadata"]["source_map"], strict=True)
    failed = False
    for cell, fence in cells:
        source = "".join(cell["source"]).splitlines()
        if cell["cell_type"] != "code" or not source:
            continue
        start = lines.index(source[0], fence) + 1
        block = fence, start + len(source)
        for output in cell["outputs"]:
            for line, stands, now in json.loads(output.get("data", {}).get(MIME, "[]")):
                note(app.env, start + line - 1, stands, now, block)
            # A name that is not there is missing because of the cell that failed before.
            if output["output_type"] == "error" and not (failed and output["ename"] == "NameError"):
                line = _line_of(output["traceback"])
                error = f"{output['ename']}: {output['evalue']}"
                note(app.env, start + line - 1, source[line - 1].strip(), error, block)
                failed = True
            # A folded answer is a solution.
            elif "hide-cell" in cell["metadata"].get("tags", []) and (said := _not_yet(output)):
                note(app.env, start, source[0], said)
            # What a magic says of its own arguments is only printed.
            elif (printed := "".join(output.get("text", []))).startswith("UsageError: "):
                note(app.env, start, source[0], printed, block)


def _not_yet(output: dict[str, Any]) -> str:
    """What is said of an answer that is not right; "" of one that is, and of what is no answer."""
    said = "".join(output.get("data", {}).get("text/plain", []))
    return said if re.match(r"Exercise \d+: not yet\.", said) else ""


def missing_exercises(root: Path) -> Iterator[Stale]:
    """The exercises that have a check but no answer on their page, of the pages in ``root``/notebooks."""
    for page in sorted(root.glob("notebooks/*.md")):
        found = re.findall(r"^%%answer (\d+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
        on_page = {exercise.ros for exercise in EXERCISES if str(exercise.number) in found}
        for exercise in EXERCISES:
            if exercise.ros in on_page and str(exercise.number) not in found:
                now = f'rosspin.exercises checks exercise {exercise.number}, "{exercise.title}"'
                yield Stale(page.relative_to(root).as_posix(), 1, f"no cell with %%answer {exercise.number}", now)


def _line_of(traceback: list[str]) -> int:
    """The line of a cell, counted from 1, at which it failed."""
    plain = re.sub(r"\x1b\[[\d;]*m", "", "\n".join(traceback))
    found = re.search(r"Cell In\s*\[\d+\], line (\d+)", plain)
    return int(found[1]) if found else 1


def _list(app: Sphinx, error: Exception | None) -> None:
    if error is None:
        stale = _stale | {*missing_exercises(Path(app.srcdir)), *stale_outputs(Path(app.srcdir))}
        if stale:
            print(f"\n{report(stale)}\n", flush=True)
            app.statuscode = 1
