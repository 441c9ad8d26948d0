"""Plant the faults of faults.toml, each in a copy of the tree, and see whether a test catches it.

In a copy the likeliest tests are run first, and the rest of the lane only if those see nothing.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
FAULTS: dict[str, dict[str, Any]] = tomllib.loads(Path(__file__).with_name("faults.toml").read_text(encoding="utf-8"))

# Of what was built, a copy is given its own of what a build or a test changes, and the use of the rest.
_COPIED = ("build/cpp", "build/html", "build/doctrees", "build/jupyter_execute", "build/web")
_SHARED = (".venv", "build/npm", "build/ros2", "build/ros2-kilted")

# What is seen in the pages only after they were built again.
_BUILT = ("web/", "src/rosspin/site/", "src/rosspin/page.py")

# A fault may keep a test from ending (s).
_PATIENCE = 3600

# Statuses of pytest.
_WRONG_USAGE = 4
_NONE_COLLECTED = 5


def main() -> None:
    """Print for each fault the test that caught it, and at the end how many were caught."""
    parser = argparse.ArgumentParser(prog="python tests/planted", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="plant only these faults")
    parser.add_argument("--hinted", action="store_true", help="run only the likeliest tests, not the rest of the lane")
    parser.add_argument("--tests", nargs=argparse.REMAINDER, default=[], metavar="ARGS", help="the lane, for pytest")
    options = parser.parse_args()
    if unknown := sorted(set(options.names) - FAULTS.keys()):
        parser.error(f"there is no {', '.join(unknown)} in faults.toml")
    names = options.names or list(FAULTS)
    caught = 0
    for name in names:
        began = time.monotonic()
        with _planted(FAULTS[name]) as tree:
            test = _catch(tree, FAULTS[name], options.tests, options.hinted)
        caught += test is not None
        said = f"caught by {test}" if test else "NOT CAUGHT"
        print(f"{name}: {said} ({time.monotonic() - began:.0f} s)", flush=True)
    print(f"{caught} of {len(names)} caught")


@contextmanager
def _planted(fault: dict[str, Any]) -> Iterator[Path]:
    """A copy of the tree with a fault in it; but without this list, whose own test would catch them all."""
    with tempfile.TemporaryDirectory(prefix="planted-", ignore_cleanup_errors=True) as folder:
        tree = Path(folder, "tree")
        git = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", ":!tests/*planted*"]
        listed = subprocess.run(git, cwd=ROOT, check=True, capture_output=True, text=True).stdout
        for name in filter(None, listed.split("\0")):
            if (ROOT / name).is_file():
                (tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, tree / name)  # with its time: make builds no more than it has to
        for name in _COPIED:
            if (ROOT / name).exists():
                shutil.copytree(ROOT / name, tree / name)
        for name in _SHARED:
            if (ROOT / name).exists():
                (tree / name).parent.mkdir(exist_ok=True)
                (tree / name).symlink_to(ROOT / name)
        for command in (["init", "--quiet"], ["add", "."]):
            subprocess.run(["git", *command], cwd=tree, check=True)
        file = tree / fault["file"]
        before, text, after = file.read_text(encoding="utf-8").partition(fault["before"])
        assert text, f"{fault['file']} has changed: mend faults.toml"
        file.write_text(before + fault["after"] + after, encoding="utf-8")
        yield tree


def _catch(tree: Path, fault: dict[str, Any], lane: Sequence[str], hinted_only: bool) -> str | None:
    """The first test that fails in the copy; None if there is none."""
    file: str = fault["file"]
    hinted = [str(path) for stem in fault["tests"] for path in sorted((tree / "tests").rglob(f"{stem}.py"))]
    scripts = [str(path) for path in sorted((tree / "web/test").glob("*.mjs"))]
    pytest = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *lane]
    return (
        (file.startswith("web/") and _fails(tree, [".venv/bin/node", "--test", "--test-reporter=tap", *scripts]))
        or (file.startswith(_BUILT) and _fails(tree, ["make", "html", f"PYTHONPATH={tree / 'src'}"]))
        or _fails(tree, [*pytest, *hinted])
        or (not hinted_only and _fails(tree, [*pytest, *(f"--ignore={path}" for path in hinted)]))
        or None
    )


def _fails(tree: Path, command: Sequence[str]) -> str:
    """What a command says has failed; "" if nothing has."""
    # The sources of the copy go before those that are installed, for which make has to be asked; and random tests draw
    # the same each time.
    environment = os.environ | {"PYTHONPATH": str(tree / "src"), "ROSSPIN_SEED": "0"}
    pipe = subprocess.PIPE
    with subprocess.Popen(
        command, cwd=tree, env=environment, stdout=pipe, stderr=subprocess.STDOUT, text=True, start_new_session=True
    ) as process:
        try:
            said, _ = process.communicate(timeout=_PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return f"{command[0]}, which did not end"
    if process.returncode in (0, _NONE_COLLECTED):
        return ""
    if process.returncode == _WRONG_USAGE:
        sys.exit(said)
    found = re.search(r"^(?:FAILED|ERROR) (.+?)(?: - |$)|^ *not ok \d+ - (.+)", said, re.MULTILINE)
    return (found[1] or found[2]) if found else f"{shlex.join(command[:2])} (status {process.returncode})"


if __name__ == "__main__":
    main()
