"""The scenarios for C++ nodes, their command lines, and what is compared of their consoles."""

from __future__ import annotations

import re

from .tree import ROOT

FOLDER = ROOT / "tests" / "scenarios_cpp"

SECONDS = 3.0

ARGS = {
    "parameters": ["_whole:=3", "_real:=2.5", "_flag:=true", "_text:=words"],
    "names": ["from:=to"],
}

# What happens when a run ends is decided by chance.
_END = 2.95


def words(name: str) -> list[str]:
    """The command line of a scenario of ROS 1."""
    return [f"_scenario:={name}", f"__name:=s_{name.replace('.', '_')}", *ARGS.get(name, [])]


def compared(console: str, status: int) -> str:
    """What a run printed before its end, without stamps, and its status as a shell tells it."""
    lines = re.sub(r"\[\d+\.\d{9}(?=[],])", "[STAMP", console).splitlines()
    kept = [line for line in lines if not ((time := re.match(r"(\d+\.\d) ", line)) and float(time[1]) >= _END)]
    return "\n".join([*filter(None, kept), f"status {status if status >= 0 else 128 - status}"]) + "\n"


def recorded(file: str) -> dict[str, str]:
    """What the scenarios of a file gave on the real ROS, by their names."""
    _, *parts = re.split(r"^== (.*)\n", (FOLDER / file).read_text(encoding="utf-8"), flags=re.MULTILINE)
    return dict(zip(parts[::2], parts[1::2], strict=True))
