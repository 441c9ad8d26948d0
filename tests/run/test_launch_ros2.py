"""Launch files of ROS 2 in simulated time, held to what the real ``ros2 launch`` did with them.

A recording is the console, with its status, without what differs each time. Lines of different processes come in any
order on a real machine, so what is compared is what each of them printed, in its order, and what launch said of each.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from tree import TESTS

from rosspin import simulate

PACKAGE = TESTS / "launched_ros2"
RECORDED = PACKAGE / "recorded"
FILES = sorted(path.name for path in (PACKAGE / "launch").iterdir())
FAULTY = sorted(path.name for path in (PACKAGE / "faulty").iterdir())

ARGS = {"arguments.launch.py": ["needed:=given", "extra:=more"], "opaque.launch.py": ["count:=3"]}
SECONDS = {"ctrl_c.launch.py": 6.0, "ctrl_c_respawn.launch.py": 6.0}  # the others end by themselves

Write = Callable[..., Path]


def said(console: str) -> dict[str, list[str]]:
    """The lines of a console by who has printed them."""
    text = console.replace(str(PACKAGE), "PKG")
    text = re.sub(r"\[\d+\.\d+\]", "[STAMP]", text)
    text = re.sub(r"cmd '\S*?(\w+)(?:\.py)? ", r"cmd '\1 ", text)
    text = re.sub(r"/tmp/launch_params\w*", "FILE", text)
    text = re.sub(r'^\S+ +File "PREFIX.*"(, line 33).*\n.*load_entry_point.*\n.*\^\^\n', "", text, flags=re.MULTILINE)
    text = re.sub(r'^(\S+ +File ").*/(launched/\w+\.py", line.*\n)(?:\S+     .*\n)*', r"\1\2", text, flags=re.MULTILINE)
    found: dict[str, list[str]] = {}
    speaker = ""
    for line in text.splitlines():
        if match := re.match(r"(\[[A-Z]+\] )?\[([\w.]+)(-\d+)?\]", line):
            speaker = match[0]
        found.setdefault(speaker, []).append(line)
    return found


@pytest.mark.parametrize("name", FILES)
def test_a_launch_file_runs_as_under_ros2_launch(name: str) -> None:
    console, _, status = (RECORDED / f"{name}.txt").read_text(encoding="utf-8").rpartition("status ")
    run = simulate(PACKAGE / "launch" / name, SECONDS.get(name, 45.0), ARGS.get(name, []))
    assert said(run.console) == said(console)
    assert run.status == int(status)
