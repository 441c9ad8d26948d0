"""Runs of ROS 2 as figures that a reader goes through step by step, on a page and in a notebook."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Sequence
from pathlib import Path

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import PythonLexer

from ..run.scenes import Scenes
from ..run.simulate import run_node
from ..run.source import load
from ..run.streams import capture
from ..world.graph import TickLog

__all__ = ["Shown", "figure"]


def figure(path: str, seconds: float, args: Sequence[str], rings: bool = False) -> str:
    """Run the node in the file ``path`` in simulated time; return its steps as HTML, or with ``rings`` its waits alone.

    Where no script runs, the steps are a list, and each ring of waits is a sentence. Raises ValueError if there is
    nothing to show.
    """
    log = TickLog()
    scenes = Scenes(log, path)
    with capture():
        status = run_node(load(path), seconds, args, scenes.clock, log).status
    data = scenes.data(status)
    if not data or (rings and not data["rings"]):
        what = "nothing hangs" if data else "no executor of ROS 2 has spun, or the node has too many callbacks"
        raise ValueError(what)
    if rings:
        data |= {"steps": []}
    name = os.path.basename(path)
    carried = html.escape(json.dumps(data | {"name": name}, separators=(",", ":")), quote=False)
    carried = carried.replace("'", "&#39;")
    lines = [f"{time:g} s: {said}" for time, said, *_ in data["steps"]]
    lines = lines or [f"{name} {waits}" for ring in data["rings"] for name, waits in ring["links"]]
    items = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
    caption = f"<figcaption>simulated: {name}, {seconds:g} s</figcaption>"
    return f"<figure class='rosspin-scenes' data-scenes='{carried}'><ol>{items}</ol>{caption}</figure>"


class Shown:
    """The same next to the file, as what a cell of a notebook ends with."""

    def __init__(self, path: str, seconds: float) -> None:
        listing = highlight(Path(path).read_text(encoding="utf-8"), PythonLexer(), HtmlFormatter())
        self._html = f'<div class="rosspin-beside">{listing}{figure(path, seconds, [])}</div>'

    def _repr_html_(self) -> str:
        return self._html
