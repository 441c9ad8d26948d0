"""C++ nodes as a page runs them, without Python, and what is compared with a run in simulated time."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rosspin import Run, simulate
from rosspin.cpp import build, lean
from rosspin.cpp.building import node_command

from .cpp_scenarios import FOLDER, SECONDS, recorded
from .tree import ROOT

PAGE = ROOT / "tests/helpers/programs_in_page.mjs"
COLOURS = re.compile(r"\x1b\[[\d;]*m")

# What a page adds of callbacks that were never called: the node has not printed it.
UNCALLED = re.compile(r"^(?:Nothing spun the node|The .* was destroyed before).*\n", re.MULTILINE)

# What a node that is alone cannot have in a page: to ask for the nodes around it, and what waits for them.
ASKS_FOR_OTHERS = re.compile(r"in a page, [\w ]+ is not simulated")


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
    assert UNCALLED.sub("", console) == COLOURS.sub("", run.console)
    assert result["status"] == run.status
    assert [tuple(tick[:4]) for tick in result["ticks"]] == [tuple(tick[:4]) for tick in run.ticks]
    durations = [(tick[4], tick_of_run.duration) for tick, tick_of_run in zip(result["ticks"], run.ticks, strict=True)]
    assert all(one == other or one == 0 and other != other for one, other in durations)


def scenarios_are_like(name: str, folder: Path) -> None:
    """Compare each scenario of a file."""
    file = FOLDER / f"{name}.cpp"
    before, *more = ("", "--ros-args", "-r", "from:=to") if "ros2" in name else ("_scenario:=", "from:=to")
    lines = [[before + each, *more] for each in recorded(f"{name}.txt")]
    found = in_page(file, [(SECONDS, " ".join(line)) for line in lines], folder)
    for line, (console, result) in zip(lines, found, strict=True):
        if not ASKS_FOR_OTHERS.search(console):
            is_like((console, result), simulate(file, SECONDS, line))
