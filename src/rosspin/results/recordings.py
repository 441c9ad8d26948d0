"""Load runs that were recorded on the real ROS, for machines without it."""

from __future__ import annotations

import csv
import json
import math
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from .console import read_ticks
from .machine import describe
from .ticks import Run, Tick

__all__ = ["COLUMNS", "Recording", "live_caption", "load"]

# A row for each tick; times in seconds since the run's start, empty where a first tick has none.
COLUMNS = [
    "source",
    "number",
    "last_expected",
    "last_real",
    "current_expected",
    "current_real",
    "last_duration",
]


@dataclass(frozen=True)
class Recording(Run):
    """A recorded run; ``provenance`` says what ran, where, when, with which versions and on how busy a machine."""

    provenance: Mapping[str, Any] = field(default_factory=dict, repr=False)

    @property
    def caption(self) -> str:
        """When and where the run was recorded, in words."""
        p = self.provenance
        versions = f"with ROS {p['ros']} on {p['system']}"
        return f"recorded on {p['date'][:10]} {versions}, {p['processor']} ({p['cores']} cores)"

    @property
    def short_caption(self) -> str:
        """The same without the versions, for pages that state them only once."""
        p = self.provenance
        return f"recorded on {p['date'][:10]}, {p['processor']} ({p['cores']} cores)"


def live_caption(run: Run, short: bool = False) -> str:
    """Return when and where a live run was made, in the words of a recording's caption."""
    here = describe()
    version = re.search(r"/rosversion: (\S+)", run.console)  # roslaunch says so among its parameters
    ros = f" with ROS {version[1]}" if version else " with ROS 2" if run.runtime == "ros2" else ""
    versions = "" if short else f"{ros} on {here['System']}"
    date = datetime.fromtimestamp(run.start, UTC).date()
    return f"measured on {date}{versions}, {here['Processor']} ({here['Cores']} cores)"


def load(path: str | os.PathLike[str]) -> Recording:
    """Load a recording from a ``.csv`` file (ticks) or a ``.txt`` file (console), and the ``.json`` file next to it.

    Raises OSError if a file cannot be read, and ValueError if it is not a recording.
    """
    file = Path(path)
    provenance = json.loads(file.with_suffix(".json").read_text())
    start = provenance["start"]
    if file.suffix == ".csv":
        console, ticks = "", tuple(_ticks(file))
    elif file.suffix == ".txt":
        console = file.read_text()
        ticks = read_ticks(console, start=start)
    else:
        raise ValueError(f"{file}: a recording is a .csv or a .txt file")
    runtime = provenance.get("runtime", "ros1")
    return Recording(console, ticks, provenance["status"], runtime, provenance["seconds"], start, provenance=provenance)


def _ticks(file: Path) -> Iterator[Tick]:
    with file.open(newline="") as text:
        reader = csv.DictReader(text)
        if reader.fieldnames != COLUMNS:
            raise ValueError(f"{file}: the columns must be {','.join(COLUMNS)}")
        rows = list(reader)
    # How long a tick took is in the row of the next one of its source.
    durations = {(row["source"], int(row["number"]) - 1): float(row["last_duration"] or "nan") for row in rows}
    for row in rows:
        key = row["source"], int(row["number"])
        yield Tick(*key, float(row["current_expected"]), float(row["current_real"]), durations.get(key, math.nan))
