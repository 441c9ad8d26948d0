"""A log as a node and a test: the node passes it, and nodes that do what such a log shows do not."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

from rosspin import simulate
from rosspin.__main__ import main
from rosspin.look import look
from rosspin.look.pinning import NODE, TEST, as_files
from tests.helpers.tree import TESTS

LOGS = TESTS / "look/recorded"


def write(log: bytes, folder: Path) -> dict[str, str]:
    files = as_files(look(log))
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return files


def check(folder: Path) -> None:
    """Do what pytest would do with the test in a folder."""
    test = runpy.run_path(str(folder / TEST))
    for line in test["LINES"]:
        test["test_the_line_keeps_its_period"](line)


@pytest.mark.parametrize(
    ("log", "ros", "lines"),
    [
        ("r1_rate_50.log", "rospy", ['"joint state: #": (0.02, 0.002),']),
        ("r1_sleep_10_work_20.log", "rospy", ['"wheel speed: #": (0.1, ']),
        ("r1_echo_10.csv", "rospy", ['"message #: #": (0.1, ']),
        ("r2_timer_10.log", "rclpy", ['"wheel speed: #": (0.1, ']),
        ("r2_sleep_10_work_5.log", "rclpy", ['"wheel speed: #": (0.1, ', "# the log had 0.106 s"]),
        (
            "r2_blocks_two.log",
            "rclpy",
            ['"map: #": (1.43, 0.001)', '"odometry: #": (0.04, 0.004)', '"battery: #": (0.1, 0.01)'],
        ),
        ("r2_twins.log", "rclpy", ['"']),
    ],
)
def test_the_node_passes_its_test(tmp_path: Path, log: str, ros: str, lines: list[str]) -> None:
    files = write((LOGS / log).read_bytes(), tmp_path)
    assert files[NODE].startswith(f"import {ros}\n")
    for line in lines:
        assert line in files[TEST]
    check(tmp_path)


def test_a_node_that_sleeps_after_its_work_fails(tmp_path: Path) -> None:
    write((LOGS / "r2_sleep_10_work_5.log").read_bytes(), tmp_path)
    node = (tmp_path / NODE).read_text(encoding="utf-8")
    (tmp_path / NODE).write_text(node.replace("create_timer(0.1,", "create_timer(0.106,"), encoding="utf-8")
    with pytest.raises(AssertionError):
        check(tmp_path)
    (tmp_path / NODE).write_text(node.replace("wheel speed", "speed"), encoding="utf-8")
    with pytest.raises(AssertionError, match=r"the node does not log it; it logs \['speed: #'\]"):
        check(tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "{} it's",
        '{} "quoted" {{0}}',
        "{{}}} 100% \\n {}",
        "# {} {}",
        "-{} leg2 2",
        "no number at all",
        "wörter \u202e {} </script>",
        '"""',
    ],
)
def test_whatever_a_line_is_made_of(tmp_path: Path, text: str) -> None:
    """What was logged is a text in the node, and cannot be anything else."""
    stamped = "\n".join(f"[INFO] [{1.7e9 + n / 10:.9f}] [a.b-c]: {text.replace('{}', str(n))}" for n in range(40))
    files = write(stamped.encode(), tmp_path)
    assert "\u202e" not in files[NODE] + files[TEST]
    check(tmp_path)
    console = simulate(tmp_path / NODE, 0.5).console
    assert console.splitlines()[0].endswith(re.sub(r"-?\{\}", "1", text, count=1).replace("{}", "0"))


def test_nothing_regular_gives_no_files() -> None:
    assert as_files(look((LOGS / "r2_events.log").read_bytes())) == {}


def test_from_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = str(LOGS / "r2_timer_10.log")
    assert main(["look", log, "--test", str(tmp_path)]) == 0
    assert f"Written: {tmp_path / NODE}, {tmp_path / TEST}" in capsys.readouterr().err
    check(tmp_path)
    before = (tmp_path / NODE).read_text(encoding="utf-8")
    (tmp_path / TEST).write_text("mine", encoding="utf-8")
    assert main(["look", log, "--test", str(tmp_path)]) == 1
    assert f"{tmp_path / NODE} is there already" in capsys.readouterr().err
    assert (tmp_path / NODE).read_text(encoding="utf-8") == before
    assert (tmp_path / TEST).read_text(encoding="utf-8") == "mine"


def test_from_the_command_line_without_a_period(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["look", str(LOGS / "r2_events.log"), "--test", str(tmp_path)]) == 1
    assert "nothing in it is regular, so there is no test to write" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
