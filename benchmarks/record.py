"""Record a fixed set of runs on the real ROS 1 into examples/recordings, each with its provenance.

`make record` runs all of it, `python -m benchmarks.record NAME...` what is named. One run at a time, so that they do
not disturb each other; what else the machine is doing is on record as its load.
"""

from __future__ import annotations

import csv
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

from rosspin import simulate
from rosspin.real import ros1
from rosspin.results.recordings import COLUMNS
from rosspin.results.saving import save_whole

from .arrivals import Arrivals
from .provenance import table, write_provenance

EXAMPLES = Path(__file__).parents[1] / "examples"
RECORDINGS = EXAMPLES / "recordings"
PROBES = EXAMPLES / "timing_probes"
PACKAGE = EXAMPLES / "my_robotics_pkg"
TOPICS = EXAMPLES / "topics"

PERIOD = 0.5  # s, at 2 Hz


class Plan(NamedTuple):
    """A run of a probe: its program, its parameters, how long (s), and what is to be seen."""

    program: str
    parameters: dict[str, Any]
    seconds: float
    what: str


def _plans() -> Iterator[tuple[str, Plan]]:
    for language, suffix in (("cpp", ""), ("py", ".py")):
        timer, rate = f"timer_probe{suffix}", f"rate_probe{suffix}"
        yield f"timer_{language}_2hz", Plan(timer, {"period": PERIOD}, 5.2, "a timer at 2 Hz")
        yield f"rate_{language}_2hz", Plan(rate, {"period": PERIOD}, 5.2, "a Rate loop at 2 Hz")
        yield f"timer_{language}_50hz", Plan(timer, {"period": 0.02}, 10.0, "a timer at 50 Hz")
        yield f"rate_{language}_50hz", Plan(rate, {"period": 0.02}, 10.0, "a Rate loop at 50 Hz")
        for periods in (1.4, 2.4, 4.4):
            parameters = {"period": PERIOD, "block": periods * PERIOD, "block_call": 3}
            what = f"a timer at 2 Hz whose callback number 3 takes {periods} periods"
            yield f"timer_{language}_blocks_once_{periods}", Plan(timer, parameters, 6.2, what)
        kept = {"cpp": 1.8, "py": 2.8}[language]  # periods that a call may take if it began on time
        parameters = {"period": PERIOD, "block": kept * PERIOD, "block_call": 3}
        for calls, words in ((1, "once"), (2, "twice")):
            what = f"a timer at 2 Hz, {kept} periods in callback number 3" + (" and in number 4" if calls == 2 else "")
            name = f"timer_{language}_blocks_{words}_{kept}"
            yield name, Plan(timer, {**parameters, "block_calls": calls}, 6.2, what)
        what = "a timer at 2 Hz in a node that spins only after 4.4 periods"
        yield f"timer_{language}_waits", Plan(timer, {"period": PERIOD, "wait": 4.4 * PERIOD}, 5.2, what)
        parameters = {"period": PERIOD, "block": 1.6 * PERIOD}
        what = "a timer at 2 Hz whose callback always takes 1.6 periods"
        yield f"timer_{language}_blocks_always_1.6", Plan(timer, parameters, 6.2, what)
    parameters = {**parameters, "second_timer": True}
    what = "two timers at 2 Hz, the callback of the first always takes 1.6 periods"
    yield "two_timers_py", Plan("timer_probe.py", parameters, 6.2, f"{what}; rospy has a thread for each")
    yield "two_timers_cpp_spin", Plan("timer_probe", parameters, 6.2, f"{what}; under ros::spin")
    parameters = {**parameters, "threads": 2}
    yield "two_timers_cpp_async", Plan("timer_probe", parameters, 6.2, f"{what}; under AsyncSpinner(2)")

    for seed in (1, 2, 3):
        what = "a timer at 2 Hz whose callbacks take random times"
        lengths = ",".join(map(str, random_blocks(seed, 30)))
        yield f"timer_cpp_blocks_random_{seed}", Plan("timer_probe", {"period": PERIOD, "blocks": lengths}, 30.2, what)


