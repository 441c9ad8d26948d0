"""The commands that the two READMEs and the pages tell a reader to type."""

from __future__ import annotations

import re
from pathlib import Path

from .tree import ROOT, TESTS

PAGES = [ROOT / "index.rst", *sorted(ROOT.glob("docs/**/*.rst")), *sorted(ROOT.glob("notebooks/*.md"))]

_LITERALS = re.compile(r"^ *\$ (.+)|(`+)([^`\n]+)\2", re.MULTILINE)
_OURS = re.compile(r"(?:ROSSPIN_REQUIRE=\S+ )?make [a-z]|rosspin run |\S*python3? -m rosspin run |\S*pytest ")
_READMES = [ROOT / "README.md", TESTS / "README.md"]


def _commands_in(page: Path) -> set[str]:
    text = page.read_text(encoding="utf-8").replace("\\\n", " ")
    literals = (" ".join((typed or inline).split()) for typed, _, inline in _LITERALS.findall(text))
    return {literal for literal in literals if _OURS.match(literal)}


COMMANDS = sorted(set().union(*map(_commands_in, [*_READMES, *PAGES])))

# Those that need no real clock and no ROS.
SIMULATED = [command for command in COMMANDS if "--simulated" in command]
