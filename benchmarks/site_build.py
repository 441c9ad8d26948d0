"""The build of the whole site, from nothing, against the time that its notebooks take to execute."""

from __future__ import annotations

import pickle
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from .ratios import line

ROOT = Path(__file__).parent.parent


def report() -> Iterator[str]:
    """The lines of the report."""
    with tempfile.TemporaryDirectory() as folder:
        took = build(ROOT, Path(folder))
        executed = execution_times(Path(folder))
    notebooks = sum(executed.values())
    yield f"The whole site, {len(executed)} notebooks"
    yield line(
        "  build / execution of the notebooks", took / notebooks, most=3, times=f"{took:.1f} s / {notebooks:.1f} s"
    )


def build(source: Path, folder: Path) -> float:
    """Build the site in ``source`` into an empty folder, as ``make html`` does; the seconds that it took."""
    start = time.perf_counter()
    subprocess.run([sys.executable, "-m", "sphinx", "-M", "html", source, folder, "-q"], check=True)
    return time.perf_counter() - start


def execution_times(folder: Path) -> dict[str, float]:
    """The seconds that each notebook of a built site took to execute, as myst-nb found them."""
    environment = pickle.loads((folder / "doctrees" / "environment.pickle").read_bytes())
    found = {name: data.get("exec_data") for name, data in environment.nb_metadata.items()}
    return {name: data["runtime"] for name, data in found.items() if data}