def random_blocks(seed: int, count: int) -> list[float]:
    """How long (s) the calls of a timer at 2 Hz take: drawn so that a little lateness does not change their order.

    roscpp decides after each call whether the time of the next one but one has passed. It never has by a hair.
    """
    draw = random.Random(seed)
    lengths: list[float] = []
    while len(lengths) < count:
        length = draw.choice((0.0, round(draw.uniform(0.0, 4.5) * PERIOD, 2)))
        words = [f"_blocks:={','.join(map(str, lengths))}"]
        run = simulate(PROBES / "src" / "timer_probe.cpp", 5 * PERIOD * (count + 1), words)
        tick = run.ticks[len(lengths)]
        spare = tick.real + length - tick.expected - 2 * PERIOD
        if abs(spare) > PERIOD / 4:
            lengths.append(length)
    return lengths


@cache
def plans() -> dict[str, Plan]:
    """What is recorded of the probes, by name. Their random lengths are drawn with runs: not while this is imported."""
    return dict(_plans())


def record_probe(workspace: ros1.Workspace, name: str) -> None:
    """Run a probe and write its ticks, counted from the moment before its timer or loop began."""
    plan = plans()[name]
    load = os.getloadavg()
    parameters = [f"_{key}:={str(value).lower()}" for key, value in plan.parameters.items()]
    # The master keeps the parameters of a node for the next one of its name.
    own_name = f"__name:={re.sub(r'[^a-z0-9]', '_', name)}"
    if plan.program.endswith(".py"):
        command = ["python3", str(PROBES / "src" / plan.program)]
    else:
        command = [str(workspace.folder / "devel/lib/timing_probes" / plan.program)]
    output = workspace.run([*command, *parameters, own_name], plan.seconds, begins=re.compile("^start,"))
    rows = [line.split(",") for line in output.console.splitlines() if line.count(",") in (1, len(COLUMNS) - 1)]
    if not rows or rows[0][0] != "start" or output.status:
        raise RuntimeError(f"{name} failed with status {output.status}:\n{output.console}")
    start = float(rows[0][1])
    with table(RECORDINGS / f"{name}.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(COLUMNS)
        for source, number, *times, last_duration in rows[1:]:
            since = [f"{float(time) - start:.6f}" if time else "" for time in times]
            writer.writerow([source, number, *since, last_duration])
    command_line = ["rosrun", "timing_probes", plan.program, *parameters]
    _write_provenance(name, plan.what, command_line, start, plan.seconds, output.status, load)


def record_launch() -> None:
    """Launch both nodes of the first tutorial."""
    _record_launch("launch", "spinner.launch", "both nodes of the tutorial")


def record_publish() -> None:
    """Launch the publisher and the subscribers of the second tutorial, with the publisher of each language."""
    _record_launch("publish_py", "publish.launch", "a publisher in Python, subscribers in both languages")
    words = ["publisher:=publisher_cpp_node"]
    _record_launch("publish_cpp", "publish.launch", "a publisher in C++, subscribers in both languages", words)


def _record_launch(name: str, file: str, what: str, args: Sequence[str] = ()) -> None:
    """Keep the console of a launch file, from the first node on."""
    load = os.getloadavg()
    run = ros1.launch(PACKAGE / "launch" / file, 3.2, args)
    console = run.console[re.search(r".*process\[mrp/", run.console).start() :]  # type: ignore[union-attr]
    save_whole(RECORDINGS / f"{name}.txt", console.encode())
    command = ["roslaunch", "my_robotics_pkg", file, *args]
    _write_provenance(name, what, command, run.start, run.seconds, run.status, load)


def record_endings() -> None:
    """Press Ctrl-C on the tutorial's C++ nodes, and on the same nodes with a line as the original page has it."""
    load, start = os.getloadavg(), time.time()
    source = PACKAGE / "src"
    rate = (source / "spinner_rate_cpp_node.cpp").read_text()
    timer = (source / "spinner_cpp_node.cpp").read_text()
    nodes = {
        "local_timer": timer,
        "global_timer": "#include <ros/ros.h>\nros::Timer timer_for_counting;\n"
        + timer.replace("  ros::Timer timer_for", "  timer_for"),
        "call_ros_ok": rate,
        "name_ros_ok": rate.replace("while (ros::ok())", "while (ros::ok)"),
    }
    with ros1.Workspace() as workspace, table(RECORDINGS / "endings.csv") as text:
        files = [workspace.folder / f"{name}.cpp" for name in nodes]
        for file in files:
            file.write_text(nodes[file.stem])
        workspace.add_nodes("endings", *files)
        workspace.build()
        workspace.start_master()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["node", "status", "seconds_after_ctrl_c"])
        for file in files:
            begun = time.monotonic()
            output = workspace.run([str(workspace.folder / "devel/lib/endings" / file.stem)], 2.2)
            writer.writerow([file.stem, output.status, f"{time.monotonic() - begun - 2.2:.2f}"])
    _write_provenance("endings", "C++ nodes at Ctrl-C", ["rosrun", "endings", "NODE"], start, 2.2, 0, load)


