"""Sphinx extension: a build goes over all pages, and ends with status 1 and a list if something no longer holds.

The list has what the directives, the notebooks and the examples noted, and the missing exercises. A page with notes is
read again by the next build, as what it found may have been due to the machine; after a build that broke off, all are.
The builder ``doctest`` is Sphinx's own; ``outputs`` writes what follows from the runs into the pages.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path

from docutils import nodes
from sphinx.application import ENV_PICKLE_FILENAME, Sphinx
from sphinx.builders.dummy import DummyBuilder
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.util.typing import ExtensionMetadata

from ..exercises import EXERCISES
from .claims import MIME, Stale, report
from .doctests import stale_examples
from .lessons import counted, shown_on, stale_files, stale_lessons
from .notes import note, noted
from .outputs import stale_copies, stale_picture, write

__all__ = ["setup"]


class OutputsBuilder(DummyBuilder):
    """Writes the expected outputs of the examples, the copies of nodes and the README's picture again.

    The author reads the difference in ``git diff``, and changes the sentences around it. The status is 1 if a run
    failed, which is listed.
    """

    name = "outputs"
    epilog = ""

    def get_outdated_docs(self) -> set[str]:
        """Return none: all is done when pages are read, and when the build ends."""
        return set()

    def write_documents(self, docnames: AbstractSet[str]) -> None:
        """Write nothing."""


def setup(app: Sphinx) -> ExtensionMetadata:
    """Add the builder and connect the functions below."""
    app.setup_extension("sphinx.ext.doctest")
    app.add_builder(OutputsBuilder)
    # A digest, from conf.py, of all that the pages run. If it changes, pages are read again, and also written again if
    # another builder has read them.
    app.add_config_value("what_pages_run", "", "env")
    app.add_config_value("what_pages_show", lambda config: config.what_pages_run, "html")
    app.connect("config-inited", _begin)
    app.connect("env-purge-doc", lambda app, env, page: noted(env).pop(page, None))
    app.connect("env-merge-info", _merge)
    app.connect("env-get-outdated", lambda app, env, *changed: [page for page, notes in noted(env).items() if notes])
    app.connect("doctree-read", _read_notebook)
    app.connect("doctree-read", _run_examples)
    app.connect("env-updated", _look_at_picture)
    app.connect("build-finished", _finish)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _begin(app: Sphinx, config: Config) -> None:
    """Read and write all pages again after a build that broke off: it may have written some of them by half."""
    mark = _mark(app)
    if mark.exists():
        Path(app.doctreedir, ENV_PICKLE_FILENAME).unlink(missing_ok=True)
    mark.parent.mkdir(parents=True, exist_ok=True)
    mark.touch()


def _mark(app: Sphinx) -> Path:
    """Return the file that is there while a build is not at its end."""
    return Path(app.doctreedir, "unfinished")


def _merge(app: Sphinx, env: BuildEnvironment, pages: Sequence[str], other: BuildEnvironment) -> None:
    noted(env).update({page: notes for page, notes in noted(other).items() if page in pages})


def _run_examples(app: Sphinx, doctree: nodes.document) -> None:
    for block in doctree.findall(nodes.doctest_block):
        block.source = block.source or doctree["source"]  # docutils leaves it out in a directive
    if stale := stale_examples(app, doctree):
        noted(app.env).setdefault(app.env.docname, set()).update(stale)


def _look_at_picture(app: Sphinx, env: BuildEnvironment) -> None:
    """Check the README's picture if what it depends on has changed, or if it did not hold; keep what was found."""
    shown = [path.read_bytes() for path in (Path(app.srcdir, "README.md"), *Path(app.srcdir, "docs").glob("*.svg"))]
    key = app.config.what_pages_run, shown
    if getattr(env, "rosspin_picture", None) != (key, []):
        env.__dict__["rosspin_picture"] = key, list(stale_picture(Path(app.srcdir)))


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
            # A missing name is due to the cell that failed before.
            if output["output_type"] == "error" and not (failed and output["ename"] == "NameError"):
                line = _line_of(output["traceback"])
                error = f"{output['ename']}: {output['evalue']}"
                note(app.env, start + line - 1, source[line - 1].strip(), error, block)
                failed = True
            # A magic only prints what is wrong with its arguments.
            elif (printed := "".join(output.get("text", []))).startswith("UsageError: "):
                note(app.env, start, source[0], printed, block)


def missing_exercises(root: Path) -> Iterator[Stale]:
    """Yield the exercises that have a check, and are not on their list in ``root``/notebooks."""
    for page in sorted(root.glob("notebooks/*.md")):
        found = shown_on(page.read_text(encoding="utf-8"))
        of_site = [exercise for exercise in EXERCISES if exercise.part]
        on_page = {exercise.ros for exercise in of_site if exercise.name in found}
        for exercise in of_site:
            if exercise.ros in on_page and exercise.name not in found:
                now = f'rosspin.exercises checks exercise {exercise.number}, "{exercise.title}"'
                yield Stale(page.relative_to(root).as_posix(), 1, f"no exercise {exercise.name}", now)


def _line_of(traceback: list[str]) -> int:
    """Return the line of a cell, counted from 1, at which it failed."""
    plain = re.sub(r"\x1b\[[\d;]*m", "", "\n".join(traceback))
    found = re.search(r"Cell In\s*\[\d+\], line (\d+)|^<cell \d+>:(\d+):", plain)  # of Python, of a compiler for C++
    return int(found[1] or found[2]) if found else 1


def _finish(app: Sphinx, error: Exception | None) -> None:
    """Say what no longer holds, or write what can be written."""
    if error is not None:
        return
    _mark(app).unlink()
    # Sphinx warns only when it reads or writes a page, so the next build has to begin again.
    if app._warncount:
        Path(app.doctreedir, ENV_PICKLE_FILENAME).unlink(missing_ok=True)
    root = Path(app.srcdir)
    _, picture = app.env.__dict__["rosspin_picture"]
    stale = [*set().union(*noted(app.env).values()), *stale_copies(root), *picture, *missing_exercises(root)]
    stale += [*stale_lessons(root), *counted(root), *stale_files(root)]
    if app.builder.name == OutputsBuilder.name:
        app.statuscode = _write(root, stale)
    elif stale:
        print(f"\n{report(stale)}\n", flush=True)
        app.statuscode = 1


def _write(root: Path, stale: Sequence[Stale]) -> int:
    """Make the edits, print the names of the files, and return the status."""
    edits = [edit for entry in stale for edit in entry.edits]
    write(root, edits)
    for file in sorted({edit.file for edit in edits}):
        print(f"written: {file}")
    print("Read `git diff`, change the sentences around it, and run `make html`." if edits else "Nothing to write.")
    if failed := [entry for entry in stale if entry.failed]:
        print(f"\n{report(failed)}", flush=True)
    return bool(failed)
