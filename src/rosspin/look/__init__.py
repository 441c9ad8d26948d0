"""Look at a log that somebody brings: what repeats in it, at what period, how late it is, and which fault it looks like.

Plain Python, so that the page does it, too, without the text leaving the computer.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .diagnosing import TITLES, Verdict, diagnose
from .reading import BAGS, LIMIT, Log, NoLog, read
from .series import Series, group

__all__ = ["LIMIT", "TITLES", "Look", "NoLog", "Series", "Verdict", "look"]

NS = 10**9


@dataclass(frozen=True)
class Look:
    """What was found in a log.

    ``name`` is that of the file, ``kind`` console, table or bag, ``start`` when it begins (ns since the epoch), and
    ``seconds`` how long it is. ``notes`` are sentences on what was not read. The ``series`` are the lines, tables or
    topics that repeat, the most frequent first; the ``verdicts`` what they show, the one that matters most first, and at
    least one.
    """

    name: str
    kind: str
    entries: int
    start: int
    seconds: float
    notes: tuple[str, ...]
    series: tuple[Series, ...]
    verdicts: tuple[Verdict, ...]

    def as_dict(self) -> dict[str, Any]:
        """All of it for JSON, times in seconds from the first entry; ``late`` and ``missing`` of a grid alone."""
        return {
            "name": self.name,
            "kind": self.kind,
            "entries": self.entries,
            "start": self.start / NS,
            "seconds": self.seconds,
            "notes": list(self.notes),
            "verdicts": [
                {
                    "name": verdict.name,
                    "title": verdict.title,
                    "certain": verdict.certain,
                    "evidence": list(verdict.evidence),
                    "page": verdict.page,
                    "series": list(verdict.series),
                }
                for verdict in self.verdicts
            ],
            "series": [self._series(series) for series in self.series],
        }

    def _series(self, series: Series) -> dict[str, Any]:
        return {
            "name": series.name,
            "node": series.node,
            "process": series.process,
            "part": series.part,
            "count": len(series.times),
            "period": series.period / NS or None,
            "rate": NS / series.period if series.period else None,
            "chosen": series.chosen / NS or None,
            "drift": series.drift,
            "spread": series.spread / NS,
            "times": [(time - self.start) / NS for time in series.times],
            "expected": [(time - late) / NS for time, late in zip(self._from_start(series), series.late)],
            "late": [late / NS for late in series.late],
            "missing": [(time - self.start) / NS for time in series.missing],
        }

    def _from_start(self, series: Series) -> list[int]:
        return [time - self.start for time in series.times]


def look(data: bytes, name: str = "") -> Look:
    """Look at a text or a bag, of which ``data`` are the bytes and ``name`` is the file's name.

    Raises :class:`NoLog`, which is a ValueError, if nothing can be made of it; the message says why in a line.
    """
    log = _bag(data) if any(data.startswith(magic) for magic in BAGS) else read(data[:LIMIT])
    series = tuple(group(log.entries, log.kind))
    times = [entry.time for entry in log.entries]
    start = min(times)
    return Look(
        name,
        log.kind,
        len(times),
        start,
        (max(times) - start) / NS,
        tuple(log.notes),
        series,
        tuple(diagnose(log, series)),
    )


def _bag(data: bytes) -> Log:
    from .bags import read_bag  # which a page does not have

    return read_bag(data)
