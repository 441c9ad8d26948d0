"""The commands that README and the pages tell a reader to type."""

from __future__ import annotations

import re
from pathlib import Path

from tree import ROOT

PAGES = [ROOT / "index.rst", *sorted(ROOT.glob("docs/**/*.rst")), *sorted(ROOT.glob("notebooks/*.md"))]

_LITERALS = re.compile(r"^ *\$ (.+)|(`+)([^`\n]+)\2", re.MULTILINE)
_OURS = re.compile(r"make [a-z]|rosspin run |\S*python3? -m rosspin run ")


def _commands_in(page: Path) -> set[str]:
    text = page.read_text(encoding="utf-8").replace("\\\n", " ")
    literals = (" ".join((typed or inline).split()) for typed, _, inline in _LITERALS.findall(text))
    return {literal for literal in literals if _OURS.match(literal)}


COMMANDS = sorted(set().union(*map(_commands_in, [ROOT / "README.md", *PAGES])))

# Those that need no real clock and no ROS.
SIMULATED = [command for command in COMMANDS if "--simulated" in command]
