"""What students hand in, and who solved what: the same on the page for teachers and in ``rosspin judge``.

Both find the files, read them, and make the tables here. How an answer is run and judged where nothing can happen is
different: see :mod:`rosspin.grading`, and ``web/src/judging.js`` for the page.
"""

from __future__ import annotations

__all__ = ["MOST_ANSWER", "MOST_FILE", "MOST_NAME", "MOST_SAID", "TIME", "too_long"]

MOST_FILE = 1_000_000
"""Of a file, so many bytes are read at most."""

MOST_ANSWER = 50_000
"""An answer is judged if it has at most so many characters."""

MOST_NAME = 100
"""So many characters of a name are read."""

TIME = 20
"""For how long (s) an answer may run, or be judged."""

MOST_SAID = 30_000
"""So much (characters) is kept of what was said of an answer."""


def too_long(answer: str) -> str:
    """Say that an answer is too long to be judged; nothing if it is not."""
    return f"It has {len(answer)} characters; at most {MOST_ANSWER} are judged." if len(answer) > MOST_ANSWER else ""
