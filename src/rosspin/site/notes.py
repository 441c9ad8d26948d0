"""What no longer holds on the pages, as it is found while they are read, for the list at the end of a build."""

from __future__ import annotations

from pathlib import Path
from typing import cast

from sphinx.environment import BuildEnvironment

from .claims import Stale, sentence_near

__all__ = ["note", "noted"]


def noted(env: BuildEnvironment) -> dict[str, set[Stale]]:
    """Return what no longer holds, by the names of the pages."""
    return cast(dict[str, set[Stale]], env.__dict__.setdefault("rosspin_stale", {}))


def note(env: BuildEnvironment, line: int, stands: str, now: str, block: tuple[int, int] | None = None) -> None:
    """Add something on the page being read to the list. ``block`` are the lines whose sentence it is about."""
    path = Path(env.doc2path(env.docname))
    text = sentence_near(path.read_text(encoding="utf-8"), *block) if block else ""
    stale = Stale(path.relative_to(env.srcdir).as_posix(), line, stands, now, text)
    noted(env).setdefault(env.docname, set()).add(stale)
