"""Record a fixed set of runs on the real ROS 2 into examples/recordings/ros2, each with its provenance.

`make record` runs all of it, `python -m benchmarks.record_ros2 NAME...` what is named. What is timed runs alone; the
endings and signals, whose times do not matter, some at a time. What is in C++ is recorded where CMake finds rclcpp.
"""

from __future__ import annotations

import csv
import math
import os
import random
import re
import signal
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import product
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

from rosspin import Tick, simulate
from rosspin.clocks.ctrl_c import Ending
from rosspin.real import ros2
from rosspin.results.recordings import COLUMNS
from rosspin.results.saving import save_whole

from .arrivals import Arrivals
from .provenance import table, write_provenance
from .rclcpp_nodes import build, compiler, missing, read_ticks

EXAMPLES = Path(__file__).parents[1] / "examples" / "ros2"
TOPICS = Path(__file__).parents[1] / "examples" / "topics" / "ros2"
PACKAGE = Path(__file__).parents[1] / "examples/my_robotics_pkg_ros2/my_robotics_pkg"
NODE = PACKAGE / "spinner_py_node.py"
RECORDINGS = Path(__file__).parents[1] / "examples" / "recordings" / "ros2"

PERIOD = 0.5  # s, at 2 Hz
BLOCK = 1.6 * PERIOD  # of a callback that is always slow

ENDING_RUNS = 12  # of each node and signal: some are races
ENDING_AFTER = 1.2  # s
ENDS_ITSELF = ("exception", "shutdown_in_callback", "system_exit")


class Plan(NamedTuple):
    """A run of a probe, a C++ one if it has no suffix: its parameters, how long (s), and what is to be seen."""

    program: str
    parameters: dict[str, Any]
    seconds: float
    what: str


def _plans() -> Iterator[tuple[str, Plan]]:
    for kind, what in (("timer", "a timer"), ("rate", "a Rate loop")):
        program = f"{kind}_probe.py"
        yield f"{kind}_2hz", Plan(program, {"period": PERIOD}, 5.2, f"{what} at 2 Hz")
        yield f"{kind}_50hz", Plan(program, {"period": 0.02}, 10.0, f"{what} at 50 Hz")
        for periods in (1.4, 2.4, 4.4):
            parameters = {"period": PERIOD, "block": periods * PERIOD, "block_call": 3}
            seen = f"{what} at 2 Hz whose call or pass number 3 takes {periods} periods"
            yield f"{kind}_blocks_once_{periods}", Plan(program, parameters, 6.2, seen)
    always = {"period": PERIOD, "block": BLOCK}
    yield "timer_blocks_always_1.6", Plan("timer_probe.py", always, 6.2, "a timer at 2 Hz, always 1.6 periods")
    wait = {"period": PERIOD, "wait": 4.4 * PERIOD}
    yield "timer_waits", Plan("timer_probe.py", wait, 5.2, "a timer at 2 Hz in a node that spins after 4.4 periods")
    sim_time = {"period": PERIOD, "use_sim_time": True}
    yield "timer_without_clock", Plan("timer_probe.py", sim_time, 3.2, "a timer with use_sim_time and no clock")
    two: dict[str, Any] = {**always, "second_timer": True}
    what = "two timers at 2 Hz, the callback of the first always takes 1.6 periods"
    for name, words, more in (
        ("spin", "under rclpy.spin", {}),
        ("spin_once", "under rclpy.spin_once with a timeout that varies", {"executor": "spin_once"}),
        ("multi_default", "four threads, the node's default group", {"executor": "multi"}),
        ("multi_own", "four threads, a group of its own for each", {"executor": "multi", "group": "own"}),
        ("multi_reentrant", "four threads, one reentrant group", {"executor": "multi", "group": "reentrant"}),
    ):
        yield f"two_timers_{name}", Plan("timer_probe.py", {**two, **more}, 6.2, f"{what}; {words}")
    overlap = {"period": PERIOD, "block": 1.2, "executor": "multi", "group": "reentrant", "threads": 2}
    what = "a timer at 2 Hz whose callback always takes 1.2 s; two threads, a reentrant group"
    yield "timer_overlaps", Plan("timer_probe.py", overlap, 4.2, what)


