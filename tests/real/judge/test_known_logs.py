"""Logs whose fault is known, once more on the real ROS 1 and ROS 2: what is said of them has to be true each time.

A log that is lacking is recorded. The others stay as they are: the rules were written for them.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from rosspin.look import look
from tests.helpers.known_logs import REAL, Case
from tests.helpers.known_logs_recorded import record, recording
from tests.helpers.verdicts import control

BEARS = 0.05  # s: longer, and the log shows that the machine has stalled


@pytest.mark.parametrize("case", REAL, ids=lambda case: case.name)
def test_what_is_said_of_a_log_is_true_of_the_next_one(
    require: Callable[[str], None], tmp_path: Path, case: Case
) -> None:
    require(f"ros{case.ros}")
    if case.jumps and not shutil.which("cc"):
        pytest.skip("there is no C compiler")
    new = recording(case, tmp_path)
    with control(BEARS):
        record(case, new)
        found = look(new.read_bytes(), new.name)
        assert case.outcome(found.verdicts[0].name) in ("right", "open"), "\n".join(found.report())
    if not recording(case).exists():
        shutil.copy(new, recording(case))
