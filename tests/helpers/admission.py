"""Lets runs begin as the machine can take them: by measured load, not by a number of them."""

from __future__ import annotations

import os
import threading
import time
from pathlib import Path

# So much of a processor has to be free for another run to begin, measured over so long (s).
FREE = 0.8
WINDOW = 0.2


class Admission:
    """Lets one run after another in when a processor is free.

    All of them wait for no more than ``patience`` (s) together: on a machine that stays busy they begin nevertheless,
    and say themselves whether they were disturbed.
    """

    def __init__(self, patience: float) -> None:
        self._patience = patience
        self._door = threading.Lock()

    def wait(self) -> None:
        """Return when the next one may begin."""
        with self._door:
            while self._patience > 0 and _free() < FREE:
                self._patience -= WINDOW

    def open(self) -> None:
        """Let all in that still wait."""
        self._patience = 0


def _free() -> float:
    """How many processors have nothing to do; where the kernel does not say so, one."""
    try:
        before = _idle()
        time.sleep(WINDOW)
        return (_idle() - before) / WINDOW
    except OSError:
        return 1.0


def _idle() -> float:
    """For how long (s) processors have had nothing to do, all together."""
    words = Path("/proc/stat").read_text().split(maxsplit=6)
    return (int(words[4]) + int(words[5])) / os.sysconf("SC_CLK_TCK")