# What nodes say of themselves, where ticks do not tell it: their parameters, and how long each runs (s).
CLAIMS: dict[str, tuple[dict[str, Any], float]] = {
    "one_shot": ({"kind": "one_shot"}, 2.2),
    "exception": ({"kind": "exception"}, 2.2),
    "period_zero": ({"kind": "period", "period": 0.0}, 1.2),
    "period_negative": ({"kind": "period", "period": -1.0}, 1.2),
    "rate": ({"kind": "rate"}, 2.2),
    "rate_spin_once": ({"kind": "rate_spin_once"}, 2.2),
}


def record_claims() -> None:
    """Let nodes in both languages say what happens to them, and when (s after they began), and keep their status."""
    load, start = os.getloadavg(), time.time()
    with ros1.Workspace() as workspace, table(RECORDINGS / "claims.csv") as text:
        program = workspace.executable(PROBES / "src" / "claims_probe.cpp")
        workspace.start_master()
        commands = {"roscpp": [str(program)], "rospy": ["python3", str(PROBES / "src" / "claims_probe.py")]}
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["language", "run", "parameters", "ended_after", "status", "seconds", "what"])
        for language, command in commands.items():
            for name, (values, seconds) in CLAIMS.items():
                # All, as the master keeps what the node before was given.
                parameters = [f"_{key}:={value}" for key, value in {"period": PERIOD, **values}.items()]
                output = workspace.run([*command, *parameters], seconds)
                row = language, name, " ".join(parameters), seconds, output.status
                for line in re.findall("^said,(.*)$", output.console, re.MULTILINE):
                    writer.writerow([*row, *line.split(",", 1)])
    command = ["rosrun", "timing_probes", "NODE"]
    _write_provenance("claims", "nodes that say what happens to them", command, start, 2.2, 0, load)


def record_pipe() -> None:
    """Let the tutorial's nodes print into a pipe, as they are and told to write each line immediately."""
    load, start = os.getloadavg(), time.time()
    unset = ["env", "-u", "PYTHONUNBUFFERED", "-u", "ROSCONSOLE_STDOUT_LINE_BUFFERED"]
    with ros1.Workspace() as workspace, table(RECORDINGS / "pipe.csv") as text:
        program = workspace.executable(PACKAGE / "src" / "spinner_cpp_node.cpp")
        workspace.start_master()
        commands = {"roscpp": [str(program)], "rospy": ["python3", str(PACKAGE / "src" / "spinner_py_node.py")]}
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["language", "told", "seconds_late"])
        for language, command in commands.items():
            for told, before in (("no", unset), ("yes", [])):
                arrivals = Arrivals()
                workspace.run([*before, *command], 5.2, arrivals)
                writer.writerow([language, told, f"{arrivals.delay or 0:.2f}"])
    _write_provenance("pipe", "INFO lines through a pipe", ["rosrun", "my_robotics_pkg", "NODE"], start, 5.2, 0, load)


