"""Threads and locks in simulated time: a lock beside a real one, ten thousand threads beside a hundred."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from statistics import median

from rosspin import simulate

from .ratios import by_turns, line, ratio


def report(pairs: int = 200_000, few: int = 100, many: int = 10_000, rounds: int = 7) -> Iterator[str]:
    """The lines of the report: so many acquired and released locks, and threads few and many in one run."""
    yield "Processor time of simulated threads and locks"
    times = by_turns(
        rounds, time.process_time, {"real": lambda: use_lock(pairs), "simulated": lambda: use_simulated_lock(pairs)}
    )
    each = {name: f"{median(taken) / pairs * 1e9:.0f} ns" for name, taken in times.items()}
    yield line(
        "  a lock that no one else wants, acquired and released, simulated / real",
        ratio(times, "simulated", "real"),
        most=10,
        times=f"{each['simulated']} / {each['real']}",
    )
    # As many threads in all on either side.
    runs = many // few
    times = by_turns(
        rounds,
        time.process_time,
        {"few": lambda: start_threads(few, runs), "many": lambda: start_threads(runs * few)},
    )
    each = {name: f"{median(taken) / (runs * few) * 1e6:.0f} µs" for name, taken in times.items()}
    yield line(
        f"  a thread that sleeps once, {many:,} in one run / {few:,}",
        ratio(times, "many", "few"),
        most=2,
        times=f"{each['many']} / {each['few']}",
    )


def use_lock(pairs: int) -> None:
    """Acquire and release a lock so many times."""
    lock = threading.Lock()
    for _ in range(pairs):
        lock.acquire()
        lock.release()


def use_simulated_lock(pairs: int) -> None:
    """The same in a node in simulated time."""
    if simulate(lambda: use_lock(pairs), 1.0).status:
        raise AssertionError("the node failed")


def start_threads(number: int, runs: int = 1) -> None:
    """Run a simulated node, so many times, that starts so many threads, each of which sleeps, and joins them."""
    ended = []

    def sleep() -> None:
        time.sleep(1.0)
        ended.append(time.time())

    def node() -> None:
        threads = [threading.Thread(target=sleep) for _ in range(number)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    for _ in range(runs):
        ended.clear()
        run = simulate(node, 2.0)
        if run.status or ended != [1.0] * number:
            raise AssertionError(f"not {number} threads that ended at 1 s: {run.console[-200:]}")
