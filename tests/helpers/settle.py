"""Objects that stay: Python's garbage collector need not go through them again and again."""

from __future__ import annotations

import gc


def settle() -> None:
    """Let all that there is now stay."""
    gc.collect()
    gc.freeze()
