"""The timers of the real roscpp tick as the stand-in's do."""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor

from benchmarks.record import PERIOD, random_blocks
from rosspin import Tick, simulate
from rosspin.real.ros1 import Workspace
from tests.helpers.cpp_nodes import CppNodes
from tests.helpers.cpp_probes import LATE, differences
from tests.helpers.seeds import SEED
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

PROBE = ROOT / "examples/timing_probes/src/timer_probe.cpp"


def test_the_real_roscpp_ticks_as_the_stand_in(cpp_nodes: CppNodes) -> None:
    """Over lengths drawn each time, with one timer and with two."""
    seconds = 12.0
    seeds = range(SEED, SEED + 4)
    words = {seed: [f"_period:={PERIOD}", f"_blocks:={','.join(map(str, random_blocks(seed, 20)))}"] for seed in seeds}
    words = {seed: args + ["_second_timer:=true"] * (seed % 2) for seed, args in words.items()}
    simulated = {seed: simulate(PROBE, seconds, args).ticks for seed, args in words.items()}
    with Workspace() as workspace:
        workspace.start_master()
        program = cpp_nodes.program("timer_probe")

        def compare(seed: int) -> list[str]:
            command = [program, *words[seed], f"__name:=probe_{seed}"]
            lines = workspace.run(command, seconds, begins=re.compile("^start,")).console.splitlines()
            start = next(float(line.partition(",")[2]) for line in lines if line.startswith("start,"))
            rows = [line.split(",") for line in lines if "Callback," in line]
            real = [Tick(row[0], int(row[1]), float(row[4]) - start, float(row[5]) - start, 0.0) for row in rows]
            return differences(simulated[seed], real)

        with control(bears=LATE / 2), ThreadPoolExecutor() as pool:
            assert list(pool.map(compare, seeds)) == [[], [], [], []]
