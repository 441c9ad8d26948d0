"""Sphinx extension: the C++ nodes that pages run are compiled together, while other pages are read.

So is packed what a page needs to compile them itself.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from multiprocessing import get_context
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.typing import ExtensionMetadata

from ..cpp import build_together
from ..exercises.own import LESSONS
from ..run.kinds import language_of, written_in
from .lessons import shown_on
from .packing import pack
from .vehicle import NODES

__all__ = ["setup"]

_FILE = re.compile(
    r"""(?:["']|^(?:   \w+|\.\. ticks:): )(?:\.\./)*(examples/[\w./-]+\.(?:cpp|launch))(?![\w.-])""", re.MULTILINE
)
_LIVE = re.compile(
    r"^[ ]*\.\. literalinclude:: (?:\.\./)*(examples/[\w./-]+\.cpp)\n(?:[ ]+:.*\n)*?[ ]+:class:.*\blive\b", re.MULTILINE
)
_CELL = re.compile(r"^```\{code-cell\}.*\n(?::.*\n)*\n?%%simulate .*\n((?:.*\n)*?)```$", re.MULTILINE)


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the function below."""
    app.connect("env-before-read-docs", _begin)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _begin(app: Sphinx, env: BuildEnvironment, pages: list[str]) -> None:
    """Begin to compile, and read the pages that have to wait for that last, the notebooks first: they take longest."""
    texts = {page: Path(env.doc2path(page)).read_text(encoding="utf-8") for page in pages}
    found = {page: [*_nodes(text, app.srcdir)] for page, text in texts.items()}
    pages.sort(key=lambda page: (found[page] != [], found[page] != [] and not page.startswith("notebooks/")))
    if nodes := [node for page in pages for node in found[page]]:
        # A process of its own, as runs change what this one has.
        process = get_context("spawn").Process(target=build_together, args=(nodes,), daemon=True)
        process.start()
        app.connect("build-finished", lambda app, error: process.join())
    if app.builder.format == "html" and any(map(_LIVE.search, texts.values())):
        get_context("spawn").Process(target=pack, args=(app.confdir,), daemon=True).start()


def _nodes(page: str, root: Path) -> Iterator[tuple[str, str | None]]:
    """Yield what a page runs: files by their paths, and cells by their texts, as the magic gives them.

    A launch file is no node, but may start one.
    """
    shown = [file for file, _ in NODES.values() if ".. vehicle::" in page and language_of(file)]
    for file in dict.fromkeys([*_FILE.findall(page), *_LIVE.findall(page), *shown]):
        yield str(root / file), None
    for name in shown_on(page):
        for lesson in (other for each in LESSONS if each.exercise.name == name for other in (each, *each.others)):
            if lesson.language == "cpp":
                yield "answer.cpp", f"\n{lesson.node.rstrip()}"
    for text in _CELL.findall(page):
        if written_in(text):
            yield str(root / "notebooks" / "cell"), f"\n{text}"
