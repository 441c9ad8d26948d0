"""The command line: what it prints, its status, and that bad input ends in a clear sentence."""

from __future__ import annotations

import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from rosspin import Run
from rosspin.__main__ import main
from rosspin.clocks import watchdog
from rosspin.real import ros1, ros2
from tests.helpers.command_line import TIMER_NODE, run
from tests.helpers.python_texts import of_any_python

RATE_FROM_A_PARAMETER = """
    import rospy
    rospy.init_node("node")
    rate = rospy.Rate(rospy.get_param("~rate", 1))
    while not rospy.is_shutdown():
        rospy.loginfo("x")
        rate.sleep()
"""


@pytest.fixture
def write(tmp_path: Path) -> Any:
    """Writes a node file; its path."""

    def write(text: str, name: str = "node.py") -> str:
        path = tmp_path / name
        path.write_text(dedent(text), encoding="utf-8")
        return str(path)

    return write


@pytest.mark.parametrize("name", ["random", "queue", "copy", "typing", "rospy"])
def test_a_folder_with_a_file_that_is_in_the_way(write: Any, tmp_path: Path, name: str) -> None:
    """Python itself would import it in rosspin, too: python -m puts the folder first."""
    write("x = 1\n", f"{name}.py")
    write("import rospy\nprint('ran')\n")
    status, out, err = run("run", "node.py", "--simulated", "--seconds", "1", cwd=tmp_path)
    whose = "ROS 1's" if name == "rospy" else "Python's"
    said = f"rosspin: {name}.py is in the way of {whose} module {name}: on a real ROS whatever imports {name} is given"
    assert (status, out, err) == (0, "ran\n", f"{said} this file\n")


@pytest.mark.parametrize(("ros", "launched"), [(1, False), (1, True), (2, False)])
def test_so_it_is_named_before_a_run_on_a_real_ros(
    write: Any,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    ros: int,
    launched: bool,
) -> None:
    node = write(f"import {['rospy', 'rclpy'][ros - 1]}\n")
    write("", "queue.py")
    if launched:
        write("<package><name>pkg</name></package>", "package.xml")
        node = write("<launch><node pkg='pkg' type='node.py' name='node'/></launch>", "a.launch")
    asked: list[str] = []

    def launch(file: str, *_: Any) -> Run:
        asked.append(file + capsys.readouterr().err)
        return Run("", (), 0, f"ros{ros}", 1.0, 0.0, ())

    monkeypatch.setattr([ros1, ros2][ros - 1], "launch", launch)
    assert main(["run", node, f"--ros{ros}"]) == 0
    said = f"{os.path.relpath(tmp_path / 'queue.py')} is in the way of Python's module queue: on a real ROS whatever "
    assert asked == [f"{node}rosspin: {said}imports queue is given this file\n"]


# --- good runs --------------------------------------------------------------------------------------------------------


def test_a_simulated_run_prints_the_console() -> None:
    assert run("run", TIMER_NODE, "--simulated", "--seconds", "1") == (
        0,
        "[INFO] [0.000000]: [SPINNER PY NODE] namespace of node = /\n"
        "[INFO] [0.500000]: [SPINNER PY NODE] counter = 1\n"
        "[INFO] [1.000000]: [SPINNER PY NODE] counter = 2\n",
        "",
    )


def test_node_args_follow_two_dashes_wherever_the_options_stand(capsys: pytest.CaptureFixture[str], write: Any) -> None:
    node = write(RATE_FROM_A_PARAMETER)
    options = ["--simulated", "--seconds", "1"]
    for args in (["run", node, *options], ["run", *options, node]):
        assert main([*args, "--", "_rate:=10", "--simulated"]) == 0
        assert capsys.readouterr().out.count("x\n") == 11


def test_warnings_go_to_stderr(write: Any) -> None:
    node = write("import rospy\nrospy.init_node('n')\nrospy.loginfo('out')\nrospy.logwarn('err')\n")
    assert run("run", node, "--simulated", "--seconds", "1") == (
        0,
        "[INFO] [0.000000]: out\n",
        "[WARN] [0.000000]: err\n",
    )


def test_the_node_s_status_is_the_command_s(write: Any) -> None:
    assert main(["run", write("import sys; sys.exit(7)"), "--simulated", "--seconds", "1"]) == 7