def _cpp_plans() -> Iterator[tuple[str, Plan]]:
    for kind, what in (("timer", "a timer"), ("rate", "a Rate loop")):
        program = f"{kind}_probe"
        yield f"{kind}_cpp_2hz", Plan(program, {"period": PERIOD}, 5.2, f"{what} at 2 Hz")
        for periods in (1.4, 2.4, 3.4, 4.4):
            parameters = {"period": PERIOD, "block": periods * PERIOD, "block_call": 3}
            seen = f"{what} at 2 Hz whose call or pass number 3 takes {periods} periods"
            yield f"{kind}_cpp_blocks_once_{periods}", Plan(program, parameters, 6.2, seen)
        for seed in (1, 2):
            lengths: dict[str, Any] = {"period": PERIOD, "blocks": random_blocks(program, seed, 20)}
            seen = f"{what} at 2 Hz whose calls or passes take random times"
            yield f"{kind}_cpp_blocks_random_{seed}", Plan(program, lengths, 20.2, seen)
    works = {"period": PERIOD, "blocks": [0.2, 0.2, 1.7], "block": 0.2}
    what = "a Rate loop at 2 Hz whose passes take 0.2 s, and number 3 takes 3.4 periods"
    yield "rate_cpp_works", Plan("rate_probe", works, 5.6, what)  # while it sleeps: see endings_cpp
    once: dict[str, Any] = {"period": PERIOD, "block": 3.4 * PERIOD, "block_call": 3}
    what = "a timer at 2 Hz whose call number 3 takes 3.4 periods"
    yield "timer_cpp_wall", Plan("timer_probe", {**once, "wall": True}, 6.2, f"{what}; made by create_wall_timer")
    yield "timer_cpp_multi", Plan("timer_probe", {**once, "executor": "multi"}, 6.2, f"{what}; four threads")
    wait = {"period": PERIOD, "wait": 4.4 * PERIOD}
    yield "timer_cpp_waits", Plan("timer_probe", wait, 5.2, "a timer at 2 Hz in a node that spins after 4.4 periods")
    for name, wall in (("timer_cpp_without_clock", False), ("timer_cpp_wall_without_clock", True)):
        parameters = {"period": PERIOD, "use_sim_time": True, "wall": wall}
        what = f"a timer of create_{'wall_' * wall}timer with use_sim_time and no clock"
        yield name, Plan("timer_probe", parameters, 3.2, what)
    two: dict[str, Any] = {"period": PERIOD, "block": BLOCK, "second_timer": True}
    turns = {**two, "second_period": 0.7, "second_block": BLOCK}
    what = "two timers at 2 Hz, the callback of the first always takes 1.6 periods"
    both = f"timers of 0.5 and 0.7 s, both callbacks always take {BLOCK} s"
    for name, words, more in (
        ("spin", "one thread", {}),
        ("multi_default", "four threads, the node's default group", {"executor": "multi"}),
        ("multi_own", "four threads, a group of its own for each", {"executor": "multi", "group": "own"}),
        ("multi_reentrant", "four threads, one reentrant group", {"executor": "multi", "group": "reentrant"}),
    ):
        yield f"two_timers_cpp_{name}", Plan("timer_probe", {**two, **more}, 6.2, f"{what}; {words}")
        yield f"slow_timers_cpp_{name}", Plan("timer_probe", {**turns, **more}, 6.2, f"{both}; {words}")


def random_blocks(program: str, seed: int, count: int) -> list[float]:
    """How long (s) the calls or passes of a C++ probe at 2 Hz take: drawn so that a little lateness changes little.

    A call may take a fifth of the period more or less, and what follows is as much earlier or later.
    """
    draw = random.Random(seed)
    lengths: list[float] = []

    def following(length: float) -> list[float]:
        args = ["-p", f"period:={PERIOD}", "-p", f"blocks:=[{','.join(map(str, [*lengths, length]))}]"]
        run = simulate(EXAMPLES / f"{program}.cpp", 5 * PERIOD * (count + 1), ["--ros-args", *args])
        return [tick.real for tick in run.ticks][: len(lengths) + 4]

    while len(lengths) < count:
        length = round(draw.uniform(0.25, 4.5) * PERIOD, 2)
        times = zip(*(following(length + more) for more in (-0.1, 0.0, 0.1)), strict=True)
        if all(max(found) - min(found) < 0.201 for found in times):
            lengths.append(length)
    return lengths


