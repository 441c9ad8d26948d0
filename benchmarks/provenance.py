"""What is kept beside a recording: what ran, where and when, with which versions, on how busy a machine."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, TextIO

from rosspin.results.machine import describe
from rosspin.results.saving import save_whole

__all__ = ["table", "write_provenance"]


@contextmanager
def table(file: Path) -> Iterator[TextIO]:
    """A table to write, which takes its place when it is complete."""
    text = io.StringIO(newline="")
    yield text
    save_whole(file, text.getvalue().encode())


def write_provenance(
    file: Path,
    what: str,
    command: list[str],
    start: float,
    seconds: float,
    status: int,
    load: tuple[float, ...],
    versions: dict[str, str],
) -> None:
    """Write it to a ``.json`` file. The machine is described by what it is, not by whose it is."""
    here = describe()
    provenance: dict[str, Any] = {
        "what": what,
        "command": " ".join(command),
        "seconds": seconds,
        "status": status,
        "start": start,
        "date": datetime.fromtimestamp(start, UTC).isoformat(timespec="seconds"),
        **versions,
        "system": here["System"],
        "processor": here["Processor"],
        "cores": here["Cores"],
        "load_before": [round(value, 2) for value in load],
    }
    save_whole(file, (json.dumps(provenance, indent=2) + "\n").encode())
