"""Exploring: what it costs beside a run in the usual order, and how soon it finds planted faults."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

from rosspin import explore, rospy
from rosspin.clocks.explored import ExploredSimulation, Order
from rosspin.clocks.simulation import Simulation
from rosspin.run.simulate import prepare, run_prepared
from rosspin.world.graph import TickLog

from .planted_orders import PLANTS
from .ratios import by_turns, line, ratio

NS = 1_000_000_000


def report(ticks: int = 20_000, rounds: int = 7, schedules: int = 1000) -> Iterator[str]:
    """The lines of the report."""
    functions: dict[str, Callable[[], object]] = {}
    for size in (1, 2, 10):
        for name, clock in (("usual", Simulation), ("explored", partial(ExploredSimulation, Order()))):
            functions[f"{name} {size}"] = partial(with_timers, clock, size, ticks // size)
    times = by_turns(rounds, time.process_time, functions)
    yield "Processor time of a simulated tick of rospy.Timer, all timers due together"
    for size in (1, 2, 10):
        usual, explored = f"usual {size}", f"explored {size}"
        yield line(
            f"  {size} timer{'s' * (size > 1)}, exploring / not",
            ratio(times, explored, usual),
            most=2,
            times=" / ".join(f"{median(times[name]) / ticks * 1e6:.2f} µs" for name in (explored, usual)),
        )
    yield f"\nPlanted faults: the first order that fails, of at most {schedules:,}, and its twin's"
    yield f"  {'':<30} {'usual':>7} {'random':>7} {'pct':>7} {'all':>7}   shortest  its twin (pct)"
    for name in PLANTS:
        yield _plant(name, schedules)


def with_timers(clock: Callable[[], Simulation], size: int, ticks: int) -> None:
    """Run a node of so many timers that are due together, for so many ticks of each."""

    def node() -> None:
        rospy.init_node("timers")
        for _ in range(size):
            rospy.Timer(rospy.Duration(0, NS // 10), lambda event: None)
        rospy.sleep(ticks / 10)

    simulation: Any = clock()
    run_prepared(prepare(node, (), skip_cpp=False, shaken=False), ticks / 10, simulation, TickLog())


def _plant(name: str, schedules: int) -> str:
    plant = PLANTS[name]
    with tempfile.TemporaryDirectory() as folder:
        planted, mended = (plant.write(Path(folder), mended=each) for each in (False, True))
        found = {
            strategy: explore(
                planted, plant.seconds, plant.check, schedules=schedules, strategy=strategy, deep=plant.deep
            )
            for strategy in ("random", "pct", "all")
        }
        usual = explore(planted, plant.seconds, plant.check, schedules=1, deep=plant.deep)
        twin = explore(mended, plant.seconds, plant.check, schedules=schedules, deep=plant.deep)
    numbers = [usual, *found.values()]
    shown = " ".join(f"{each.schedules if each.failure else '-':>7}" for each in numbers)
    deviations = min(each.token.count(".") for each in found.values() if each.failure)
    said = f"FAILS: {twin.token}" if twin.failure else f"{twin.schedules:,} well"
    return f"  {name:<30} {shown} {deviations:>10}  {said}"
