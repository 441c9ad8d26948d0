"""An author at work: a copy of the repository, and the way of the how-to through it, by its commands."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Collection
from pathlib import Path
from shlex import quote

from .tree import ROOT

HOW_TO = (ROOT / "docs/how-to/adapt-a-page.rst").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^ +\$ (.*)", HOW_TO, re.MULTILINE)


def copied(folder: Path, pages: Collection[str] = ()) -> Path:
    """A copy of what git tracks, as an author has it, in a folder; to be quick, with no other pages than these.

    Two notebooks are run, and measure for a moment; of a few pages only the one that needs no real clock.
    """
    folder /= "rosspin"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in filter(None, listed.split("\0")):
        is_page = name.startswith(("docs/", "notebooks/")) and name.endswith((".rst", ".md"))
        if (ROOT / name).is_file() and not (pages and is_page and name not in pages):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    for notebook in folder.glob("notebooks/*.md"):
        text = notebook.read_text().replace("%%measure 6", "%%measure 0.5")
        if notebook.stem == "timer" and pages:
            text = text.replace("---\n", "---\nmystnb: {execution_mode: 'off'}\n", 1)
        elif notebook.stem not in ("timer", "rate"):
            text = without_runs(text)
        notebook.write_text(text)
    if pages:
        names = "".join(f"   {name.rpartition('.')[0]}\n" for name in pages)
        (folder / "index.rst").write_text(f"Few pages\n=========\n\n.. toctree::\n\n{names}")
        with open(folder / "conf.py", "a") as conf:
            conf.write('suppress_warnings = ["ref", "myst.xref_missing", "toc"]  # links to what is not here\n')
    git = ["git", "-c", "user.name=author", "-c", "user.email=author@localhost"]
    for command in (["init", "--quiet"], ["add", "."], ["commit", "--quiet", "--message", "As it was"]):
        subprocess.run([*git, *command], cwd=folder, check=True)
    return folder


def without_runs(notebook: str) -> str:
    """A notebook without its cells."""
    return re.sub(r"^```\{code-cell\}(.*\n)*?```\n", "", notebook, flags=re.MULTILINE)


def typed(command: str, tree: Path) -> subprocess.CompletedProcess[str]:
    """Type a command in the tree, which uses this environment and runs no listing in the page."""
    if command.startswith("make "):
        command += f" VENV= WEB= BIN={quote(sys.prefix)}/bin PYTHONPATH={quote(str(tree))}/src"
    environment = os.environ | {"PYTHONPATH": str(tree / "src")}
    return subprocess.run(command, shell=True, cwd=tree, env=environment, capture_output=True, text=True)


def listed_in(output: str) -> str:
    _, _, found = output.partition("What follows no longer holds:\n")
    return found


def entry_of(listed: str, start: str) -> str:
    (entry,) = (part for part in listed.split("\n\n") if part.startswith(start))
    return entry


def places_in(listed: str, end: str = "") -> set[tuple[str, int]]:
    """Page and line of each entry, or of those whose first line ends as this pattern says."""
    return {(page, int(line)) for page, line in re.findall(rf"^([\w./-]+):(\d+){end}", listed, re.MULTILINE)}


# What the author of the how-to writes in place of what.
SPELT_ANEW = {
    "[0.5, 1.0, 1.5, 2.0]": "[0.4, 0.8, 1.2, 1.6, 2.0]",
    "0.5": "0.4",
    "   assert launched_periods == {period}\n": "",
    '   assert every["rospy"] == every["rclpy"]\n': "",
    '   assert counted["rospy", ""] == counted["rclpy", ""] == ["1", "2", "3", "4"], counted\n': "",
}


def go_the_way(tree: Path, runs_timer: bool) -> str:
    """Go the way of the how-to in such a copy, with its commands; what its first build lists.

    What the new nodes, one in each language, did not do is found in the timer's notebook, if that is run.
    """
    into, change, back, *rest = COMMANDS
    build, outputs, diff, doctest, again = rest
    assert rest == ["make html", "make outputs", "git diff", "make doctest", "make html"]
    assert typed(f"{into}; {change}; {back}; test -f conf.py", tree).returncode == 0

    # The list: all pages and notebooks, with no frames of others.
    run = typed(build, tree)
    listed = listed_in(run.stdout)
    assert run.returncode != 0
    # But for what ipykernel logs if a kernel's sockets have been closed before it has ended.
    said = re.sub(r".*exception in ZMQStream callback\nTraceback(.*\n)+?zmq\..*\n", "", run.stdout + run.stderr)
    assert "Traceback" not in said and 'File "' not in said
    assert "exception" not in said.lower()
    lines = (tree / "docs/tutorial-timer.rst").read_text().splitlines()
    line = lines.index("   [INFO] [0.500000]: [SPINNER PY NODE] counter = 1")  # the output begins one line above
    entry = entry_of(listed, f"docs/tutorial-timer.rst:{line} (make outputs)\n")
    assert "   docs/tutorial-timer.rst:LINE (make outputs)\n" in HOW_TO
    assert re.search(r"was (.*\n)+.*\[1\.500000\]: .* counter = 3\n", entry)
    assert re.search(r"now (.*\n)+.*\[1\.200000\]: .* counter = 3\n", entry)
    lines = (tree / "docs/tutorial.rst").read_text().splitlines()
    fact = entry_of(listed, f"docs/tutorial.rst:{lines.index('   assert period == 0.5') + 1}\n")
    assert re.search(r"text +Write two small ROS 1 nodes.* twice a second", fact) and "now     period is 0.4" in fact
    cell = entry_of(listed, "notebooks/rate.md:")
    assert "was     assert" in cell and "(0.0, 0.4)" in cell
    assert re.search(r"^notebooks/timer\.md:\d+ \(make", listed, re.MULTILINE)

    # The outputs are written, and what is left is the author's.
    run = typed(outputs, tree)
    assert run.returncode == 0, run.stderr
    changed = typed(diff, tree).stdout
    assert "+   [INFO] [0.400000]: [SPINNER PY NODE] counter = 1" in changed
    assert "+        timer_delta_t_in_seconds = 0.4" in changed
    run = typed(doctest, tree)
    assert re.search(r"^ +0 failures in tests$", run.stdout, re.MULTILINE)
    assert "(make outputs)" not in run.stdout
    left = places_in(listed_in(run.stdout))
    assert run.returncode != 0
    # All that was listed of them.
    kept = places_in(listed, r"$")
    assert len(left) == len(kept) + 2 * runs_timer
    assert {page for page, _ in left} == {page for page, _ in kept} | ({"notebooks/timer.md"} if runs_timer else set())

    # The author writes it, and the build succeeds. From the end, so that no line moves before it is found.
    for page, number in sorted(left, reverse=True):
        text = (tree / page).read_text().splitlines(keepends=True)
        old = next(old for old in SPELT_ANEW if old in text[number - 1])
        text[number - 1] = text[number - 1].replace(old, SPELT_ANEW[old])
        (tree / page).write_text("".join(text))
    run = typed(again, tree)
    assert run.returncode == 0, run.stdout + run.stderr
    # Numbers in sentences without a line of their own in the list follow by themselves.
    assert "make the delta 0.1 instead of 0.4" in (tree / "build/html/docs/tutorial.html").read_text()
    return listed
