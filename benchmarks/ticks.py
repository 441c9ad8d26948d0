"""Simulated ticks beside SimPy doing the same events: 1, 100 and 1000 timers of about half a second."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterator, Sequence
from functools import partial
from statistics import median

import simpy

from rosspin import rospy, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.clocks.stacks import Program

from .ratios import by_turns, line, ratio

NS = 1_000_000_000


def report(sizes: Sequence[int] = (1, 100, 1000), ticks: int = 200_000, rounds: int = 7) -> Iterator[str]:
    """The lines of the report; each measurement makes ``ticks`` ticks."""
    functions: dict[str, Callable[[], object]] = {}
    for size in sizes:
        for name, runtime in (("SimPy", in_simpy), ("clock", on_the_clock), ("Timer", with_timers)):
            functions[f"{name} {size}"] = partial(runtime, _periods(size), ticks // size)
    # The processor's time: on a busy machine the clock's includes that of others.
    times = by_turns(rounds, time.process_time, functions)

    def each(name: str) -> str:
        return f"{median(times[name]) / ticks * 1e6:.2f} µs"

    yield "Processor time of a simulated tick"
    for size in sizes:
        timers = f"{size} timer{'s' * (size > 1)}"
        simpys = f"SimPy {size}"
        clock, timer = f"clock {size}", f"Timer {size}"
        yield line(
            f"  {timers}, the bare clock / SimPy",
            ratio(times, clock, simpys),
            most=1,
            times=f"{each(clock)} / {each(simpys)}",
        )
        yield line(
            f"  {timers}, rospy.Timer with an empty callback / SimPy",
            ratio(times, timer, simpys),
            most=4,
            times=f"{each(timer)} / {each(simpys)}",
        )
    few, many = f"Timer {sizes[0]}", f"Timer {sizes[-1]}"
    yield line(
        f"  rospy.Timer, {sizes[-1]} timers / {sizes[0]}",
        ratio(times, many, few),
        most=3,
        times=f"{each(many)} / {each(few)}",
    )


def _periods(size: int) -> list[int]:
    """In ns; no two timers are due together."""
    return [NS // 2 + 1000 * number for number in range(size)]


def in_simpy(periods: Sequence[int], ticks: int) -> int:
    """Let a process tick ``ticks`` times for each period (ns), in SimPy; how many ticks that were in all."""
    environment = simpy.Environment()
    count = 0

    def process(period: int) -> Generator[simpy.Event]:
        nonlocal count
        for _ in range(ticks):
            yield environment.timeout(period)
            count += 1

    for period in periods:
        environment.process(process(period))
    environment.run()
    return count


def on_the_clock(periods: Sequence[int], ticks: int) -> int:
    """The same in stacks on rosspin's own simulated clock."""
    simulation, program = Simulation(), Program()
    count = 0

    def stack(period: int) -> None:
        nonlocal count
        for _ in range(ticks):
            simulation.sleep(period)
            count += 1

    def main() -> None:
        for period in periods:
            simulation.start(partial(stack, period), program, "")
        simulation.sleep(max(periods) * ticks + 1)

    simulation.run(main, program, 0)
    return count


def with_timers(periods: Sequence[int], ticks: int) -> int:
    """The same with rospy's timers in a node, and the Run that tells of each tick."""
    seconds = max(periods) * ticks / NS

    def node() -> None:
        rospy.init_node("timers")
        for period in periods:
            rospy.Timer(rospy.Duration(0, period), lambda event: None)
        rospy.sleep(seconds)  # spin would look at the clock every half second: events that the others do not have

    return len(simulate(node, seconds).ticks)
