"""What a run on a real ROS may leave behind."""

from __future__ import annotations

import os
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


def shared_memory() -> set[str]:
    """What Fast DDS has left; nodes of other tests that are still running have some, too."""
    left = {name for name in os.listdir("/dev/shm") if "fast" in name}
    for entry in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            used = (entry / "maps").read_text() + " ".join(os.readlink(file) for file in (entry / "fd").iterdir())
            left -= {name for name in left if f"/dev/shm/{name}" in used}
    return left
