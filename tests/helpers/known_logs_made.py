"""Make the logs of the corpus that are simulated, and load those that were recorded."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import UTC, datetime
from random import Random

from rosspin import Node, simulate

from .known_logs import Case
from .tree import TESTS

HERE = TESTS / "look"
START = 1_700_000_000

_STAMP = re.compile(r"\[(\d+\.\d+)\]")


def load(case: Case) -> bytes:
    """The bytes of a log."""
    if case.is_real:
        (file,) = (HERE / "recorded").glob(f"{case.name}.*")
        return file.read_bytes()
    return _dress(case, _lines(case)).encode()


def _lines(case: Case) -> list[tuple[float, str]]:
    """The log lines with their times, as the nodes' common terminal shows them."""
    file = HERE / f"nodes/faulty_ros{case.ros}.py"
    after = case.after or (0.0,) * len(case.nodes)
    # Nodes that publish run together, the others one by one; a launch puts a number to each process.
    talks = any(" pub," in node or " sub," in node for node in case.nodes) and case.form != "csv"
    lines = []
    if talks:
        commands = [
            node.split() + ([f"after={wait}"] if wait else []) for node, wait in zip(case.nodes, after, strict=True)
        ]
        run = simulate([Node(str(file), each) for each in commands], case.seconds, start=START)
        lines = _timed(run.console)
    else:
        for number, (node, wait) in enumerate(zip(case.nodes, after, strict=True), 1):
            words = node.split() + [f"stop={at - wait}:{length}" for at, length in case.stops]
            own = _timed(simulate(str(file), case.seconds - wait, words, start=START + wait).console)
            prefix = f"[{words[0]}-{number}] " if case.form == "launch" else ""
            lines += [(time, prefix + line) for time, line in own]
    lines.sort(key=lambda each: each[0])
    return [_set(each, case.jumps) for each in lines]


def _timed(console: str) -> list[tuple[float, str]]:
    return [(float(match[1]), line) for line in console.splitlines() if (match := _STAMP.search(line))]


def _set(line: tuple[float, str], jumps: Sequence[tuple[float, float]]) -> tuple[float, str]:
    """The line as the clock tells its time that was set by so much at such times."""
    time, text = line
    moved = time + sum(step for at, step in jumps if time - START > at)
    digits = len(_STAMP.search(text)[1].partition(".")[2])  # type: ignore[index]
    return moved, _STAMP.sub(f"[{moved:.{digits}f}]", text, count=1) if moved != time else text


def _dress(case: Case, lines: Sequence[tuple[float, str]]) -> str:
    texts = [line for _, line in lines]
    if case.form == "lossy":  # of what a node hears
        draw = Random(case.name)
        texts = [line for line in texts if "heard" not in line or draw.random() > 0.1]
    if case.form == "colours":
        texts = [f"\x1b[32m{line}\x1b[0m" for line in texts]
    if case.form == "pasted":
        texts = ["you@robot:~$ rosrun my_robotics_pkg base.py", *texts, "^C", "you@robot:~$ "]
    if case.form == "files":
        texts = [_in_file(time, line) for time, line in lines]
    if case.form == "csv":
        texts = [_row(line) for line in texts]
    return "\n".join(texts) + "\n"


def _in_file(time: float, line: str) -> str:
    """As rospy writes it to its file."""
    when = datetime.fromtimestamp(time, UTC)
    return f"[rosout][INFO] {when:%Y-%m-%d %H:%M:%S},{when.microsecond // 1000:03}: {line.partition(']: ')[2]}"


def _row(line: str) -> str:
    """As ``ros2 topic echo --csv`` writes a message with a header and a number."""
    seconds, nanoseconds = _STAMP.search(line)[1].split(".")  # type: ignore[index]
    return f"{seconds},{int(nanoseconds)},map,{line.rpartition(' ')[2]}"
