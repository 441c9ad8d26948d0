"""Show matplotlib's figures in a page: as wide as the text, in its colours, light or dark, and described in words.

A page has a figure twice, drawn for a wide and for a narrow place; a container query shows the one that fits.
"""

from __future__ import annotations

import html
import io
import os
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, cast
from weakref import WeakKeyDictionary
from xml.etree import ElementTree

from ..results.saving import save_whole
from .layout import MARGIN

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = [
    *("STANDALONE", "SUFFIXES", "alternative", "drawing", "figure_of", "margin", "missing", "new_axes", "new_column"),
    *("number", "page", "save"),
]

SUFFIXES = (".pdf", ".png", ".svg")

# How wide a figure is drawn (px, matplotlib's points): as wide as the site's text on a screen and on a phone. Between
# these it is scaled by at most 1.5.
_WIDTHS = {"rosspin-wide": 760, "rosspin-narrow": 365}
_CSS = (
    "<style>.rosspin-plot{container-type:inline-size}"
    "@container(max-width:530px){.rosspin-wide{display:none!important}}"
    "@container(min-width:530.01px){.rosspin-narrow{display:none!important}}</style>"
)
_MARGIN = 10  # px, in a file of its own
_PAD = 0.03  # in, next to the axes: see rosspin.mplstyle
STANDALONE = (  # the style of an SVG that is a file
    "svg{color:#1b1b1b;background:#fff;font-family:system-ui,sans-serif}"
    "@media(prefers-color-scheme:dark){svg{color:#eee;background:#14181e}}"
)

# The Axes that rosspin has drawn in, with their captions. Their labels say what is seen in them.
_captions: WeakKeyDictionary[Axes, str] = WeakKeyDictionary()


def missing() -> str:
    """Return what to do if matplotlib is missing; empty if it is not."""
    if "matplotlib" in sys.modules or find_spec("matplotlib"):
        return ""
    return "plots need matplotlib, which is not installed: pip install 'rosspin[plot]'"


@contextmanager
def drawing(ax: Axes | None, alt: str, caption: str, height: float = 220) -> Iterator[Axes]:
    """Draw in these Axes, or in new ones of pyplot's, ``height`` px high, in the style for plots of ticks.

    The Axes are labelled with what is seen in them, and Jupyter shows them as a page does. Raises ImportError without
    matplotlib.
    """
    if advice := missing():
        raise ImportError(advice)
    import matplotlib.style

    if ax is None:
        from matplotlib import pyplot

        # Outside the style: the first figure chooses the backend, which the end of the style would undo.
        figure = pyplot.figure(figsize=(_WIDTHS["rosspin-wide"] / 72, height / 72))
    with matplotlib.style.context("rosspin.plots.rosspin"):
        if ax is None:
            figure.set_layout_engine("constrained")
            ax = figure.add_subplot()
        ax.set_label(f"{ax.get_label()} {alt}" if ax in _captions else alt)
        _captions[ax] = caption
        yield ax
    _offer_html()


def margin(share: float) -> float:
    """Return what matplotlib calls the margin of an axis: a part of its data, for a ``share`` of a picture's width."""
    width, pad = _WIDTHS["rosspin-wide"], 72 * _PAD
    inside = (share * width - pad) / (width - 2 * pad)
    return inside / (1 - 2 * inside)


def number(ax: Axes, numbers: Callable[[float, float], list[float]]) -> None:
    """Number the axis of time by a rule of where its data begin and how long they are, whatever part is shown."""
    from matplotlib.ticker import Locator

    class Numbers(Locator):
        def __call__(self) -> list[float]:
            return self.tick_values(*ax.get_xlim())

        def tick_values(self, vmin: float, vmax: float) -> list[float]:
            around = margin(MARGIN) * (vmax - vmin) / (1 + 2 * margin(MARGIN))
            span = vmax - vmin - 2 * around
            return numbers(vmin + around, span) if span > 0 else []

    ax.xaxis.set_major_locator(Numbers())


def new_axes(height: float) -> Axes:
    """Make Axes in a figure that pyplot does not know, ``height`` px high: no one closes it, and no window opens."""
    return new_column([height])[0]


