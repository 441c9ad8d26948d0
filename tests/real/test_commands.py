"""The commands of README and the pages that need the wall clock or a real ROS."""

from __future__ import annotations

import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.helpers.commands import COMMANDS, SIMULATED
from tests.helpers.launches import unspoilt
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(5)


@pytest.mark.parametrize(
    "command", [command for command in COMMANDS if " run " in command and command not in SIMULATED]
)
def test_run_command_works(command: str, tmp_path: Path, require: Callable[[str], None]) -> None:
    """Typed as it stands, in a folder that has the examples; a run without an end is given one."""
    if "--ros2" in command:
        require("ros2")
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    arguments = shlex.split(command.partition(" run ")[2])
    end = [] if "--seconds" in arguments else ["--seconds", "1.2"]
    typed = [sys.executable, "-m", "rosspin", "run", *end, *arguments]
    with control(bears=0.1):
        run = subprocess.run(typed, cwd=tmp_path, capture_output=True, text=True)
        console = unspoilt(run.stdout + run.stderr)
        assert run.returncode == 0, run.stderr
        assert "counter = 1" in console
