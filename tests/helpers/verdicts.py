"""The third verdict: neither as it should be nor not so, because the machine disturbed the run that should have told.

Whether it did, a control in the same run says, which knows nothing of the node: a plain timer next to it, and what the
kernel counts of those who wait for a processor. What becomes of such tests: see ``real/conftest.py``.
"""

from __future__ import annotations

import os
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NoReturn, Self

import pytest

__all__ = ["Control", "Inconclusive", "control", "inconclusive"]


class Inconclusive(pytest.fail.Exception):  # type: ignore[name-defined, misc]
    """The machine disturbed a test. No Exception: no handler in a test, or in what it tests, is meant for it."""


def inconclusive(reason: str) -> NoReturn:
    """End a test as neither passed nor failed. The reason is what a control in the same run says of the machine."""
    __tracebackhide__ = True
    raise Inconclusive(reason)


@contextmanager
def control(bears: float) -> Iterator[Control]:
    """Judge what depends on time: a "not so" in this block is inconclusive if the machine has stalled meanwhile.

    ``bears`` says for how long (s) anything may be kept waiting at a stretch and the assertions in the block still
    hold. What holds at any speed is asserted outside of it.
    """
    __tracebackhide__ = True
    with Control() as beside:
        try:
            yield beside
        except AssertionError as error:
            if beside.stalled() <= bears:
                raise
            not_so = next(iter(str(error).splitlines()), "an assertion did not hold")
            inconclusive(f"the machine stalled for {beside.stalled():.2f} s (the test bears {bears} s): {not_so}")


class Control:
    """A plain timer next to a run, in a thread of this process.

    It sees that a processor stood still if it is itself called late; and at each call it asks how long anything has
    waited for a processor, a disk or memory, or a processor for its host. So it need not stand on each processor, nor
    be quick. Where that is not counted (not on Linux), its own calls have to do.
    """

    PERIOD = 0.025  # s

    # Of several processors the kernel gives the mean, so a line at one of them counts for its share.
    SHARE = 0.5 / (os.cpu_count() or 1)

    def __init__(self) -> None:
        self._longest = self._stretch = 0.0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._over.set()
        self._thread.join()

    def stalled(self) -> float:
        """For how long (s), at the longest, anything was kept waiting at a stretch so far."""
        return self._longest

    def called(self, took: float, waited: float) -> None:
        """Note that a call came ``took`` s after the last one, and that something waited for ``waited`` s of them."""
        stood_still = took > 1.5 * self.PERIOD or waited > self.SHARE * took
        self._stretch = self._stretch + took if stood_still else 0.0
        self._longest = max(self._longest, self._stretch)

    def _watch(self) -> None:
        before, waited_before = time.monotonic(), _waited()
        is_over = False
        while not is_over:
            is_over = self._over.wait(self.PERIOD)
            now, waited = time.monotonic(), _waited()
            self.called(now - before, waited - waited_before)
            before, waited_before = now, waited


def _waited() -> float:
    """How long (s) anything on this machine has waited so far for what others had, or a processor for its host."""
    pressures = (file.read_text() for file in Path("/proc/pressure").glob("*"))
    waits = [int(found[1]) / 1e6 for text in pressures if (found := re.search(r"^some .*total=(\d+)", text))]
    try:
        stolen = int(Path("/proc/stat").read_text().split(maxsplit=9)[8]) / os.sysconf("SC_CLK_TCK")
    except OSError:
        stolen = 0.0
    return sum(waits) + stolen
