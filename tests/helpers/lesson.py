"""The lesson of ``docs/how-to/add-a-lesson.rst``: its files, and its commands."""

from __future__ import annotations

import re
import textwrap

from .tree import ROOT

HOW_TO = (ROOT / "docs/how-to/add-a-lesson.rst").read_text(encoding="utf-8")

_BLOCK = re.compile(r"^\.\. code-block:: \w+\n   :caption: (\S+)\n\n((?:(?:   .*)?\n)+)", re.MULTILINE)

# By their paths in the site.
FILES = {path: textwrap.dedent(text).rstrip("\n") + "\n" for path, text in _BLOCK.findall(HOW_TO)}

COMMANDS = re.findall(r"^   \$ (.*)", HOW_TO, re.MULTILINE)
