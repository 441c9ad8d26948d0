"""Sites of two pages, and their builds."""

from __future__ import annotations

import doctest
import io
import re
import shutil
import subprocess
import textwrap
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path
from unittest.mock import patch

from sphinx.cmd.build import main

from .tree import ROOT

CONF = """
import runpy
extensions = ["myst_nb", "rosspin.site.pages"]
include_patterns = ["index.rst", "notebooks/*.md"]
nb_execution_mode = "off"
doctest_default_flags = runpy.run_path({conf!r})["doctest_default_flags"]
"""


def rst(group: str, directive: str, options: str, content: str) -> str:
    body = "\n".join(filter(None, [options])) + f"\n\n{content}" if options else f"\n{content}"
    return f"\n.. {directive}:: {group}\n{textwrap.indent(body, '   ')}\n"


def markdown(group: str, directive: str, options: str, content: str) -> str:
    return f"\n```{{{directive}}} {group}\n" + (f"{options}\n\n" if options else "") + f"{content}\n```\n"


PAGES = {"index.rst": rst, "notebooks/book.md": markdown}

NOTEBOOK = """\
---
file_format: mystnb
kernelspec:
  name: python3
language_info:
  name: python
  pygments_lexer: python
---

# Book

```{code-cell} ipython3
x = 1
```
"""

HEADS = {"index.rst": "Page\n====\n\n.. toctree::\n\n   notebooks/book\n", "notebooks/book.md": NOTEBOOK}


def site(folder: Path, examples: dict[str, list[tuple[str, str, str]]], bare: str = "") -> Path:
    """A folder with a page and a notebook, each with all of the examples, and with what each build looks at."""
    for name in ("README.md", "docs/vehicle.svg", "examples/ros2/timer_probe.py"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    (folder / "notebooks").mkdir()
    (folder / "conf.py").write_text(CONF.format(conf=str(ROOT / "conf.py")))
    for page, form in PAGES.items():
        blocks = (form(group, *block) for group, group_blocks in examples.items() for block in group_blocks)
        (folder / page).write_text(HEADS[page] + "".join(blocks) + (bare if page == "index.rst" else ""))
    return folder


def arguments(builder: str) -> list[str]:
    """All builders share the parsed pages."""
    return ["-b", builder, "-d", "build/doctrees", "-n", "--no-color", ".", f"build/{builder}"]


def build(folder: Path, builder: str, *more: str) -> subprocess.CompletedProcess[str]:
    """As a command, but in this process, which has imported everything; with ``more`` arguments."""
    # The doctest builder sets this, and leaves it.
    with chdir(folder), patch.object(doctest, "compile", compile, create=True):
        with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
            status = main([*more, *arguments(builder)])
    return subprocess.CompletedProcess(builder, status, out.getvalue(), err.getvalue())


def listed(run: subprocess.CompletedProcess[str]) -> dict[tuple[str, int], str]:
    """The entries of the list that a build ends with, by page and line."""
    _, _, text = run.stdout.partition("What follows no longer holds:\n\n")
    found = (re.match(r"([\w./]+):(\d+)", entry) for entry in text.split("\n\n") if entry)
    return {(place[1], int(place[2])): place.string for place in found if place}
