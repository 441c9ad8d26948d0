"""What a page needs to run a launch file: the file, the nodes that it starts, and what says where they are."""

from __future__ import annotations

from pathlib import Path

from ..clocks.simulation import Simulation
from ..run.simulate import run_nodes, several
from ..run.streams import capture

__all__ = ["launched"]

# What says of a package how its nodes are found.
_OF_PACKAGE = ("package.xml", "setup.py", "setup.cfg", "CMakeLists.txt")


def launched(launch: Path) -> tuple[str, list[str], Path]:
    """Return a launch file and all files that a run of it needs, by their paths below the folder of its package."""
    nodes = several(str(launch))
    assert nodes
    with capture():
        processes = run_nodes(nodes, 0.0, Simulation()).host.processes
    files = [launch, *(Path(process.node.filename) for process in processes)]
    packages = [next(folder for folder in file.parents if (folder / "package.xml").is_file()) for file in files]
    around = packages[0].parent
    files += [file.with_name("__init__.py") for file in files]
    files += [package / name for package in packages for name in _OF_PACKAGE]
    names = dict.fromkeys(file.relative_to(around).as_posix() for file in files if file.is_file())
    return next(iter(names)), list(names), around
