"""Sphinx extension: how many minutes a page takes, by one rule, from what there is on it to read, to run and to type.

The role ``minutes`` gives them for one or several pages, ``:minutes:`/notebooks/timer /notebooks/rate```, rounded to
five; with the word ``building`` at its end also those for the commands on them. JupyterLab shows a notebook without
Sphinx, so a notebook has its number as text. The build lists one that is not the rule's; ``make outputs`` writes it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple, cast

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.docutils import SphinxRole
from sphinx.util.typing import ExtensionMetadata

from .claims import Edit, Stale
from .live import SECONDS
from .notes import note, noted

__all__ = ["Seconds", "rounded", "seconds", "setup"]

# What is read in a minute: words, as of a text from which one learns, and lines of code or of output.
WORDS = 150
LINES = 30

# Seconds for a figure, and more for one that can be moved or gone through; for a run, besides its own in real time, to
# look at it and to change something; for a command, to type it and to wait; for an exercise, some take half as long.
FIGURE = 60
HANDLE = 60
RUN = 120
COMMAND = 60
EXERCISE = 600

_COMMANDS = {"bash", "console"}
_TIME = re.compile(r"\*\*Time\*\*: (\d+) minutes")


class Seconds(NamedTuple):
    """How long a page takes (s): without its commands, and these."""

    reading: float
    commands: float


class _Minutes(nodes.Element):
    """Stands for a number until all pages are read."""


def seconds(page: nodes.Element) -> Seconds:
    """Return how long a page takes, by the rule. Of tabs, the longest counts."""
    reading = commands = 0.0
    for child in page.children:
        one = _of(child) if isinstance(child, nodes.Element) else Seconds(len(child.astext().split()) * 60 / WORDS, 0)
        reading, commands = reading + one.reading, commands + one.commands
    return Seconds(reading, commands)


def _of(node: nodes.Element) -> Seconds:
    classes = node.get("classes", ())
    if "sd-tab-set" in classes:
        return max(map(seconds, cast("list[nodes.Element]", node.children)), key=sum)
    if {"tag_hide-input", "tag_hide-cell"} & {*classes}:  # folded: what it gives is there, its code is not
        return Seconds(sum(map(_figures, node.findall(nodes.raw))), 0)
    if isinstance(node, nodes.raw):
        return Seconds(_figures(node), 0)
    if isinstance(node, nodes.literal_block | nodes.doctest_block):
        return _code(node)
    if "cell_output" in classes:  # its words may be other ones with each build
        return Seconds(sum(map(_figures, node.findall(nodes.raw))), 0)
    return Seconds(0, 0) if isinstance(node, nodes.comment | nodes.system_message) else seconds(node)


def _figures(raw: nodes.raw) -> float:
    text = raw.astext()
    movable = len(re.findall(r" data-(?:positions|scenes|vehicle)='", text))
    return FIGURE * text.count("<figure") + HANDLE * movable


def _code(block: nodes.Element) -> Seconds:
    text = block.astext()
    lines = sum(bool(line.strip()) for line in text.splitlines())
    if block.get("language") in _COMMANDS:
        typed = sum(not line.startswith((" ", "#")) for line in text.splitlines() if line.strip())
        return Seconds(lines * 60 / LINES, typed * COMMAND)
    reading = lines * 60 / LINES
    if "live" in block.get("classes", ()) and text.startswith("%%answer "):
        reading += EXERCISE
    elif "live" in block.get("classes", ()):
        found = re.match(r"%%simulate ([\d.]+)", text)
        reading += RUN + (float(found[1]) if found else SECONDS)
    return Seconds(reading, 0)


def rounded(pages: Sequence[Seconds], building: bool = False) -> int:
    """Return the minutes of some pages together, as a multiple of five."""
    total = sum(page.reading + building * page.commands for page in pages)
    return 5 * max(1, round(total / 300))


class MinutesRole(SphinxRole):
    """``minutes``: how many minutes one or several pages take."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        """Something in the place of the number."""
        *names, last = self.text.split()
        building = last == "building"
        pages = [self.env.relfn2path(f"{name}.rst")[0][:-4] for name in (names if building else [*names, last])]
        if lacking := [page for page in pages if page not in self.env.found_docs]:
            note(self.env, self.get_source_info()[1], self.rawtext, f"there is no page {lacking[0]}")
            return [], []
        self.env.metadata[self.env.docname]["timed"] = True
        return [_Minutes(pages=pages, building=building)], []


def _all(env: BuildEnvironment) -> dict[str, Seconds]:
    return cast("dict[str, Seconds]", env.__dict__.setdefault("rosspin_seconds", {}))


def _measure(app: Sphinx, page: nodes.document) -> None:
    """Keep how long a page takes; a notebook that says something else is in the list at the end."""
    name = app.env.docname
    _all(app.env)[name] = seconds(page)
    path = Path(app.env.doc2path(name))
    if path.suffix != ".md":
        return
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines()):
        wanted = f"**Time**: {rounded([_all(app.env)[name]])} minutes"
        if (found := _TIME.search(line)) and found[0] != wanted:
            file = path.relative_to(app.srcdir).as_posix()
            edit = Edit(file, number, number + 1, (line.replace(found[0], wanted),))
            stale = Stale(file, number + 1, found[0], wanted, edits=(edit,))
            noted(app.env).setdefault(name, set()).add(stale)


def _purge(app: Sphinx, env: BuildEnvironment, page: str) -> None:
    _all(env).pop(page, None)


def _merge(app: Sphinx, env: BuildEnvironment, pages: Sequence[str], other: BuildEnvironment) -> None:
    _all(env).update({page: found for page, found in _all(other).items() if page in pages})


def _write_again(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Write the pages that give minutes again when these have changed."""
    now = {name: (rounded([found]), rounded([found], True)) for name, found in _all(env).items()}
    if env.__dict__.get("rosspin_minutes") == now:
        return []
    env.__dict__["rosspin_minutes"] = now
    return sorted(name for name, data in env.metadata.items() if "timed" in data)


def _fill_in(app: Sphinx, doctree: nodes.document, name: str) -> None:
    for node in list(doctree.findall(_Minutes)):
        pages = [_all(app.env)[page] for page in node["pages"]]
        node.replace_self(nodes.Text(str(rounded(pages, node["building"]))))


def setup(app: Sphinx) -> ExtensionMetadata:
    """Add the role, and connect the functions above."""
    app.add_role("minutes", MinutesRole())
    app.connect("env-purge-doc", _purge)
    app.connect("env-merge-info", _merge)
    app.connect("doctree-read", _measure)
    app.connect("env-updated", _write_again)
    app.connect("doctree-resolved", _fill_in)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
