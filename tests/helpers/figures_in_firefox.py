"""A figure with a handle in Firefox: it is moved there by keys and by the mouse."""

from __future__ import annotations

import re
from typing import Any

from .figures import SHOWN, Kind, check_rows
from .firefox import Tab

# A figure: what a screen reader is told of its handle, and the place of that; its rows, alternative text and axis (s).
FIGURE = f"""async number => {{
    const figure = document.querySelectorAll("figure[data-positions]")[number]
    const handle = figure.querySelector("input")
    await new Promise(requestAnimationFrame)
    const {{ x, y, width, height }} = handle.getBoundingClientRect()
    return {{
        value: handle.getAttribute("aria-valuetext"),
        place: [x, y, width, height],
        rows: ({SHOWN})(figure),
        alternative: [...figure.querySelectorAll("svg[role=img]")]
            .find(one => one.getBoundingClientRect().width).getAttribute("aria-label"),
        span: JSON.parse(figure.dataset.positions).span,
    }}
}}"""
TO_HANDLE = """number => {
    const handle = document.querySelectorAll("figure[data-positions] input")[number]
    handle.scrollIntoView({ behavior: "instant", block: "center" })
    handle.focus()
}"""


def _figure(page: Tab, kind: Kind) -> Any:
    """A figure of the page that is open, whose ticks come from a run."""
    seen = page.evaluate(FIGURE, kind.number)
    said = re.fullmatch(r"([\d.]+) s", seen["value"])
    assert said
    seen["value"] = float(said[1])
    check_rows(kind, seen["value"], seen["rows"], seen["alternative"], seen["span"])
    return seen


def moves(page: Tab, address: str, kind: Kind) -> None:
    """At each position it shows the ticks of a run."""
    page.open(address + kind.page)
    page.evaluate(TO_HANDLE, kind.number)
    found = []
    for key in ("Home", "ArrowRight", "PageUp", "End", "ArrowLeft"):
        page.press(key)
        found.append(_figure(page, kind)["value"])
    assert found[0] < found[1] < found[2] < found[3] > found[4]

    x, y, width, height = _figure(page, kind)["place"]
    places = [(x + width * share, y + height / 2) for share in (0.5, 0.1, 0.45, 0.8)]
    found = [_figure(page, kind)["value"] for _ in page.drag(places)]
    assert found == sorted(set(found))
