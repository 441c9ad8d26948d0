"""The wheel, installed with what it asks for from a package index into a fresh environment, runs a node."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tree import ROOT
from wheels import built

NODE = ROOT / "examples/my_robotics_pkg/src/spinner_py_node.py"


def test_it_runs_a_node_in_a_folder_with_nothing_else(tmp_path: Path) -> None:
    wheel, commands = built(tmp_path / "wheel"), tmp_path / "venv" / "bin"
    subprocess.run([sys.executable, "-m", "venv", commands.parent], check=True)
    install: list[str | Path] = [commands / "pip", "install", "--quiet", "-c", ROOT / "constraints.txt", wheel]
    run = subprocess.run(install, capture_output=True, text=True)
    if "NewConnectionError" in run.stderr:
        pytest.skip("pip can reach no package index")
    assert run.returncode == 0, run.stderr
    (tmp_path / "nodes").mkdir()
    shutil.copy(NODE, tmp_path / "nodes")
    command = [commands / "rosspin", "run", NODE.name, "--simulated", "--seconds", "1"]
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    run = subprocess.run(command, cwd=tmp_path / "nodes", env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert [line[-11:] for line in run.stdout.splitlines()[1:]] == ["counter = 1", "counter = 2"]