# Publishes a /clock that jumps back: 3 s of ROS time from 100 on, then 3 s from 50 on, in steps of 0.1 s.
_CLOCK = """
import rospy, time
from rosgraph_msgs.msg import Clock
rospy.init_node("clock")
publisher = rospy.Publisher("/clock", Clock, queue_size=10)
time.sleep(3)  # until everyone has subscribed
for begin in (100, 50):
    for step in range(31):
        publisher.publish(rospy.Time.from_sec(begin + step / 10))
        time.sleep(0.05)
"""


def record_clock_jump() -> None:
    """Let ROS time jump back under a timer of 1 s, and keep the times at which it ticks."""
    load, start = os.getloadavg(), time.time()
    with ros1.Workspace() as workspace, table(RECORDINGS / "clock_jump.csv") as text:
        workspace.add_package(PROBES)
        workspace.build()
        workspace.start_master()
        subprocess.run(["rosparam", "set", "/use_sim_time", "true"], env=workspace.environment, check=True)
        commands = {
            "roscpp": [str(workspace.folder / "devel/lib/timing_probes/timer_probe")],
            "rospy": ["python3", str(PROBES / "src" / "timer_probe.py")],
        }
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["language", "ros_time"])
        for language, command in commands.items():
            clock = subprocess.Popen(["/usr/bin/python3", "-c", _CLOCK], env=workspace.environment)
            output = workspace.run([*command, "_period:=1.0"], 12.0)
            clock.wait()
            rows = [line.split(",") for line in output.console.splitlines() if line.startswith("timerCallback,")]
            writer.writerows([language, f"{float(row[COLUMNS.index('current_real')]):.1f}"] for row in rows)
    _write_provenance(
        "clock_jump", "a timer when /clock jumps back", ["rosrun", "timing_probes", "NODE"], start, 12.0, 0, load
    )


@contextmanager
def _topics() -> Iterator[tuple[ros1.Workspace, Callable[[str, str], list[str]]]]:
    """A workspace with the nodes of the second tutorial, and what makes the command of one: language and name."""
    with ros1.Workspace() as workspace:
        workspace.add_package(PACKAGE)
        workspace.add_nodes("topics", *TOPICS.glob("*.cpp"))
        workspace.build()
        workspace.start_master()

        def command(language: str, name: str) -> list[str]:
            if language == "roscpp":
                return [str(path) for path in workspace.folder.glob(f"devel/lib/*/{name}_cpp_node")]
            return ["python3", *(str(path) for path in EXAMPLES.rglob(f"{name}_py_node.py"))]

        yield workspace, command


_COUNTER = re.compile(r"counter = (\d+)")


