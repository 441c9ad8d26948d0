"""C++ nodes in a page, without Python: what its worker says of them is what they do in simulated time elsewhere."""

from __future__ import annotations

import json
import re
import shlex
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from cpp_scenarios import FOLDER, SECONDS, recorded
from tree import ROOT

from rosspin import Run, simulate
from rosspin.cpp import build, lean
from rosspin.cpp.building import node_command
from rosspin.measures import by_source, describe_timeline, lost_by_source

EXAMPLES = ROOT / "examples"
PAGE = ROOT / "tests/helpers/programs_in_page.mjs"
COLOURS = re.compile(r"\x1b\[[\d;]*m")

# What a node that is alone cannot ask in a page: of the nodes around it.
ASKS_FOR_OTHERS = re.compile(r"in a page, to ask for the [\w ]+ of nodes is not simulated")

NODES = [
    *("my_robotics_pkg/src/spinner_cpp_node.cpp", "my_robotics_pkg/src/spinner_rate_cpp_node.cpp"),
    *("my_robotics_pkg/src/publisher_cpp_node.cpp", "my_robotics_pkg/src/pubsub_cpp_node.cpp"),
    *("my_robotics_pkg/src/subscriber_cpp_node.cpp", "steps/2_callback.cpp", "steps/3_class.cpp"),
    "topics/eager_cpp_node.cpp",
    *(f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp" for name in ("plain", "spinner", "spinner_rate")),
    *(f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp" for name in ("publisher", "subscriber")),
    *("steps_ros2/1_class.cpp", "steps_ros2/2_callback.cpp"),
]


def in_page(
    file: Path, runs: Sequence[tuple[float, str]], folder: Path, node: Sequence[str] = ()
) -> list[tuple[str, dict[str, Any]]]:
    """Run a node as a page does, for so many seconds with these arguments each; the consoles and the results."""
    built = build(file)
    program = folder / "program.wasm"
    program.write_bytes(lean(built.program.read_bytes(), file.read_text(encoding="utf-8")))
    jobs = [
        {"program": str(program), "ros": built.ros, "filename": str(file), "seconds": seconds, "args": args, "speed": 0}
        for seconds, args in runs
    ]
    run = subprocess.run(
        [*(node or node_command()), str(PAGE)], input=json.dumps(jobs), capture_output=True, text=True, check=True
    )
    found = []
    for line in run.stdout.splitlines():
        *batches, end = json.loads(line)
        assert end["kind"] == "end", end
        console = "".join(text for batch in batches for _, text, *_ in batch["chunks"])
        found.append((console, end["result"]))
    return found


def is_like(found: tuple[str, dict[str, Any]], run: Run) -> None:
    console, result = found
    assert console == COLOURS.sub("", run.console)
    assert result["status"] == run.status
    assert [tuple(tick[:4]) for tick in result["ticks"]] == [tuple(tick[:4]) for tick in run.ticks]
    durations = [(tick[4], tick_of_run.duration) for tick, tick_of_run in zip(result["ticks"], run.ticks, strict=True)]
    assert all(one == other or one == 0 and other != other for one, other in durations)


@pytest.mark.parametrize("name", NODES)
def test_the_listings_of_pages(name: str, tmp_path: Path) -> None:
    ((console, result),) = in_page(EXAMPLES / name, [(2.2, "")], tmp_path)
    run = simulate(EXAMPLES / name, 2.2)
    is_like((console, result), run)
    said = " ".join(describe_timeline(source, group) for source, group in by_source(run.ticks).items())
    assert result["alternative"] == said
    assert result["lost"] == []


def test_a_browser_without_jspi_says_that_it_has_no_threads(tmp_path: Path) -> None:
    file = EXAMPLES / "topics/slow_cpp_node.cpp"
    ((console, result),) = in_page(file, [(2.0, "")], tmp_path, node_command()[:1])
    assert console == (
        "a thread where WebAssembly has no JSPI (as before Chrome 137, Firefox 153 and Safari 27) is not simulated; "
        "run this node on a real ROS\n"
    )
    assert result["status"] == 1


@pytest.mark.parametrize(
    ("name", "args", "status"),
    [
        ("spinner", "--ros-args -p frequency:=[1,", 1),
        ("spinner", "--ros-args --no-such-flag", 1),
        ("spinner", "--ros-args -r __node:=2fast", 1),
        ("spinner", "--ros-args -r __node:=fast -r __ns:=/mrp", 0),
        ("spinner", "__ns:=/mrp", 0),
        ("publisher", "--ros-args -r counter:=/other/counter --log-level debug", 0),
    ],
)
def test_a_command_line_is_read_alike(name: str, args: str, status: int, tmp_path: Path) -> None:
    file = EXAMPLES / f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp"
    ((console, result),) = in_page(file, [(1.2, args)], tmp_path)
    run = simulate(file, 1.2, args.split())
    is_like((console, result), run)
    assert (run.status == 0) == (status == 0)


@pytest.mark.parametrize(
    "blocks", ["[1.7]", "[0.2, 0.0, 12.0]", "[0.2, 0.0, 3.1, 0.4, 1.25]", "[0.6, 0.6, 0.6, 0.6, 0.6]"]
)
def test_what_late_and_lost_ticks_come_to(blocks: str, tmp_path: Path) -> None:
    file = EXAMPLES / "ros2/timer_probe.cpp"
    for period in (0.5, 0.0625):
        args = ["--ros-args", "-p", f"period:={period}", "-p", f"blocks:={blocks}"]
        run = simulate(file, 10.0, args)
        ((console, result),) = in_page(file, [(10.0, shlex.join(args))], tmp_path)
        is_like((console, result), run)
        (source,) = {tick.source for tick in run.ticks}
        lost = lost_by_source(run.ticks, {source: period}, run.coming)
        assert result["lost"] == [[name, round(time, 6)] for name, times in lost.items() for time in times]
        said = describe_timeline(source, run.ticks)
        assert result["alternative"] == said + (f" Lost ticks: {len(lost[source])}." if lost else "")


@pytest.mark.parametrize("name", ["ros1", "ros1_graph", "ros1_threads", "ros2", "ros2_threads"])
def test_the_scenarios(name: str, tmp_path: Path) -> None:
    file = FOLDER / f"{name}.cpp"
    before, *more = ("", "--ros-args", "-r", "from:=to") if "ros2" in name else ("_scenario:=", "from:=to")
    lines = [[before + each, *more] for each in recorded(f"{name}.txt")]
    found = in_page(file, [(SECONDS, " ".join(line)) for line in lines], tmp_path)
    for line, (console, result) in zip(lines, found, strict=True):
        if not ASKS_FOR_OTHERS.search(console):
            is_like((console, result), simulate(file, SECONDS, line))
