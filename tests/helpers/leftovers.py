"""What a run on a real ROS may leave behind."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path


def processes(folder: Path) -> list[str]:
    """Processes that were started in a scratch folder below this one."""
    mark, found = f"ROS_HOME={folder}/rosspin-".encode(), []
    for entry in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            if mark in (entry / "environ").read_bytes():
                found.append((entry / "cmdline").read_text())
    return found
