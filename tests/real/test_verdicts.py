"""The control beside a run, on the real clock."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from launches import NEVER
from tree import HELPERS
from verdicts import Control


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells that a process has been stopped")
def test_a_process_that_stands_still_is_noticed() -> None:
    code = "from verdicts import Control\nwith Control() as beside: print(flush=True); input()\nprint(beside.stalled())"
    command = [sys.executable, "-c", code]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, cwd=HELPERS, stdin=pipe, stdout=pipe, text=True) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(signal.SIGSTOP)
        while Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0] != "T":
            pass
        time.sleep(0.2)
        process.send_signal(signal.SIGCONT)
        out, _ = process.communicate("\n")
    assert float(out) >= 0.2


@pytest.mark.skipif(not Path("/proc/pressure/cpu").exists(), reason="this kernel does not count who waits")
def test_those_who_wait_for_a_processor_are_noticed() -> None:
    others = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(3 * (os.cpu_count() or 1))]
    try:
        with Control() as beside:
            begun = time.monotonic()
            while beside.stalled() < 0.2 and time.monotonic() < begun + NEVER:
                time.sleep(0.05)
    finally:
        for other in others:
            other.kill()
            other.wait()
    assert beside.stalled() >= 0.2