def test_help_names_every_option(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(["run", "--help"])
    assert caught.value.code == 0
    text = capsys.readouterr().out
    for word in ("FILE", "--seconds", "--simulated", "--plot", "-- NODE ARGS"):
        assert word in text


# --- plots ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("suffix", "begins"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")])
def test_a_plot_is_what_its_suffix_says_and_always_the_same(tmp_path: Path, suffix: str, begins: bytes) -> None:
    files = [tmp_path / f"one.{suffix}", tmp_path / f"two.{suffix}"]
    for file in files:
        assert main(["run", TIMER_NODE, "--simulated", "--seconds", "2", "--plot", str(file)]) == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    assert files[0].read_bytes().startswith(begins)


def test_a_plot_as_svg_has_its_words(tmp_path: Path) -> None:
    assert main(["run", TIMER_NODE, "--simulated", "--seconds", "2", "--plot", str(tmp_path / "a.svg")]) == 0
    root = ElementTree.parse(tmp_path / "a.svg").getroot()
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    assert "timerCallback: 4 ticks from 0.500 s to 2.000 s" in root.attrib["aria-label"]


def test_a_plot_is_also_put_into_words(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", TIMER_NODE, "--simulated", "--seconds", "2", "--plot", str(tmp_path / "a.svg")]) == 0
    assert capsys.readouterr().err == (
        f"{tmp_path}/a.svg: timerCallback: 4 ticks from 0.500 s to 2.000 s. All 4 ticks were on time. "
        "Every period was 0.5 s; there was no jitter.\n"
    )


def test_what_needs_the_real_ros_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "node.cpp", "--ros2", "--seconds", "1"]) == 1
    said = "rosspin: node.cpp: on a real ROS, C++ nodes run on ROS 1 only: --ros1\n"
    assert capsys.readouterr().err == said


@pytest.mark.parametrize(
    ("plot", "text"),
    [
        ("ticks.gif", "rosspin: --plot ticks.gif: the file name must end in .pdf, .png or .svg\n"),
        ("ticks", "rosspin: --plot ticks: the file name must end in .pdf, .png or .svg\n"),
        ("no/such/folder/a.svg", "rosspin: --plot no/such/folder/a.svg: there is no such folder\n"),
    ],
)
def test_a_bad_plot_is_found_before_the_run(capsys: pytest.CaptureFixture[str], plot: str, text: str) -> None:
    assert main(["run", TIMER_NODE, "--simulated", "--seconds", "2", "--plot", plot]) == 1
    assert capsys.readouterr() == ("", text)


def test_without_ticks_there_is_no_plot_but_the_console_is_there(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, write: Any
) -> None:
    plot = tmp_path / "a.svg"
    assert main(["run", write("print('hello')"), "--simulated", "--seconds", "2", "--plot", str(plot)]) == 1
    assert capsys.readouterr() == ("hello\n", f"rosspin: {plot} was not written: the node did not tick\n")
    assert not plot.exists()