def record_first_message() -> None:
    """Let a node publish immediately, and keep the first number that it hears itself and that another node hears."""
    load, start = os.getloadavg(), time.time()
    with _topics() as (workspace, command), table(RECORDINGS / "first_message.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["language", "latch", "same_node", "other_node"])
        for language, latch, _ in product(("rospy", "roscpp"), ("false", "true"), range(5)):
            words = command(language, "subscriber")
            listener = subprocess.Popen(words, env=workspace.environment, stdout=subprocess.PIPE, text=True)
            assert listener.stdout
            listener.stdout.readline()  # its namespace
            time.sleep(1)  # until it has subscribed
            own = workspace.run([*command(language, "eager"), f"_latch:={latch}"], 1.2, begins=_COUNTER).console
            listener.send_signal(signal.SIGINT)
            heard = [_COUNTER.findall(console)[0] for console in (own, listener.communicate()[0])]
            writer.writerow([language, latch, *heard])
    node = ["rosrun", "topics", "NODE", "_latch:=LATCH"]
    _write_provenance("first_message", "a node that publishes immediately", node, start, 1.2, 0, load)


def record_queue() -> None:
    """Send 30 numbers to a callback that takes as long as 8 of them, and keep those that it is called with."""
    load, start = os.getloadavg(), time.time()
    with _topics() as (workspace, command), table(RECORDINGS / "queue.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["language", "queue_size", "seen"])
        for language, (size, seconds) in product(("rospy", "roscpp"), ((1, 6), (3, 8), (10, 20), (100, 28))):
            output = workspace.run([*command(language, "slow"), f"_queue_size:={size}"], seconds, begins=_COUNTER)
            writer.writerow([language, size, " ".join(_COUNTER.findall(output.console))])
    node = ["rosrun", "topics", "NODE", "_queue_size:=SIZE"]
    _write_provenance("queue", "a slow callback and the subscriber's queue", node, start, 28.0, 0, load)


# A report of rostopic hz.
_HZ = re.compile(r"average rate: ([\d.]+)\s+min: ([\d.]+)s max: ([\d.]+)s std dev: ([\d.]+)s")


def record_hz() -> None:
    """Let ``rostopic hz`` watch a node that slows down after 20 s; keep what it reports each second."""
    load, start = os.getloadavg(), time.time()
    with _topics() as (workspace, command), table(RECORDINGS / "hz.csv") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["window", "report", "rate", "min", "max", "std_dev"])
        for window in ("", "10"):
            node = subprocess.Popen(command("rospy", "slowing"), env=workspace.environment)
            option = ["-w", window] if window else []
            console = workspace.run(
                ["rostopic", "hz", *option, "/counter"], 59.5, begins=re.compile("average rate")
            ).console
            node.send_signal(signal.SIGINT)
            node.wait()
            for number, report in enumerate(_HZ.findall(console), 1):
                writer.writerow([window or "all", number, *report])
    _write_provenance("hz", "a publisher that slows down", ["rostopic", "hz", "/counter"], start, 60.0, 0, load)


def _write_provenance(
    name: str, what: str, command: list[str], start: float, seconds: float, status: int, load: tuple[float, ...]
) -> None:
    versions = {
        "ros": _first_line("rosversion", "roscpp"),
        "python": _first_line("/usr/bin/python3", "--version").removeprefix("Python "),
        "compiler": _first_line("c++", "--version"),
    }
    write_provenance(RECORDINGS / f"{name}.json", what, command, start, seconds, status, load, versions)


def _first_line(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()[0]


OTHERS = {
    "launch": record_launch,
    "publish": record_publish,
    "endings": record_endings,
    "pipe": record_pipe,
    "claims": record_claims,
    "clock_jump": record_clock_jump,
    "first_message": record_first_message,
    "queue": record_queue,
    "hz": record_hz,
}


def main(names: list[str]) -> None:
    """Record what is named, all if nothing is."""
    if lacking := ros1.missing():
        raise SystemExit(f"record: {ros1.Ros1Missing(lacking)}")
    known = [*OTHERS, *plans()]
    if unknown := set(names) - {*known}:
        raise SystemExit(f"record: there is no {', '.join(sorted(unknown))}; there are {', '.join(known)}")
    RECORDINGS.mkdir(exist_ok=True)
    for name, record in OTHERS.items():
        if not names or name in names:
            print(name, flush=True)
            record()
    probes = [name for name in plans() if name in names or not names]
    if not probes:
        return
    with ros1.Workspace() as workspace:
        workspace.add_package(PROBES)
        workspace.build()
        workspace.start_master()
        for name in probes:
            print(name, flush=True)
            record_probe(workspace, name)


if __name__ == "__main__":
    main(sys.argv[1:])
