"""Look at a log that someone brings: what repeats in it, at what period and how late, and which fault it looks like.

Plain Python, so that the page does it, too, without the text leaving the computer.
"""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, BinaryIO

from ..measures import quantile, say_time
from ..results.ticks import Tick
from .diagnosing import TITLES, Verdict, diagnose
from .reading import BAGS, LIMIT, Log, NoLog, read
from .series import FEWEST, Series, first_run, group

__all__ = ["TITLES", "Look", "NoLog", "Series", "Verdict", "look"]

NS = 10**9

# Is told now and then which part has been read.
Progress = Callable[[float], None]


@dataclass(frozen=True)
class Look:
    """What was found in a log.

    ``name`` is the file's, ``kind`` console, table or bag, ``ros`` 1 or 2, ``start`` when it begins (ns since the
    epoch), and ``seconds`` how long it is. ``notes`` are sentences on what was not read. The ``series`` are the lines,
    tables or topics that repeat, the most frequent first; the ``verdicts``, at least one, are what they show, what
    matters most first.
    """

    name: str
    kind: str
    ros: int
    entries: int
    start: int
    seconds: float
    notes: tuple[str, ...]
    series: tuple[Series, ...]
    verdicts: tuple[Verdict, ...]

    def as_dict(self) -> dict[str, Any]:
        """Return all of it for JSON: times in seconds from the first entry; ``late`` and ``missing`` only of a grid."""
        return {
            "name": self.name,
            "kind": self.kind,
            "ros": self.ros,
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

    def ticks(self) -> list[Tick]:
        """Return up to 12 regular series as ticks for :mod:`rosspin.plots`, in seconds from the first entry.

        They are expected on the grid that fits best; how long they took is not known.
        """
        return [
            Tick(_source(series), number, (time - late - self.start) / NS, (time - self.start) / NS, math.nan)
            for series in [series for series in self.series if series.is_regular][:12]
            for number, (time, late) in enumerate(zip(series.times, series.late, strict=True), 1)
        ]

    def report(self) -> Iterator[str]:
        """Yield what a terminal shows: the series, then the verdicts with their evidence, line by line."""
        yield f"{self.name}: {self.kind}, {self.entries} entries in {self.seconds:.1f} s"
        yield from self.notes
        yield ""
        rows = [_row(series) for series in self.series if len(series.times) >= FEWEST]
        if rows:
            rows.insert(0, ("entries", "rate", "period", "late, 98%", "missing", "line"))
            widths = [max(len(row[n]) for row in rows) for n in range(5)]
            for *numbers, name in rows:
                yield "  ".join([*(text.rjust(width) for text, width in zip(numbers, widths, strict=True)), name])
            yield ""
        for verdict in self.verdicts:
            yield f"{verdict.title} ({verdict.certain})"
            for sentence in verdict.evidence:
                yield f"  {sentence}"
            yield f"  See {verdict.page}"

    def _series(self, series: Series) -> dict[str, Any]:
        return {
            "name": series.name,
            "node": series.node,
            "process": series.process,
            "part": series.part,
            "count": len(series.times),
            "per_burst": series.per_pass,
            "burst": series.length / NS,
            "period": series.period / NS or None,
            "rate": NS / series.period if series.period else None,
            "chosen": series.chosen / NS or None,
            "drift": series.drift,
            "spread": series.spread / NS,
            "times": [(time - self.start) / NS for time in series.times],
            "late": [late / NS for late in series.late],
            "missing": [(time - self.start) / NS for time in series.missing],
        }


def _source(series: Series) -> str:
    return f"{series.name} ({series.part})" if series.part else series.name


def _row(series: Series) -> tuple[str, ...]:
    entries = str(len(series.times)) + (f" × {series.per_pass:.3g}" if series.per_pass != 1 else "")
    if not series.is_regular:
        return entries, "", "irregular", "", "", _source(series)
    late = quantile([abs(late) for late in series.late], 0.98)
    period = f"{series.period / 1e6:.4g} ms"
    return (
        entries,
        f"{NS / series.period:.4g} Hz",
        period,
        say_time(late / NS),
        str(len(series.missing)),
        _source(series),
    )


def look(log: bytes | BinaryIO, name: str = "", progress: Progress = lambda part: None) -> Look:
    """Look at a text or a bag: its bytes, or a file that is open, of which no more is read than is looked at.

    ``name`` is what to call it; ``progress`` is told now and then which part of a bag has been read, from 0 to 1.
    Raises :class:`NoLog`, which is a ValueError, if nothing can be made of it; the message says why in a line.
    """
    file = io.BytesIO(log) if isinstance(log, bytes) else log
    begin = file.read(8)
    if begin == b"SQLite f":
        begin += file.read(8)
    return _look(_bag(begin, file, progress) if begin in BAGS else read(begin + file.read(LIMIT - len(begin))), name)


def _look(log: Log, name: str) -> Look:
    log.entries, others = first_run(log.entries)
    if others:
        log.notes.append(f"Another run begins after {len(log.entries)} entries, or the same again: it was set aside.")
    series, of = group(log.entries, log.kind)
    if of:
        log.notes.append(f"Of {of:,} different lines or topics, the {len(series)} most frequent were looked at.")
    log.ros = log.ros or (2 if any(each.node for each in series) else 1)
    times = [entry.time for entry in log.entries]
    start = min(times)
    return Look(
        name,
        log.kind,
        log.ros,
        len(times),
        start,
        (max(times) - start) / NS,
        tuple(log.notes),
        tuple(series),
        tuple(diagnose(log, series)),
    )


def _bag(magic: bytes, file: BinaryIO, progress: Progress) -> Log:
    try:
        from .bags import read_bag
    except ImportError:  # in a page
        raise NoLog("this is a bag, which is read on your computer only: rosspin look FILE") from None
    return read_bag(magic, file, progress)
