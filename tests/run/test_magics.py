"""The cell magics, in an IPython shell without a kernel."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from rosspin import Run
from rosspin.clocks import simulation
from tests.helpers.python_texts import of_any_python
from tests.helpers.shells import ipython_shell
from tests.helpers.tree import ROOT

NODES = ROOT / "examples" / "my_robotics_pkg" / "src"
NODE = (NODES / "spinner_py_node.py").read_text()

LINES = (
    "[INFO] [0.000000]: [SPINNER PY NODE] namespace of node = /\n"
    "[INFO] [0.500000]: [SPINNER PY NODE] counter = 1\n"
    "[INFO] [1.000000]: [SPINNER PY NODE] counter = 2\n"
)


@pytest.fixture
def shell(tmp_path: Path) -> Iterator[Any]:
    with ipython_shell(tmp_path) as shell:
        yield shell


def test_a_cell_is_a_node_file_and_its_run_a_variable(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    result = shell.run_cell(f"%%simulate 1\n{NODE}")
    assert result.success
    assert capsys.readouterr() == (LINES, "")
    run = shell.user_ns["run"]
    assert isinstance(run, Run)
    assert (run.console, run.status, run.runtime, run.seconds) == (LINES, 0, "simulated", 1.0)
    assert [tick.real for tick in run.ticks] == [0.5, 1.0]
    # The node has a module of its own.
    assert "SpinnerPyNode" not in shell.user_ns


def test_name_quiet_and_the_node_s_own_arguments(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell(f"%%simulate 1 --name mine --quiet -- __ns:=/mrp\n{NODE}")
    assert capsys.readouterr() == ("", "")
    assert "run" not in shell.user_ns
    assert shell.user_ns["mine"].console == LINES.replace("node = /\n", "node = /mrp/\n")


def test_the_run_has_the_messages(shell: Any) -> None:
    node = (NODES / "publisher_py_node.py").read_text()
    shell.run_cell(f"%%simulate 1\n{node}")
    messages = shell.user_ns["run"].messages
    assert [(sent.topic, sent.time, sent.message.data) for sent in messages] == [
        ("/counter", 0.5, 1),
        ("/counter", 1, 2),
    ]


def test_warnings_go_to_stderr(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell("%%simulate 1\nimport rospy\nrospy.init_node('n')\nrospy.logwarn('hot')")
    assert capsys.readouterr() == ("", "[WARN] [0.000000]: hot\n")


def test_an_error_in_the_node_is_printed_and_does_not_stop_the_notebook(
    shell: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    result = shell.run_cell("%%simulate 1\nimport rospy\nrospy.init_node('n')\nrospy.Rate(0)\n")
    assert result.success
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith('Traceback (most recent call last):\n  File "<cell ')
    assert '>", line 4, in <module>\n    rospy.Rate(0)\n' in err
    assert of_any_python(err).endswith("ZeroDivisionError: division by zero\n")
    assert shell.user_ns["run"].status == 1


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("%%simulate", "%%simulate: the following arguments are required: seconds"),
        ("%%simulate two", "%%simulate: argument seconds: invalid float value: 'two'"),
        ("%%simulate 1 --fast", "%%simulate: unrecognized arguments: --fast"),
        ("%%measure 1 2", "%%measure: unrecognized arguments: 2"),
        ("%%simulate nan", "seconds must be a number of at least 0, not nan"),
    ],
)
def test_a_bad_first_line_says_what_is_wrong(
    shell: Any, capsys: pytest.CaptureFixture[str], tmp_path: Path, line: str, text: str
) -> None:
    assert not shell.run_cell(f"{line}\nopen({str(tmp_path / 'ran')!r}, 'w')").success
    captured = capsys.readouterr()
    assert text in captured.out + captured.err
    assert not (tmp_path / "ran").exists()
    assert "run" not in shell.user_ns


def test_what_ends_the_run_stops_the_notebook(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    for cell, error in (
        ("%%simulate 1\ndef (", "SyntaxError"),
        ("%%simulate 1\nimport rospy\nrospy.MasterProxy", "NotSimulated"),
        ("%%simulate 1\nimport rospy\nrospy.init_node('n')\nwhile True:\n    rospy.sleep(0)", "TimeStandsStill"),
    ):
        result = shell.run_cell(cell)
        assert type(result.error_in_exec).__name__ == error
    assert "run" not in shell.user_ns


@pytest.mark.parametrize(
    ("begin", "sleep"),
    [("import rospy\nrospy.init_node('n')", "rospy.sleep"), ("import rclpy, time\nrclpy.init()", "time.sleep")],
)
def test_threads_without_end_end_the_cell(shell: Any, monkeypatch: pytest.MonkeyPatch, begin: str, sleep: str) -> None:
    monkeypatch.setattr(simulation, "MOST_STACKS", 100)
    loop = f"while True:\n    threading.Thread(target={sleep}, args=(1,)).start()"
    error = shell.run_cell(f"%%simulate 1\n{begin}\nimport threading\n{loop}").error_in_exec
    assert "<cell " in str(error) and ">:6: simulated time stands still at 0.0 s, because 100 threads" in str(error)


def test_the_shell_is_as_it_was_after_a_cell(shell: Any) -> None:
    main, path, argv = sys.modules["__main__"], sys.path[:], sys.argv[:]
    shell.run_cell(f"%%simulate 1\n{NODE}")
    assert (sys.modules["__main__"], sys.path, sys.argv) == (main, path, argv)
    assert "rospy" not in shell.user_ns


DRIVER = """import rclpy
from geometry_msgs.msg import Twist, Vector3

rclpy.init()
node = rclpy.create_node("driver")
publisher = node.create_publisher(Twist, "cmd_vel", 10)
node.create_timer(0.5, lambda: publisher.publish(Twist(linear=Vector3(x=1.0))))
print("ready")
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
"""


def test_a_cell_drives_a_vehicle(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert shell.run_cell(f"%%drive 2 --name driven\n{DRIVER}").success
    said = capsys.readouterr().out
    assert said.startswith("ready\nThe vehicle drives 1.5 m in 2 s and keeps to its line: at most 12 cm off.")
    run = shell.user_ns["driven"]
    assert (run.status, run.seconds, run.console) == (0, 2.0, "ready\n")
    assert len([sent for sent in run.messages if sent.topic == "/line"]) == 40


def test_a_cell_of_ros_1_drives_one_without_a_roslaunch_that_speaks(
    shell: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = "import rospy\nrospy.init_node('driver')\nrospy.spin()\n"
    assert shell.run_cell(f"%%drive 1\n{cell}").success
    assert capsys.readouterr().out.startswith("The vehicle stands still for 1 s.")
    assert shell.user_ns["run"].console == ""


def test_a_task_is_put_into_a_cell_of_its_own(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert shell.run_cell("%answer follow-the-line").success
    assert "Make it steer ten times a second" in capsys.readouterr().out
    assert shell.rl_next_input.startswith("%%answer follow-the-line\nimport rclpy\n")
    shell.run_cell("%answer follow-the-lane")
    said = capsys.readouterr()
    assert "there is no such exercise; the names are follow-the-line, " in said.out + said.err


def test_the_answer_to_a_task_is_drawn(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert shell.run_cell(f"%%answer follow-the-line\n{DRIVER}").success
    assert "The vehicle drives 7.5 m in 8 s and leaves its line by" in capsys.readouterr().out