def new_column(heights: Sequence[float]) -> list[Axes]:
    """Make Axes of these heights (px) below each other in such a figure."""
    if advice := missing():
        raise ImportError(advice)
    import matplotlib.style
    from matplotlib.figure import Figure

    with matplotlib.style.context("rosspin.plots.rosspin"):
        figure = Figure((_WIDTHS["rosspin-wide"] / 72, sum(heights) / 72))
        return list(figure.subplots(len(heights), height_ratios=heights, squeeze=False)[:, 0])


def figure_of(ax: Axes) -> Figure:
    """Return the whole figure that Axes are in."""
    return cast("Figure", ax.get_figure(root=True))


def alternative(figure: Figure) -> str:
    """Say what is seen in a figure: the labels of its Axes, and which part of the data is shown."""
    words = []
    for ax in figure.axes:
        label, (first, last) = str(ax.get_label()), ax.get_xlim()
        if label and not label.startswith("<"):
            words.append(label)
        if ax in _captions and (first > ax.dataLim.x0 or last < ax.dataLim.x1):
            words.append(f"Shown is the part from {first:g} to {last:g}.")
    return " ".join(words)


def page(figure: Figure, handle: str = "", data: str = "") -> str:
    """Turn a figure into HTML, with the captions of its Axes. It fits any width; without ids, a page can have many.

    ``handle`` (HTML) is above it, and ``data`` are for the page's script.
    """
    captions = dict.fromkeys(filter(None, (_captions.get(ax) for ax in figure.axes)))
    caption = f"<figcaption>{html.escape('; '.join(captions))}</figcaption>" if captions else ""
    carried = html.escape(data, quote=False).replace("'", "&#39;")
    drawn = "".join(_svg(figure, name) for name in _WIDTHS)
    positions = f" data-positions='{carried}'" if data else ""
    return f'<figure class="rosspin-plot"{positions}>{_CSS}{handle}{drawn}{caption}</figure>'


def save(figure: Figure, path: str | os.PathLike[str]) -> None:
    """Save a figure as PNG, PDF or SVG, by the suffix of the file. An SVG is light or dark as its viewer prefers.

    The same figure gives the same bytes.
    """
    if Path(path).suffix == ".svg":
        text = f'<?xml version="1.0" encoding="utf-8"?>\n{_svg(figure, "rosspin-wide", standalone=True)}\n'
        save_whole(path, text.encode())
    else:
        drawn = io.BytesIO()
        undated = {"CreationDate": None} if Path(path).suffix == ".pdf" else {"Software": None}
        kind = Path(path).suffix.removeprefix(".")
        figure.savefig(drawn, format=kind, metadata=undated, bbox_inches="tight", pad_inches=_MARGIN / 72)
        save_whole(path, drawn.getvalue())


def _svg(figure: Figure, name: str, standalone: bool = False) -> str:
    import matplotlib

    (width, height), drawn = figure.get_size_inches(), io.StringIO()
    figure.set_size_inches(_WIDTHS[name] / 72, height, forward=False)
    options = {"svg.fonttype": "none", "svg.hashsalt": "rosspin", "savefig.bbox": None}
    try:
        with matplotlib.rc_context(options):  # type: ignore[arg-type]
            figure.savefig(drawn, format="svg", transparent=True)
    finally:
        figure.set_size_inches(width, height, forward=False)
    root = ElementTree.fromstring(drawn.getvalue())
    shapes = {element.attrib["id"]: element for element in root.iter() if "id" in element.attrib}
    box = [round(float(number)) for number in root.attrib["viewBox"].split()]
    for parent in root.iter():
        for mark in [child for child in parent if child.tag.endswith("}use") and not _is_inside(child, box)]:
            parent.remove(mark)  # of data beyond the limits, which matplotlib puts next to the picture
    if standalone:
        box = [-_MARGIN, -_MARGIN, box[2] + 2 * _MARGIN, box[3] + 2 * _MARGIN]
    attributes = {
        "xmlns": "http://www.w3.org/2000/svg",
        "class": name,
        "role": "img",
        "aria-label": alternative(figure),
        "width": str(box[2]) if standalone else "100%",
        **({"height": str(box[3])} if standalone else {}),
        "viewBox": " ".join(map(str, box)),
        "fill": "currentColor",
        "style": "display: block; overflow: visible; stroke-linejoin: round",
    }
    picture = _element("svg", attributes, *(part for child in root for part in _plain(child, shapes)))
    if standalone:
        picture.insert(0, _element("style", {}))
        picture[0].text = STANDALONE
    return ElementTree.tostring(picture, encoding="unicode")