@cache
def plans() -> dict[str, Plan]:
    """What is recorded of the probes, by name. Their random lengths are drawn with runs: not while this is imported."""
    return {**dict(_plans()), **dict(_cpp_plans())}


def record_probe(name: str) -> None:
    """Run a probe and write its ticks."""
    plan = plans()[name]
    load = os.getloadavg()
    command = [plan.program, *_ros_args(plan.parameters)]
    if plan.program.endswith(".py"):
        run = ros2.launch(EXAMPLES / plan.program, plan.seconds, command[1:])
        console, ticks, status, start = run.console, run.ticks, run.status, run.start
    else:
        with ros2.Nodes() as nodes:
            output = build().run(nodes, plan.program, plan.seconds, command[1:])
        console, ticks, status, start = output.console, read_ticks(output.console), output.status, output.start
    if status:
        raise RuntimeError(f"{name} failed with status {status}:\n{console}")
    last: dict[str, Tick] = {}
    with table(RECORDINGS / f"{name}.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(COLUMNS)
        for tick in ticks:
            before = last.get(tick.source)
            past = [before.expected, before.real, before.duration] if before else [None] * 3
            times = [*past[:2], tick.expected, tick.real, past[2]]
            row = [f"{time:.6f}" if time is not None else "" for time in times]
            writer.writerow([tick.source, tick.number, *row])
            last[tick.source] = tick
    _write_provenance(name, plan.what, command, start, plan.seconds, status, load)


def _ros_args(parameters: dict[str, Any]) -> list[str]:
    texts = {key: str(value).lower() if isinstance(value, bool) else str(value) for key, value in parameters.items()}
    words = {key: text.replace(" ", "") for key, text in texts.items()}
    return ["--ros-args", *(word for key, word in words.items() for word in ("-p", f"{key}:={word}"))]


def record_endings() -> None:
    """End each node of the endings in Python."""
    with ros2.Nodes() as nodes:

        def run(file: Path, seconds: float | None, ending: Ending) -> tuple[int, float]:
            run = nodes.launch(file, seconds, ending=ending)
            return run.status, run.start

        _record_endings("endings", sorted(EXAMPLES.glob("endings/*.py")), run)


def record_endings_cpp() -> None:
    """End each node of the endings in C++."""
    with ros2.Nodes() as nodes:

        def run(file: Path, seconds: float | None, ending: Ending) -> tuple[int, float]:
            output = build().run(nodes, file.stem, seconds, ending=ending)
            return output.status, output.start

        _record_endings("endings_cpp", sorted(EXAMPLES.glob("endings/*.cpp")), run)


def _record_endings(
    name: str, files: Sequence[Path], run: Callable[[Path, float | None, Ending], tuple[int, float]]
) -> None:
    """End each node many times: how it ended, how often, and how soon after the signal; ``run`` gives status and start.

    A node that needs SIGKILL, 4 s later, hangs. A node that ends by itself gets no signal.
    """
    load, start = os.getloadavg(), time.time()
    jobs = [
        (file, number)
        for file in files
        for number in ([None] if file.stem in ENDS_ITSELF else [signal.SIGINT, signal.SIGTERM])
        for _ in range(ENDING_RUNS)
    ]
    counts: dict[tuple[str, str, int], list[float]] = defaultdict(list)

    def end(job: tuple[Path, signal.Signals | None]) -> tuple[tuple[str, str, int], float]:
        file, number = job
        ending = Ending(((number or signal.SIGINT, 4.0),))
        status, begun = run(file, ENDING_AFTER if number else None, ending)
        late = time.time() - begun - ENDING_AFTER if number else math.nan
        return (file.stem, number.name if number else "", status), late

    with ThreadPoolExecutor(4) as pool:
        for key, late in pool.map(end, jobs):
            counts[key].append(late)
    with table(RECORDINGS / f"{name}.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["node", "signal", "status", "runs", "seconds_after_signal"])
        for key, times in counts.items():
            writer.writerow([*key, len(times), f"{median(times):.2f}" if key[1] else ""])
    _write_provenance(name, "nodes at Ctrl-C and SIGTERM", ["NODE"], start, ENDING_AFTER, 0, load)


SIGNALLED = EXAMPLES / "signalled.py"
SIGNAL_RUNS = 200  # at each moment, of each signal

# When a signal comes: after which line of that node, and how long (s) after it.
MOMENTS = {"between callbacks": ("ended", 0.15), "during a callback": ("begun", 0.1), "at its end": ("ended", 0.0)}


def record_signals() -> None:
    """Send signals at some moments, many times: the status of the node, and its error if it ends with one."""
    load, start = os.getloadavg(), time.time()
    jobs = [
        (moment, number) for moment in MOMENTS for number in (signal.SIGINT, signal.SIGTERM) for _ in range(SIGNAL_RUNS)
    ]
    with ros2.Nodes() as nodes, ThreadPoolExecutor(4) as pool:

        def end(job: tuple[str, signal.Signals]) -> tuple[str, str, int, str]:
            moment, number = job
            line, after = MOMENTS[moment]
            ending = Ending(((number, 4.0),))
            run = nodes.run([ros2.python(), str(SIGNALLED)], after, begins=re.compile(line), ending=ending)
            error = re.search(r"^\S*\b(\w+Error: \w+(?: \w+)*).*\n\Z", run.console, re.MULTILINE)
            return moment, number.name, run.status, error[1] if error else ""

        counts = Counter(pool.map(end, jobs))
    with table(RECORDINGS / "signals.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["moment", "signal", "status", "error", "runs"])
        writer.writerows([*key, runs] for key, runs in counts.items())
    what = "a node that ends as the tutorial's does, at Ctrl-C and SIGTERM at some moments"
    _write_provenance("signals", what, [SIGNALLED.name], start, 0.0, 0, load)


# What nodes say of themselves, where ticks do not tell it: the node, its parameters, how long it runs (s).
CLAIMS: dict[str, tuple[str, dict[str, Any], float]] = {
    "rate_in_main": ("rate", {"where": "main"}, 3.0),
    "rate_in_callback": ("rate", {"where": "callback"}, 3.0),
    "rate_in_callback_multi": ("rate", {"where": "callback", "threads": 4}, 3.0),
    "exception": ("exception", {}, 3.0),
    "exception_multi": ("exception", {"threads": 4}, 3.0),
    "one_shot": ("timers", {}, 3.0),
    "unspun": ("timers", {"kind": "unspun"}, 3.0),
    "no_clock": ("timers", {"kind": "period", "use_sim_time": True}, 3.0),
    "period_zero": ("timers", {"kind": "period", "period": 0.0}, 1.0),
    "period_negative": ("timers", {"kind": "period", "period": -1.0}, 1.0),
    "hook_at_ctrl_c": ("hooks", {}, 2.0),
    "hook_at_shutdown": ("hooks", {"shutdown": True}, 2.0),
}


def record_claims() -> None:
    """Let nodes say what happens to them, and when (s after they were made); keep it with their status.

    All that one puts on its console is kept of a node that ends well: it may be that a warning is missing.
    """
    load, start = os.getloadavg(), time.time()
    with table(RECORDINGS / "claims.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["run", "command", "ended_after", "status", "seconds", "what"])
        for name, (node, parameters, seconds) in CLAIMS.items():
            command = [f"claims/{node}.py", *_ros_args(parameters)]
            run = ros2.launch(EXAMPLES / command[0], seconds, command[1:])
            for line in run.console.splitlines():
                _, at, what = line.split(",", 2) if line.startswith("said,") else ("", "", line)
                if at or not run.status:
                    writer.writerow([name, " ".join(command), seconds, run.status, at, what])
    _write_provenance("claims", "nodes that say what happens to them", ["NODE"], start, 3.0, 0, load)


def record_pipe() -> None:
    """Let the tutorial's node print into a pipe."""
    load, start = os.getloadavg(), time.time()
    arrivals = Arrivals()
    run = ros2.launch(NODE, 3.2, (), arrivals)
    with table(RECORDINGS / "pipe.csv") as text:
        csv.writer(text, lineterminator="\n").writerows([["seconds_late"], [f"{arrivals.delay or 0:.2f}"]])
    _write_provenance("pipe", "INFO lines through a pipe", [NODE.name], start, 3.2, run.status, load)


def record_spinner() -> None:
    """Keep the console of the tutorial's node."""
    load = os.getloadavg()
    command = [NODE.name, "--ros-args", "-r", "__ns:=/mrp"]
    run = ros2.launch(NODE, 2.2, command[1:])
    save_whole(RECORDINGS / "spinner.txt", run.console.encode())
    _write_provenance("spinner", "the tutorial's node", command, run.start, run.seconds, run.status, load)


def record_spinner_cpp() -> None:
    """Keep the console of the tutorial's C++ node."""
    load = os.getloadavg()
    command = ["spinner_cpp_node", "--ros-args", "-r", "__ns:=/mrp"]
    with ros2.Nodes() as nodes:
        output = build().run(nodes, command[0], 2.2, command[1:])
    save_whole(RECORDINGS / "spinner_cpp.txt", output.console.encode())
    _write_provenance("spinner_cpp", "the tutorial's C++ node", command, output.start, 2.2, output.status, load)


def record_clock_jump() -> None:
    """Let ROS time jump under a timer of 1 s, and keep the times at which it ticks."""
    load = os.getloadavg()
    run = ros2.launch(EXAMPLES / "clock_jump.py", 5.0)
    rows = [line.split(",") for line in run.console.splitlines() if line.startswith("ros_time,")]
    with table(RECORDINGS / "clock_jump.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["ros_time"])
        writer.writerows([time] for _, time in rows)
    what = "a timer when /clock jumps from 0 to 100, and back to 50"
    _write_provenance("clock_jump", what, ["clock_jump.py"], run.start, 5.0, run.status, load)


FIRST_RUNS = 20  # in which the first message may be lost


class Talk(NamedTuple):
    """Two nodes in two processes: who speaks and who listens, with their parameters; how long they run (s).

    The listener is there ``before`` (s) the other one starts. Without one, the talker is alone. Recorded so many
    ``times``.
    """

    talker: tuple[str, dict[str, Any]]
    listener: tuple[str, dict[str, Any]] | None
    seconds: float
    before: float = 0.0
    times: int = 1


def _talks() -> Iterator[tuple[str, Talk]]:
    policies = {"durability": ("VOLATILE", "TRANSIENT_LOCAL"), "reliability": ("RELIABLE", "BEST_EFFORT")}
    for name, values in policies.items():
        for offered, requested in product(values, values):
            yield f"late {offered} {requested}", Talk(("eager", {name: offered}), ("late", {name: requested}), 5.2)
    for durability in policies["durability"]:
        policy: dict[str, Any] = {"durability": durability}
        yield f"first {durability}", Talk(("eager", policy), ("late", {**policy, "late": 0.01}), 4.2, 2.0, FIRST_RUNS)
    for depth, seconds in ((1, 9.0), (3, 11.0), (10, 16.0), (100, 29.0)):
        yield f"depth {depth}", Talk(("thirty", {}), ("slow", {"depth": depth}), seconds)
    yield "asks", Talk(("eager", {}), ("asking", {}), 6.2)
    yield "begins", Talk(("eager", {}), ("begin", {}), 4.2)
    yield "whole", Talk(("whole", {}), None, 2.2)


TALKS = dict(_talks())

LOGGED = re.compile(r"\[\w+\] \[([\d.]+)\] \[(\w+)\]: (.*)")


def record_topics() -> None:
    """Let two nodes talk, and keep what each of them logs, and when (s after the talker was there)."""
    load, start = os.getloadavg(), time.time()
    with table(RECORDINGS / "topics.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["run", "number", "node", "seconds", "what"])
        for name, talk in TALKS.items():
            for number in range(1, talk.times + 1):
                writer.writerows([name, number, *row] for row in _converse(talk))
    _write_provenance("topics", "a publisher and a subscriber in two processes", ["NODE"], start, 5.2, 0, load)


def _converse(talk: Talk) -> list[tuple[str, str, str]]:
    with ros2.Nodes(meet=True) as nodes, ThreadPoolExecutor(2) as pool:

        def launch(node: tuple[str, dict[str, Any]], seconds: float) -> Any:
            name, parameters = node
            return nodes.launch(TOPICS / f"{name}_py_node.py", seconds, _ros_args(parameters))

        listeners = [pool.submit(launch, node, talk.before + talk.seconds) for node in filter(None, [talk.listener])]
        time.sleep(talk.before)
        talker = launch(talk.talker, talk.seconds)
        runs = [talker, *(listener.result() for listener in listeners)]
    logged = [found for run in runs for found in LOGGED.findall(run.console)]
    return [(node, f"{float(at) - talker.start:.3f}", what) for at, node, what in sorted(logged)]


def record_publish() -> None:
    """Keep the consoles of the tutorial's publisher and subscriber, each in a terminal of its own."""
    load = os.getloadavg()
    args = ["--ros-args", "-r", "__ns:=/mrp"]
    with ros2.Nodes(meet=True) as nodes, ThreadPoolExecutor(2) as pool:
        files = [PACKAGE / f"{name}_py_node.py" for name in ("publisher", "subscriber")]
        publisher, subscriber = pool.map(lambda file: nodes.launch(file, 4.7, args), files)
    save_whole(RECORDINGS / "publish.txt", (publisher.console + subscriber.console).encode())
    command = ["subscriber_py_node.py", *args]
    status = max(publisher.status, subscriber.status)
    what = "the tutorial's publisher and subscriber"
    _write_provenance("publish", what, command, subscriber.start, subscriber.seconds, status, load)


def record_publish_cpp() -> None:
    """Keep the consoles of the same nodes in C++."""
    load = os.getloadavg()
    args = ["--ros-args", "-r", "__ns:=/mrp"]
    programs, names = build(), ("publisher_cpp_node", "subscriber_cpp_node")
    with ros2.Nodes(meet=True) as nodes, ThreadPoolExecutor(2) as pool:
        publisher, subscriber = pool.map(lambda name: programs.run(nodes, name, 4.7, args), names)
    save_whole(RECORDINGS / "publish_cpp.txt", (publisher.console + subscriber.console).encode())
    status = max(publisher.status, subscriber.status)
    what = "the tutorial's publisher and subscriber in C++"
    _write_provenance("publish_cpp", what, [names[1], *args], subscriber.start, 4.7, status, load)


def _write_provenance(
    name: str, what: str, command: list[str], start: float, seconds: float, status: int, load: tuple[float, ...]
) -> None:
    versions = {"ros": f"2 {ros2.version()}", "runtime": "ros2"}
    if "_cpp" in name:
        versions |= {"ros": f"2 {build().version}", "compiler": compiler()}
    else:
        versions["python"] = ".".join(map(str, sys.version_info[:3]))  # `make ros2` and the rest are of one Python
        command = ["python3", *command]
    write_provenance(RECORDINGS / f"{name}.json", what, command, start, seconds, status, load, versions)


OTHERS = {
    "claims": record_claims,
    "clock_jump": record_clock_jump,
    "endings": record_endings,
    "endings_cpp": record_endings_cpp,
    "pipe": record_pipe,
    "publish": record_publish,
    "publish_cpp": record_publish_cpp,
    "signals": record_signals,
    "spinner": record_spinner,
    "spinner_cpp": record_spinner_cpp,
    "topics": record_topics,
}


def main(names: list[str]) -> None:
    """Record what is named; if nothing is, all that can be."""
    if ros2.missing():
        raise SystemExit(f"record: {ros2.Ros2Missing()}")
    known = [*OTHERS, *plans()]
    if unknown := set(names) - {*known}:
        raise SystemExit(f"record: there is no {', '.join(sorted(unknown))}; there are {', '.join(known)}")
    RECORDINGS.mkdir(exist_ok=True)
    for name in names or [*plans(), *OTHERS]:
        if "_cpp" in name and missing():
            print(f"{name}: left as it is. {missing()}", flush=True)
            continue
        print(name, flush=True)
        if name in OTHERS:
            OTHERS[name]()
        else:
            record_probe(name)


if __name__ == "__main__":
    main(sys.argv[1:])
