"""The command line in a process of its own."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

from .tree import ROOT

_SOURCES = ROOT / "examples" / "my_robotics_pkg" / "src"
TIMER_NODE, RATE_NODE = str(_SOURCES / "spinner_py_node.py"), str(_SOURCES / "spinner_rate_py_node.py")

# Only so that a test that hangs ends at all.
NEVER = 300


def start(*args: str, **options: Any) -> subprocess.Popen[str]:
    """``python -m rosspin ARGS``, its output in pipes."""
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    return subprocess.Popen([sys.executable, "-m", "rosspin", *args], text=True, **pipes | options)


def run(*args: str, **options: Any) -> tuple[int, str, str]:
    """Status, stdout and stderr of ``python -m rosspin ARGS``."""
    process = start(*args, **options)
    out, err = process.communicate(timeout=NEVER)
    return process.returncode, out, err
