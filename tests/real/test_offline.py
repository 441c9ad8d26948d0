"""The site is built again where there is no network, in a clone that was built before."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(5)

# A network of its own, in which this machine reaches itself and nothing else, as one without a cable does.
ALONE = ["unshare", "--map-root-user", "--net", "--mount"]

# The folders that a build writes or that an author changes are copies, for these commands only.
BUILD = """set -e
ip link set lo up
for folder in docs notebooks build; do mount --bind "$1/$folder" "$2/$folder"; done
cd "$2"
! "$2/.venv/bin/python" -c 'import socket; socket.create_connection(("192.0.2.1", 80), 5)' 2>/dev/null
exec make html
"""


def test_a_page_and_a_notebook_are_made_anew(site: Path, tmp_path: Path) -> None:
    if shutil.which("ip") is None or subprocess.run([*ALONE, "true"], capture_output=True).returncode:
        pytest.skip("no network namespace can be made here (unshare, ip)")
    for folder in ("docs", "notebooks"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    shutil.copytree(ROOT / "build", tmp_path / "build", symlinks=True, ignore=shutil.ignore_patterns("npm", "pycache"))
    # Only read: it need not take its place twice.
    shutil.copytree(ROOT / "build/npm", tmp_path / "build/npm", symlinks=True, copy_function=_linked)
    for name, old in (("docs/glossary.rst", "\nSee also\n"), ("notebooks/ros2-rate.md", "\n## See also\n")):
        path = tmp_path / name
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, f"\nA sentence made offline.\n{old}"), encoding="utf-8")
    run = subprocess.run([*ALONE, "sh", "-c", BUILD, "sh", tmp_path, ROOT], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout[-3000:] + run.stderr
    assert "pip" not in run.stdout and "npm" not in run.stdout
    for name in ("docs/glossary", "notebooks/ros2-rate"):
        built = tmp_path / "build/html" / f"{name}.html"
        assert "A sentence made offline." in built.read_text(encoding="utf-8")
        assert "A sentence made offline." not in (site / f"{name}.html").read_text(encoding="utf-8")


def _linked(source: str, target: str) -> None:
    Path(target).hardlink_to(source)
