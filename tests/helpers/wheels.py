"""The wheel of the package."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

from .tree import ROOT

VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]


def built(folder: Path) -> Path:
    """Build it into a folder, without asking a package index for anything; its path."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    build = [*pip, "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir", str(folder), str(ROOT)]
    subprocess.run(build, check=True)
    (wheel,) = folder.glob("*.whl")
    assert wheel.name == f"rosspin-{VERSION}-py3-none-any.whl"
    return wheel
