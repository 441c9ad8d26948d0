"""Sphinx extension: listings that run in the page, and the policy on what a page may load.

A listing of the class ``live`` (``:class: live`` on its literalinclude, the tag ``live`` on a notebook cell) is found
and run by ``web/``. One in C++ shows a whole file, whose program is among the site's files; one in XML shows a launch
file, of which that is true of all that it starts. Listings of the class ``together`` also run in pairs: the page's
first with its second, its third with its fourth, in each language. Below the listing of a node is the
plot of a run that is made with the page. ``web/`` also moves the figures with a handle.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import inspect
import json
import os
import re
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.typing import ExtensionMetadata

from ..clocks.simulation import Simulation
from ..cpp import build, lean
from ..exercises import code
from ..measures import lost_by_source
from ..plots import picture
from ..plots.pictures import page
from ..run.explain import TimeStandsStill
from ..run.kinds import language_of
from ..run.simulate import run_node
from ..run.source import load, load_source, split_words
from ..run.streams import capture
from ..world.graph import TickLog
from ..world.world import NotSimulated
from . import packing
from .launched import launched

__all__ = ["plot", "setup"]

# What `make html` builds from web/, below the html_static_path.
_SCRIPT = "live/live.js"
_STYLE = "live/live.css"
_HANDLES = "handles/handles.js"
_VEHICLE = "handles/vehicle.js"
_STEPS = "stepper/steps.js"
_STEPS_STYLE = "stepper/stepper.css"
_HAND_IN = "hand-in/hand-in.js"
_JUDGE = "hand-in/judge.js"
_HAND_IN_STYLE = "hand-in/hand-in.css"
_LOOK = "look/look.js"
_LOOK_STYLE = "look/look.css"

# How long (s) a listing runs, unless its first line says otherwise. web/src/cell.js has the same number.
SECONDS = 10.0

# Shown until the script is there and takes it away.
_NO_SCRIPT = '<p class="live-missing">To run this listing here, the page needs JavaScript.</p>'

# Names by which the theme and myst-nb hide the visible words from a screen reader, and their replacements.
_CORRECTED = {
    r'(<button [^>]*\bsearch-button-field\b[^>]*) aria-label="Search"': r"\1",
    '<summary aria-label="Toggle hidden content">': "<summary>",
}

# The folder of the programs of listings in C++, and of what launch files start, and the classes that name these by the
# SHA-256 of their files: what a listing is, and what it needs besides.
_PROGRAMS = "_static/programs"
_COMPILER = "_static/clang"
# Which way of making programs small it was, for those that are kept.
_LEANER = hashlib.sha256(Path(inspect.getfile(lean)).read_bytes()).hexdigest()[:8]
_PROGRAM = re.compile(r"\b(?:program|launch|needs)-([\da-f]{64})\b")

_INLINE_SCRIPT = re.compile(r"<script(?![^>]*\bsrc=)[^>]*>(.*?)</script>", re.DOTALL)
_CHARSET = '<meta charset="utf-8" />'


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the functions below."""
    app.connect("doctree-read", _mark_cells)
    app.connect("doctree-resolved", _add_below)
    app.connect("html-page-context", _add_files)
    app.connect("build-finished", _finish_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _mark_cells(app: Sphinx, doctree: nodes.document) -> None:
    for cell in doctree.findall(nodes.container):
        if "tag_live" in cell["classes"]:
            code = next(cell.findall(nodes.literal_block))
            code["classes"].append("live")
        if cell.get("hide_mode") == "output":  # which is a figure wherever the code is shown
            cell["prompt_show"], cell["prompt_hide"] = "Show the figure", "Hide the figure"


def _live_listings(app: Sphinx, doctree: nodes.document | None) -> list[nodes.literal_block]:
    # If web/ was not built, as for the doctests, the listings are plain.
    if doctree is None or not _is_built(app, _SCRIPT):
        return []
    return [node for node in doctree.findall(nodes.literal_block) if "live" in node["classes"]]


def _is_built(app: Sphinx, file: str) -> bool:
    return any((app.confdir / folder / file).is_file() for folder in app.config.html_static_path)


def _add_below(app: Sphinx, doctree: nodes.document, name: str) -> None:
    """Add to each live listing its plot, and a note that is shown until the script is there."""
    for listing in _live_listings(app, doctree):
        captioned = isinstance(listing.parent, nodes.container) and "literal-block-wrapper" in listing.parent["classes"]
        place = listing.parent if captioned else listing
        where = place.parent.index(place) + 1
        language, folder = listing.get("language"), Path(app.outdir, _PROGRAMS)
        file = listing["source"] if language in ("cpp", "xml") else ""
        if file and app.builder.format == "html":
            publish = _publish_launch if language == "xml" else _publish
            listing["classes"] += publish(Path(file), folder)
        if "highlight-cpp" in listing["classes"] and app.builder.format == "html":
            listing["classes"] += _publish_text(code(listing.astext()), Path(app.outdir, _PROGRAMS))
        made = "" if language == "xml" else plot(listing.astext(), file)
        place.parent.insert(where, nodes.raw("", made + _NO_SCRIPT, format="html"))


def _publish(file: Path, folder: Path) -> list[str]:
    """Put the program of a C++ node into a folder, and return the class that names it."""
    return _publish_program(build(file).program, file.read_text(encoding="utf-8"), folder)


def _publish_text(text: str, folder: Path) -> list[str]:
    """Do that for a node that is an exercise's."""
    return _publish_program(build("answer.cpp", text=text, closed=True).program, text, folder)


def _publish_program(program: Path, text: str, folder: Path) -> list[str]:
    packed = program.with_suffix(f".{_LEANER}.gz")
    if not packed.exists():
        beside = packed.with_suffix(f".{os.getpid()}")
        beside.write_bytes(gzip.compress(lean(program.read_bytes(), text), mtime=0))
        beside.rename(packed)
    return [f"program-{_put(packed.read_bytes(), folder)}"]


def _publish_launch(file: Path, folder: Path) -> list[str]:
    """Put what a launch file starts into a folder, and return the classes that name it."""
    path, names, around = launched(file)
    programs = {name: _publish(around / name, folder)[0] for name in names if language_of(name)}
    needs = {name: program.removeprefix("program-") for name, program in programs.items()}
    files = {name: (around / name).read_text(encoding="utf-8") for name in names}
    data = json.dumps({"path": path, "files": files, "programs": needs}).encode()
    return [f"launch-{_put(gzip.compress(data, mtime=0), folder)}", *(f"needs-{each}" for each in needs.values())]


def _put(data: bytes, folder: Path) -> str:
    """Write a file that is named by its SHA-256, which is returned."""
    digest = hashlib.sha256(data).hexdigest()
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{digest}.gz").write_bytes(data)
    return digest


def plot(text: str, file: str = "") -> str:
    """Run a listing in simulated time, and return its timeline as HTML; empty if there are no ticks.

    One in C++ is the text of a ``file``. A first line ``%%simulate SECONDS -- ARGS`` gives the time and the arguments.
    """
    first, _, rest = text.partition("\n")
    seconds, args = SECONDS, cast(Sequence[str], ())
    if first.startswith("%%"):
        (magic, *words), args = split_words(shlex.split(first[2:]))
        if magic != "simulate":
            return ""
        seconds, text = float(words[0]), "\n" + rest
    with capture():
        try:
            clock = Simulation()
            node = load(file) if file else load_source(text, "<listing>")
            result = run_node(node, seconds, args, clock, TickLog())
        except (SyntaxError, NotSimulated, TimeStandsStill):
            return ""
    if not result.ticks:
        return ""
    end, recording = min(clock.seconds(), seconds), result.host.recording
    periods, run = recording.periods(), result.run("", "simulated", end)
    some_lost = {source: periods[source] for source in lost_by_source(run.ticks, periods, run.coming)}
    figure = picture(run, some_lost, caption=f"simulated when this page was made: the first {seconds:g} s")
    return page(figure).replace('<figure class="', '<figure class="live-made ', 1)


def _add_files(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    if listings := _live_listings(app, doctree):
        app.add_js_file(_SCRIPT, loading_method="defer")
        app.add_css_file(_STYLE)
    if any(listing.astext().startswith("%%answer ") for listing in listings):
        app.add_js_file(_HAND_IN, loading_method="defer", priority=400)  # before _SCRIPT
        app.add_css_file(_HAND_IN_STYLE)
    if 'class="rosspin-judge ' in context.get("body", "") and _is_built(app, _JUDGE):
        app.add_js_file(_JUDGE, loading_method="defer")
        app.add_css_file(_HAND_IN_STYLE)
    if 'class="rosspin-look ' in context.get("body", "") and _is_built(app, _LOOK):
        app.add_js_file(_LOOK, loading_method="defer")
        app.add_css_file(_LOOK_STYLE)
    if " data-positions='" in context.get("body", "") and _is_built(app, _HANDLES):
        app.add_js_file(_HANDLES, loading_method="defer")
    if " data-vehicle='" in context.get("body", "") and _is_built(app, _VEHICLE):
        app.add_js_file(_VEHICLE, loading_method="defer")
    if " data-scenes='" in context.get("body", "") and _is_built(app, _STEPS):
        app.add_js_file(_STEPS, loading_method="defer")
        app.add_css_file(_STEPS_STYLE)


def _finish_pages(app: Sphinx, error: Exception | None) -> None:
    """Give each page its Content-Security-Policy, correct the names in it, and drop programs that no page runs."""
    if error is not None or app.builder.format != "html":
        return
    programs: set[str] = set()
    for path in Path(app.outdir).rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        programs.update(_PROGRAM.findall(text))
        if "_static" not in path.parts and "Content-Security-Policy" not in text:
            for found, corrected in _CORRECTED.items():
                text = re.sub(found, corrected, text)
            head = f'{_CHARSET}\n    <meta http-equiv="Content-Security-Policy" content="{policy(text)}" />'
            path.write_text(text.replace(_CHARSET, head, 1), encoding="utf-8")
    for path in Path(app.outdir, _PROGRAMS).glob("*"):
        if path.name.partition(".")[0] not in programs:
            path.unlink()
    if programs:
        packing.publish(Path(app.outdir, _COMPILER), app.confdir)


def policy(page: str) -> str:
    """Return the Content-Security-Policy of a page (HTML): nothing from elsewhere, no inline scripts but its own.

    Styles may be inline, as plots, tables and the editor need them.
    """
    digests = [hashlib.sha256(script.encode()).digest() for script in _INLINE_SCRIPT.findall(page)]
    hashes = [f"'sha256-{base64.b64encode(digest).decode()}'" for digest in digests]
    return "; ".join(
        [
            "default-src 'self'",
            " ".join(["script-src 'self' 'wasm-unsafe-eval'", *dict.fromkeys(hashes)]),
            "style-src 'self' 'unsafe-inline'",
            "img-src 'self' data:",
            "object-src 'none'",
            "base-uri 'self'",
            "form-action 'self'",
        ]
    )
