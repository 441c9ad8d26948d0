"""A run as a test: the text of a pytest function that makes the run again and compares."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import PurePath

from .ticks import Tick

__all__ = ["as_test"]

# The encoding, if a comment in the first two lines names it. The test writes the source to a file as UTF-8.
_COOKIE = re.compile(r"\A((?:[ \t\f]*(?:#.*)?\n)??[ \t\f]*#.*?coding[:=][ \t]*)[-\w.]+")


def as_test(
    source: str, filename: str, seconds: float, args: Sequence[str], console: str, ticks: Sequence[Tick]
) -> str:
    """Write a test that a node still does what it did in a simulated run of ``seconds``, which ended with status 0.

    It carries the node's ``source``, so it needs nothing else. Of one in C++, the ``console`` has no colours.
    """
    name = PurePath(filename).stem
    words = f", {list(args)!r}" if args else ""
    shown, able, imports = "run.console", "is installed", ["from rosspin import simulate"]
    if PurePath(filename).suffix != ".py":
        shown, able = r're.sub(r"\x1b\[[\d;]*m", "", run.console)', "can compile C++"
        imports[:0] = ["import re", ""]
    else:
        source = _COOKIE.sub(r"\1utf-8", source)
    expected = _grid(ticks) or "\n".join(["[", *(f"        {_fields(tick)!r}," for tick in ticks), "    ]"])
    return "\n".join(
        [
            f"# {filename} still does what it did. Run this with pytest, where rosspin {able}.",
            *imports,
            "",
            f"NODE = {_text(source, '')}",
            "",
            "",
            f"def test_{re.sub(r'[^0-9a-zA-Z_]', '_', name)}(tmp_path, monkeypatch):",
            "    monkeypatch.chdir(tmp_path)",
            f"    node = tmp_path / {filename!r}",
            '    node.write_text(NODE, encoding="utf-8")',
            f"    run = simulate(node.name, {seconds!r}{words})",
            "    assert run.status == 0",
            f"    assert [(tick.source, tick.number, tick.expected, tick.real) for tick in run.ticks] == {expected}",
            f"    assert {shown} == {_text(console, '    ')}",
            "",
        ]
    )


def _fields(tick: Tick) -> tuple[str, int, float, float]:
    return tick.source, tick.number, tick.expected, tick.real


def _grid(ticks: Sequence[Tick]) -> str:
    """Write the ticks of a source as an expression, if all are on time on a grid that begins with the run; else ""."""
    if len(ticks) < 3:
        return ""
    source, last = ticks[0].source, len(ticks)
    for time in (f"{ticks[0].expected!r} * n", f"round({ticks[0].expected!r} * n, 9)"):
        grid = f"[({source!r}, n, {time}, {time}) for n in range(1, {last + 1})]"
        if eval(grid) == [_fields(tick) for tick in ticks]:
            return grid
    return ""


def _text(text: str, indent: str) -> str:
    """Write a text as Python does, line by line."""
    lines = [f"{indent}    {line!r}" for line in text.splitlines(keepends=True)]
    return "\n".join(["(", *lines, f"{indent})"]) if lines else "''"