def test_a_plot_must_not_be_a_folder(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    plot = tmp_path / "a.svg"
    plot.mkdir()
    assert main(["run", TIMER_NODE, "--simulated", "--seconds", "0.5", "--plot", str(plot)]) == 1
    assert capsys.readouterr() == ("", f"rosspin: --plot {plot}: this is a folder\n")


def test_without_matplotlib_it_is_said_before_the_run(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(sys.modules, "matplotlib", raising=False)
    monkeypatch.setattr("rosspin.plots.pictures.find_spec", lambda name: None)
    assert main(["run", TIMER_NODE, "--simulated", "--seconds", "0.5", "--plot", "a.svg"]) == 1
    needs = "plots need matplotlib, which is not installed: pip install 'rosspin[plot]'"
    assert capsys.readouterr() == ("", f"rosspin: --plot a.svg: {needs}\n")


def test_a_run_keeps_its_console_and_status_if_the_plot_cannot_be_written(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, write: Any
) -> None:
    plot = tmp_path / f"{'a' * 300}.svg"
    node = "import rospy\nrospy.init_node('a')\nrospy.Rate(1).sleep()\nprint('hello')\nraise SystemExit({})"
    for status in (3, 0):
        file = write(node.format(status))
        assert main(["run", str(file), "--simulated", "--seconds", "5", "--plot", str(plot)]) == (status or 1)
        assert capsys.readouterr() == ("hello\n", f"rosspin: {plot} was not written: File name too long\n")


# --- bad input --------------------------------------------------------------------------------------------------------


def simulated(capsys: pytest.CaptureFixture[str], file: str) -> tuple[int, str]:
    """Status and stderr of ``rosspin run FILE --simulated --seconds 10``."""
    status = main(["run", file, "--simulated", "--seconds", "10"])
    return status, capsys.readouterr().err


def test_a_missing_file(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert simulated(capsys, "no/such.py") == (1, "rosspin: no/such.py: No such file or directory\n")
    assert simulated(capsys, str(tmp_path)) == (1, f"rosspin: {tmp_path}: Is a directory\n")


def test_a_syntax_error_is_shown_with_its_line(capsys: pytest.CaptureFixture[str], write: Any) -> None:
    path = write("import rospy\nif True\n    pass\n")
    assert simulated(capsys, path) == (
        1,
        f"rosspin: File \"{path}\", line 2\n    if True\n           ^\nSyntaxError: expected ':'\n",
    )


def test_a_file_that_is_no_text(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    (tmp_path / "node.py").write_bytes(b"\xff\xfe\x00")
    status, err = simulated(capsys, str(tmp_path / "node.py"))
    assert status == 1
    path = tmp_path / "node.py"
    assert re.search(rf"{path}., line 1|{path}:1", err), err


def test_an_exception_in_main_shows_the_node_s_own_frames(capsys: pytest.CaptureFixture[str], write: Any) -> None:
    path = write("import rospy\nrospy.init_node('n')\nrospy.Rate(0)\n")
    status, err = simulated(capsys, path)
    assert status == 1
    lines = [line for line in of_any_python(err).splitlines() if set(line) - set(" ^~")]
    assert lines == [
        "Traceback (most recent call last):",
        f'  File "{path}", line 3, in <module>',
        "    rospy.Rate(0)",
        "ZeroDivisionError: division by zero",
    ]


STILL = (
    "simulated time stands still at 0.0 s, because the node keeps running without sleeping. Sleep in every loop "
    "(rate.sleep(), rospy.sleep(0.1)), and give timers and rates a period above 0.\n"
)


@pytest.mark.parametrize(
    ("code", "line"),
    [
        pytest.param("import rospy\nrospy.init_node('n')\nwhile True: pass\n", 3, id="never sleeps"),
        pytest.param(
            "import rospy\nrospy.init_node('n')\nr = rospy.Rate(-1)\nwhile True: r.sleep()\n",
            4,
            id="negative rate",
        ),
        pytest.param(
            "import rospy\nrospy.init_node('n')\nt = rospy.Timer(rospy.Duration(-1), print)\nrospy.spin()\n",
            3,
            id="negative period",
        ),
    ],
)
def test_time_that_stands_still(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, write: Any, code: str, line: int
) -> None:
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.05)  # found sooner
    path = write(code)
    assert simulated(capsys, path) == (1, f"rosspin: {path}:{line}: {STILL}")


@pytest.mark.parametrize(
    ("code", "name", "line"),
    [
        ("import rospy\n\nrospy.MasterProxy().getPid()\n", "rospy.MasterProxy", 3),
        ("from rospy import MasterProxy\n", "rospy.MasterProxy", 1),
        ("import rospy\nfrom control_srvs.srv import Empty\n", "control_srvs", 2),
        ("import rospy.msproxy\n", "rospy.msproxy", 1),
        (
            "import rospy\nrospy.init_node('n')\ndef callback(event):\n    import cv_bridge\n"
            "rospy.Timer(rospy.Duration(0.1), callback)\nrospy.spin()\n",
            "cv_bridge",
            4,
        ),
        (
            "import rclpy\nrclpy.init()\ndef callback():\n    import cv_bridge\n"
            "node = rclpy.create_node('n')\nnode.create_timer(0.1, callback)\nrclpy.spin(node)\n",
            "cv_bridge",
            4,
        ),
    ],
)
def test_what_is_outside_of_the_stand_in(
    capsys: pytest.CaptureFixture[str], write: Any, code: str, name: str, line: int
) -> None:
    path = write(code)
    status, err = simulated(capsys, path)
    assert status == 1
    assert err == f"rosspin: {path}:{line}: {name} is not simulated; run this node on a real ROS\n"


@pytest.mark.parametrize(
    ("args", "text"),
    [
        (["run", TIMER_NODE, "--simulated"], "--simulated needs --seconds: no one can press Ctrl-C in simulated time"),
        (["run", TIMER_NODE, "--simulated", "--seconds", "-1"], "seconds must be a number of at least 0, not -1.0"),
        (["run", TIMER_NODE, "--simulated", "--seconds", "nan"], "seconds must be a number of at least 0, not nan"),
        (["run", TIMER_NODE, "--seconds", "nan"], "seconds must be a number of at least 0, not nan"),
        (["run", TIMER_NODE, "--seconds", "inf"], "seconds must be a number of at least 0, not inf"),
        (["run", TIMER_NODE, "--seconds=-0.5"], "seconds must be a number of at least 0, not -0.5"),
    ],
)
def test_bad_seconds(capsys: pytest.CaptureFixture[str], args: list[str], text: str) -> None:
    assert main(args) == 1
    assert capsys.readouterr() == ("", f"rosspin: {text}\n")


@pytest.mark.parametrize(
    ("args", "text"),
    [
        ([], "the following arguments are required: COMMAND"),
        (["walk"], "invalid choice: 'walk'"),
        (["run"], "the following arguments are required: FILE"),
        (["run", TIMER_NODE, "--fast"], "unknown arguments: --fast"),
        (["run", TIMER_NODE, "--sim", "--seconds", "1"], "unknown arguments: --sim"),
        (["run", TIMER_NODE, "_rate:=10"], "unknown arguments: _rate:=10"),
        (["run", TIMER_NODE, "--seconds", "two"], "argument --seconds: invalid float value: 'two'"),
        (["run", TIMER_NODE, "--seconds"], "argument --seconds: expected one argument"),
    ],
)
def test_bad_options(capsys: pytest.CaptureFixture[str], args: list[str], text: str) -> None:
    with pytest.raises(SystemExit) as caught:
        main(args)
    assert caught.value.code == 2
    assert text in capsys.readouterr().err


@pytest.mark.parametrize("name", ["my.launch.py", "my.launch.xml", "my.launch.yaml", "my_launch.xml", "my_launch.py"])
@pytest.mark.parametrize("where", [[], ["--ros1"], ["--ros2"]])
def test_launch_files_of_ros_2(capsys: pytest.CaptureFixture[str], name: str, where: list[str]) -> None:
    assert main(["run", name, *where, "--seconds", "1"]) == 1
    text = f"{name}: launch files of ROS 2 run in simulated time: --simulated"
    assert capsys.readouterr() == ("", f"rosspin: {text}\n")


@pytest.mark.parametrize(("module", "ros", "other"), [("rospy", 1, 2), ("rclpy", 2, 1)])
def test_a_node_of_the_other_ros(
    capsys: pytest.CaptureFixture[str], write: Any, module: str, ros: int, other: int
) -> None:
    path = write(f"import {module}\n")
    assert main(["run", str(path), f"--ros{other}", "--seconds", "1"]) == 1
    assert capsys.readouterr() == ("", f"rosspin: {path}: this is a node of ROS {ros}: --ros{ros}\n")


@pytest.mark.parametrize(
    ("code", "text"),
    [
        (b"import rospy\nx = '\xe9'\n", "the byte 0xe9 is not utf-8"),
        (b"import rospy\nx = '\0'\n", "source code cannot contain null bytes"),
    ],
)
def test_a_stray_byte_is_shown_with_file_and_line(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, code: bytes, text: str
) -> None:
    path = tmp_path / "node.py"
    path.write_bytes(code)
    assert simulated(capsys, str(path)) == (1, f'rosspin: File "{path}", line 2\nSyntaxError: {text}\n')


def test_faults(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    plot = tmp_path / "ticks.svg"
    faults = [
        "--fault",
        "Crash('/spinner_py_node', at=1.2)",
        "--fault",
        'Slow("/spinner_py_node", callback="SpinnerPyNode.timerCallback", by=0.1)',
    ]
    options = ["run", TIMER_NODE, "--simulated", "--seconds", "2", "--plot", str(plot)]
    assert main([*options, *faults]) == 137
    said = capsys.readouterr().err.splitlines()
    assert said[0].startswith("rosspin: Faults: /spinner_py_node timerCallback slowed by 0.1 s ") and said[0].endswith(
        "killed at 1.200 s."
    )
    assert "/spinner_py_node killed" in plot.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--seconds", "1"], "--fault is for simulated time: --simulated"),
        (["--simulated", "--seconds", "1"], "Crash('/node', at=3): the run ends before, at 1 s"),
        (["--simulated", "--seconds", "3", "--fault", "Crash"], "Crash: a fault is written as in Python, as in Topic"),
        (
            ["--simulated", "--seconds", "3", "--fault", "Late('/x', 1)"],
            "there was no node /x; there were /spinner_py_node",
        ),
    ],
)
def test_wrong_faults(capsys: pytest.CaptureFixture[str], options: list[str], words: str) -> None:
    assert main(["run", TIMER_NODE, *options, "--fault", "Crash('/node', at=3)"]) == 1
    assert words in capsys.readouterr().err
