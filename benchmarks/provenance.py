"""What is kept beside a recording: what ran, where and when, with which versions, on how busy a machine."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rosspin.results.machine import describe

__all__ = ["write_provenance"]


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
    file.write_text(json.dumps(provenance, indent=2) + "\n")
