"""A simulated day of the tutorial's timer node with its console: against real time, and what it leaves in memory."""

from __future__ import annotations

import gc
import time
import tracemalloc
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from statistics import median

from rosspin import Run, simulate

from .ratios import by_turns, line

NODE = Path(__file__).parent.parent / "examples" / "my_robotics_pkg" / "src" / "spinner_py_node.py"
PERIOD = 0.5


def report(hours: float = 24, rounds: int = 3) -> Iterator[str]:
    """The lines of the report."""
    seconds = hours * 3600
    count = round(seconds / PERIOD)
    took = median(by_turns(rounds, time.perf_counter, {"day": lambda: spin(seconds)})["day"])
    yield f"{hours:g} simulated hours of the timer node, {count:,} counters on its console"
    yield line("  simulated / real time", seconds / took, least=20_000, times=f"{took:.2f} s")
    held, left = memory(seconds)
    yield line(
        "  memory left when its Run is dropped / held by the Run",
        left / held,
        most=0.01,
        times=f"{left / 1e3:.0f} kB / {held / 1e6:.1f} MB",
    )


def spin(seconds: float) -> Run:
    """Run the node, and see to it that no counter is missing, that of the end included."""
    run = simulate(NODE, seconds)
    count = round(seconds / PERIOD)
    last = f"[INFO] [{seconds:.6f}]: [SPINNER PY NODE] counter = {count}\n"
    if not (run.console.endswith(last) and run.console.count("counter = ") == len(run.ticks) == count):
        raise AssertionError(f"not {count} counters: {run.console[-200:]}")
    return run


def memory(seconds: float) -> tuple[int, int]:
    """The bytes by which memory has grown after a run: while its Run is held, and when it is dropped.

    In a process of its own: what others have left in this one, and what it says as it goes, is not the run's.
    """
    with ProcessPoolExecutor(1, get_context("spawn")) as alone:
        return alone.submit(_memory, seconds).result()


def _memory(seconds: float) -> tuple[int, int]:
    tracemalloc.start()
    spin(PERIOD)  # what the first run ever sets up is no growth
    before = _traced()
    run = spin(seconds)
    held = _traced() - before
    del run
    return held, _traced() - before


def _traced() -> int:
    gc.collect()
    return tracemalloc.get_traced_memory()[0]
