"""The stand-in beside the real ROS 1, measured in one run: lateness, processor time, and the scenarios' time."""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from rosspin import simulate
from rosspin.measures import quantile, say_time
from rosspin.real import ros1

from .ratios import line

ROOT = Path(__file__).parents[1]
PROBES = ROOT / "examples" / "timing_probes"

# Some of the scenarios that hold the stand-in to rospy, with their node args.
SCENARIOS = (
    ("timer_blocked_once.py", "_block:=2.4"),
    ("rate_blocked.py", "_block:=2.4", "_pass:=2"),
    ("several_timers_blocked.py",),
    ("timer_in_timer.py",),
)

# So many timers at 100 Hz; prints the processor time of two seconds and the callbacks in them.
_LOAD = """
import sys, time, rospy
rospy.init_node("load_%d" % {timers})
calls = []
timers = [rospy.Timer(rospy.Duration(0.01), calls.append) for _ in range({timers})]
rospy.sleep(0.5)
before, called = time.process_time(), len(calls)
rospy.sleep(2.0)
print("cost %.9f %d" % (time.process_time() - before, len(calls) - called), flush=True)
rospy.signal_shutdown("")
"""


def report(
    turns: Sequence[tuple[int, float]] = ((2, 5.0), (50, 2.0), (500, 1.0)),
    rounds: int = 2,
    loads: Sequence[int] = (1, 10, 100),
    scenarios: Sequence[Sequence[str]] = SCENARIOS,
) -> Iterator[str]:
    """The lines of the report; where ROS 1 is lacking, one line that says so."""
    yield "Beside the real ROS 1"
    if lacking := ros1.missing():
        yield f"  not measured: {ros1.Ros1Missing(lacking)}"
        return
    with ros1.Workspace() as workspace:
        workspace.add_package(PROBES)
        workspace.build("-DCMAKE_BUILD_TYPE=Release")
        workspace.start_master()
        for hertz, seconds in turns:
            yield from _lateness(workspace, hertz, seconds, rounds)
        for timers in loads:
            yield _cost(workspace, timers)
        yield _scenarios(workspace, scenarios)


def _lateness(workspace: ros1.Workspace, hertz: int, seconds: float, rounds: int) -> Iterator[str]:
    for probe in ("timer", "rate"):
        programs = {
            "stand-in": [sys.executable, "-m", "rosspin", "run", str(PROBES / "src" / f"{probe}_probe.py"), "--"],
            "rospy": ["python3", str(PROBES / "src" / f"{probe}_probe.py")],
            "roscpp": [str(workspace.folder / "devel/lib/timing_probes" / f"{probe}_probe")],
        }
        late: dict[str, list[float]] = {name: [] for name in programs}
        for turn in range(rounds):
            for name, command in programs.items():
                args = [f"_period:={1 / hertz}", f"__name:={probe}_{name.replace('-', '_')}_{hertz}_{turn}"]
                output = workspace.run([*command, *args], seconds, begins=re.compile("^start,"))
                late[name] += _late(output.console)
        for percent in (50, 99):
            at = {name: quantile(values, percent / 100) for name, values in late.items()}
            for other in ("rospy", "roscpp"):
                yield line(
                    f"  {probe} at {hertz} Hz, p{percent}, stand-in / {other}",
                    at["stand-in"] / at[other],
                    most=1.0 if (percent, other) == (50, "rospy") else None,
                    times=f"{say_time(at['stand-in'])} / {say_time(at[other])}",
                )


def _late(console: str) -> list[float]:
    rows = [row.split(",") for row in console.splitlines() if row.count(",") == 6]
    # The first pass of a loop waits for nothing.
    return [float(row[5]) - float(row[4]) for row in rows if row[:2] != ["Rate", "1"]]


def _cost(workspace: ros1.Workspace, timers: int, rounds: int = 3) -> str:
    node = workspace.folder / f"load_{timers}.py"
    node.write_text(_LOAD.format(timers=timers))
    programs = {"stand-in": [sys.executable, "-m", "rosspin", "run", str(node)], "rospy": ["python3", str(node)]}
    cost: dict[str, list[float]] = {name: [] for name in programs}
    for _ in range(rounds):
        for name, command in programs.items():
            output = workspace.run(command, 30.0)
            seconds, calls = re.search(r"^cost (\S+) (\d+)", output.console, re.MULTILINE).groups()  # type: ignore[union-attr]
            cost[name].append(1000 * float(seconds) / int(calls))
    at = {name: quantile(values, 0.5) for name, values in cost.items()}
    return line(
        f"  CPU of 1000 callbacks, {timers} timers, stand-in / rospy",
        at["stand-in"] / at["rospy"],
        times=f"{say_time(at['stand-in'])} / {say_time(at['rospy'])}",
    )


def _scenarios(workspace: ros1.Workspace, scenarios: Sequence[Sequence[str]]) -> str:
    took = {"real": 0.0, "simulated": 0.0}
    for file, *args in scenarios:
        path = ROOT / "tests" / "scenarios" / file
        start = time.perf_counter()
        workspace.run(["python3", str(path), *args], 60.0)
        took["real"] += time.perf_counter() - start
        start = time.perf_counter()
        simulate(path, 60.0, args)
        took["simulated"] += time.perf_counter() - start
    return line(
        f"  {len(scenarios)} scenarios, real rospy / simulated",
        took["real"] / took["simulated"],
        times=f"{say_time(took['real'])} / {say_time(took['simulated'])}",
    )