def _is_inside(mark: ElementTree.Element, box: Sequence[float]) -> bool:
    return 0 <= float(mark.attrib["x"]) <= box[2] and 0 <= float(mark.attrib["y"]) <= box[3]


def _element(tag: str, attributes: dict[str, str], *children: ElementTree.Element) -> ElementTree.Element:
    element = ElementTree.Element(tag, attributes)
    for child in children:
        # Neighbours with the same clip share it.
        if child.tag == "svg" and len(element) and (element[-1].tag, element[-1].attrib) == (child.tag, child.attrib):
            element[-1].extend(child)
        else:
            element.append(child)
    return element


def _plain(element: ElementTree.Element, shapes: dict[str, ElementTree.Element]) -> Iterator[ElementTree.Element]:
    """Turn an element of matplotlib's SVG into one of the page's: in its font and colour, and without ids."""
    tag = element.tag.rpartition("}")[2]
    attributes = {name.rpartition("}")[2]: value for name, value in element.attrib.items() if name != "id"}
    if tag in ("metadata", "defs") or attributes.get("style") == "fill: none":  # the transparent background
        return
    clip = shapes.get(attributes.pop("clip-path", "")[5:-1])
    if tag == "use":
        shape, x, y = shapes[attributes.pop("href")[1:]].attrib["d"], attributes.pop("x"), attributes.pop("y")
        if dot := re.fullmatch(r"M 0 (\S+)\s+(?:C[^C]*){8}z\s*", shape):  # a shorter form
            tag, attributes = "circle", {"cx": x, "cy": y, "r": dot[1], **attributes}
        else:
            tag, attributes = "path", {"d": shape, "transform": f"translate({x} {y})", **attributes}
    if attributes.get("transform", "").startswith("rotate(-0 "):
        del attributes["transform"]
    for name, value in attributes.items():
        value = re.sub("font-family: [^;]*;? ?", "", value.replace("#000000", "currentColor").replace("  ", " "))
        attributes[name] = value if name == "style" else re.sub(r"-?\d+\.\d{2,}", _short, value)
    new = _element(tag, attributes, *(part for child in element for part in _plain(child, shapes)))
    new.text = element.text if tag in ("text", "tspan") else None
    parts = list(new) if tag == "g" and not attributes else [new]
    if clip is not None and "width" in clip[0].attrib:
        box = {name: re.sub(r".*", _short, clip[0].attrib[name], count=1) for name in ("x", "y", "width", "height")}
        parts = [_element("svg", {**box, "viewBox": " ".join(box.values())}, *parts)]
    yield from parts


def _short(number: re.Match[str]) -> str:
    return f"{round(float(number[0]), 1):g}"


def _offer_html() -> None:
    """Let Jupyter show the figures in which rosspin has drawn as a page does, and others as before.

    IPython sets what it shows of a figure again whenever it sets matplotlib's backend.
    """
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is None or not hasattr(shell, "kernel"):
        return
    import matplotlib
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    formatters = shell.display_formatter.formatters
    if Figure in formatters["text/html"].type_printers or "inline" not in matplotlib.get_backend():
        return

    def is_ours(figure: Figure) -> bool:
        return any(ax in _captions for ax in figure.axes)

    def shown(figure: Figure) -> str | None:
        return page(figure) if is_ours(figure) else None

    def shown_once(ax: Axes) -> str | None:
        """Show the figure of Axes that a cell ends with, and close it, or Jupyter would show it once more."""
        from matplotlib import pyplot

        if ax not in _captions:
            return None
        pyplot.close(figure_of(ax))
        return shown(figure_of(ax))

    for formatter in formatters.values():
        if before := formatter.type_printers.get(Figure):
            formatter.for_type(Figure, lambda figure, before=before: None if is_ours(figure) else before(figure))
    formatters["text/html"].for_type(Figure, shown)
    formatters["text/html"].for_type(Axes, shown_once)
