"""The command line on the wall clock: what it prints, and how it ends."""

from __future__ import annotations

import os
import re
import signal
from typing import Any

import pytest

from rosspin.__main__ import main
from tests.helpers.command_line import NEVER, RATE_NODE, TIMER_NODE, start
from tests.helpers.verdicts import control

FOREVER = """
    import rospy
    rospy.init_node("node")
    rospy.on_shutdown(lambda: rospy.logwarn("hook"))
    rospy.loginfo("ready")
    while not rospy.is_shutdown():
        rospy.sleep(0.05)
    rospy.loginfo("left")
"""


def test_on_the_wall_stamps_are_since_the_epoch(capfd: pytest.CaptureFixture[str]) -> None:
    with control(bears=0.1):
        assert main(["run", RATE_NODE, "--seconds", "0.7"]) == 0
        lines = capfd.readouterr().out.splitlines()
        assert len(lines) >= 2
    for line in lines:
        assert re.fullmatch(r"\[INFO\] \[1\d{9}\.\d{6}\]: \[SPINNER PY NODE\] .*", line)


def test_a_line_is_in_the_pipe_at_once_when_python_is_told_so(write: Any) -> None:
    with start("run", write(FOREVER), env=os.environ | {"PYTHONUNBUFFERED": "1"}) as process:
        assert process.stdout
        assert process.stdout.readline().endswith("ready\n")
        process.kill()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_ends_a_node_in_peace(write: Any, number: int) -> None:
    with start("run", write(FOREVER), env=os.environ | {"PYTHONUNBUFFERED": "1"}) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(number)
        out, err = process.communicate(timeout=NEVER)
    assert process.returncode == 0
    assert re.fullmatch(r"\[INFO\] \[[\d.]+\]: left\n", out)
    assert re.fullmatch(r"\[WARN\] \[[\d.]+\]: hook\n", err)


def test_ctrl_c_ends_the_timer_node_in_peace() -> None:
    with start("run", TIMER_NODE, env=os.environ | {"PYTHONUNBUFFERED": "1"}) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=NEVER)
    assert (process.returncode, err) == (0, "")
