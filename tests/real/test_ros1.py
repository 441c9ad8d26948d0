"""The real ROS 1: what the tutorial shows compiles, launches and ends there as it says, and nothing is left over."""

from __future__ import annotations

import io
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from rosspin.__main__ import main
from rosspin.clocks.ctrl_c import Ending
from rosspin.measures import by_source
from rosspin.real import ros1
from rosspin.results.console import read_ticks
from tests.helpers.chatter import CHATTER
from tests.helpers.cpp_nodes import CppNodes
from tests.helpers.launches import NEVER, Until
from tests.helpers.leftovers import processes
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

EXAMPLES = ROOT / "examples"
PACKAGE = EXAMPLES / "my_robotics_pkg"
PROBES = EXAMPLES / "timing_probes"

pytestmark = [pytest.mark.usefixtures("leaves_nothing"), pytest.mark.shares(10)]


@pytest.fixture(scope="module", autouse=True)
def ros(require: Callable[[str], None]) -> None:
    require("ros1")


@pytest.fixture(scope="module")
def workspace() -> Iterator[ros1.Workspace]:
    """One with a master."""
    with ros1.Workspace() as workspace:
        workspace.start_master()
        yield workspace


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """The tutorial's package with one node in C++, which is built soon."""
    package = tmp_path / PACKAGE.name
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    cmake = package / "CMakeLists.txt"
    begin, *targets = re.split(r"\n(?=add_executable|# Needed)", cmake.read_text())
    cmake.write_text(begin + "".join(target for target in targets if "(spinner_cpp_node " in target))
    return package


def counters(console: str) -> list[int]:
    return [int(number) for number in re.findall(r"counter = (\d+)", console)]


# --- the package ------------------------------------------------------------------------------------------------------


def test_every_listing_compiles_without_a_warning(cpp_nodes: CppNodes) -> None:
    for listing in EXAMPLES.rglob("*.cpp"):
        if "ros2" in str(listing.relative_to(EXAMPLES)):
            continue
        assert os.access(cpp_nodes.program(listing.stem), os.X_OK)
    assert not re.findall(rf"{re.escape(str(EXAMPLES))}.*warning: .*", cpp_nodes.said)
    assert re.search(r"while_ros_ok\.cpp.*warning: ", cpp_nodes.said)  # where there is one, it is said


def test_launch_runs_both_nodes(small: Path) -> None:
    live = Until(r"SPINNER CPP NODE\] counter = 3", r"SPINNER PY NODE\] counter = 3")
    run = ros1.launch(small / "launch" / "spinner.launch", NEVER, onward=live)
    assert (run.runtime, run.status) == ("ros1", 0)
    assert run.console.startswith(live.getvalue())
    assert "[SPINNER CPP NODE] namespace of nh = /mrp/spinner_cpp_node" in run.console
    assert "[SPINNER PY NODE] namespace of node = /mrp/\n" in run.console
    for source in ("SPINNER CPP NODE", "SPINNER PY NODE"):
        numbers = [tick.number for tick in run.ticks if tick.source == source]
        assert len(numbers) >= 3
        assert numbers == list(range(1, len(numbers) + 1))
        assert all(tick.real > 0 for tick in run.ticks)


@pytest.mark.parametrize("publisher", ["publisher_py_node.py", "publisher_cpp_node"])
def test_subscribers_of_both_languages_hear_a_publisher_of_either(
    workspace: ros1.Workspace, cpp_nodes: CppNodes, publisher: str
) -> None:
    language = publisher.split("_")[1].upper()
    both = Until(*(rf"SUBSCRIBER {each} NODE\] counter = " for each in ("CPP", "PY")), times=3)
    command = cpp_nodes.roslaunch(workspace, "publish.launch", f"publisher:={publisher}")
    ending, more = ros1._LAUNCH, cpp_nodes.environment
    run = workspace.run(command, NEVER, both, ending=ending, more=more)
    assert run.status == 0
    assert re.search(rf"\[PUBLISHER {language} NODE\] namespace of \w+ = /mrp", run.console)
    heard = by_source(read_ticks(run.console))
    assert heard.keys() == {"SUBSCRIBER CPP NODE", "SUBSCRIBER PY NODE"}
    for ticks in heard.values():  # on a busy machine one may come late, but none is lost after that
        numbers = [tick.number for tick in ticks]
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


@pytest.mark.parametrize("language", ["py", "cpp"])
def test_a_node_hears_itself(workspace: ros1.Workspace, cpp_nodes: CppNodes, language: str) -> None:
    node = cpp_nodes.program("pubsub_cpp_node")
    command = [node] if language == "cpp" else ["python3", str(PACKAGE / "src/pubsub_py_node.py")]
    with control(bears=0.1):  # a node that is slow has been connected only after the first message
        output = workspace.run(command, NEVER, Until("counter = 5"))
        seen = counters(output.console)
        assert seen[0] == 1
    assert output.status == 0
    assert seen == list(range(1, len(seen) + 1))


@pytest.mark.parametrize("name", ["plain", "spinner", "spinner_rate"])
def test_python_node_file(name: str) -> None:
    until = Until("namespace of node") if name == "plain" else Until("counter = 3")
    run = ros1.launch(PACKAGE / "src" / f"{name}_py_node.py", NEVER, ["__ns:=/mrp"], until)
    assert (run.runtime, run.status) == ("ros1", 0)
    assert "namespace of node = /mrp/\n" in run.console
    seen = counters(run.console)
    assert seen == list(range(1, len(seen) + 1))
    assert bool(seen) == (name != "plain")


def test_threads_print_whole_lines(tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(CHATTER)
    assert {*ros1.launch(node, NEVER).console.splitlines()} == {"one", "two"}


def test_cpp_node_file_of_no_package() -> None:
    said = "namespace of nh = /spinner_cpp_node"
    run = ros1.launch(EXAMPLES / "steps" / "2_callback.cpp", NEVER, onward=Until(said))
    assert (run.status, run.ticks) == (0, ())
    assert said in run.console


def test_a_run_is_as_long_as_was_asked_for() -> None:
    live = io.StringIO()
    run = ros1.launch(PACKAGE / "src" / "plain_py_node.py", 1.0, onward=live)
    assert run.seconds == 1.0
    assert run.console == live.getvalue()


# --- what goes wrong --------------------------------------------------------------------------------------------------


def test_compile_error_is_the_compilers_own(tmp_path: Path) -> None:
    node = tmp_path / "broken.cpp"
    node.write_text('#include "ros/ros.h"\nint main() { return oops; }\n')
    with pytest.raises(ros1.BuildFailed, match=rf"{re.escape(str(node))}:2:\d+: error: .oops. was not declared"):
        ros1.launch(node, 1.0)


def empty_package(folder: Path) -> Path:
    package = folder / "lab"
    package.mkdir()
    xml = PROBES.joinpath("package.xml").read_text()
    package.joinpath("package.xml").write_text(xml.replace("timing_probes", "lab"))
    package.joinpath("CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.0.2)\nproject(lab)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    )
    return package


def test_dying_nodes_are_named(tmp_path: Path) -> None:
    package = empty_package(tmp_path)
    nodes = {
        "at_once": "import os\nos._exit(3)\n",
        "at_the_end": f"import time\ntry:\n print('begun')\n time.sleep({NEVER})\nfinally: 1/0\n",
    }
    for name, text in nodes.items():
        (package / f"{name}.py").write_text("#!/usr/bin/env python3\n" + text)
        (package / f"{name}.py").chmod(0o755)
    launch_file = package / "dying.launch"
    elements = [f'<node name="{name}" pkg="lab" type="{name}.py" output="screen"/>' for name in nodes]
    launch_file.write_text(f"<launch>{''.join(elements)}</launch>")
    run = ros1.launch(launch_file, NEVER, onward=Until("process has died", "begun"))
    assert run.status == 3
    assert re.search(r"^rosspin: at_once-\d ended with status 3$", run.console, re.MULTILINE)
    assert re.search(r"^rosspin: at_the_end-\d ended with status 1$", run.console, re.MULTILINE)


def test_node_file_that_fails(tmp_path: Path) -> None:
    node = tmp_path / "failing.py"
    node.write_text("import rospy\nrospy.init_node('failing')\n1/0\n")
    run = ros1.launch(node, NEVER)
    assert run.status == 1
    assert "ZeroDivisionError: division by zero\n" in run.console
    assert run.console.endswith("rosspin: failing.py ended with status 1\n")


def test_launch_file_that_is_none(tmp_path: Path) -> None:
    file = empty_package(tmp_path) / "bad.launch"
    file.write_text("<launch><node></launch>")
    run = ros1.launch(file, 1.0)
    assert run.status != 0
    assert "Invalid roslaunch XML syntax" in run.console
    assert re.search(r"^rosspin: roslaunch ended with status \d+$", run.console, re.MULTILINE)


# --- clean-up ---------------------------------------------------------------------------------------------------------


def test_a_node_deaf_to_ctrl_c_is_killed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ros1.Workspace, "ending", Ending(((signal.SIGINT, 1.0), (signal.SIGTERM, 1.0))))
    node = tmp_path / "deaf.py"
    node.write_text(
        "import signal, time\n"
        "for number in (signal.SIGINT, signal.SIGTERM): signal.signal(number, signal.SIG_IGN)\n"
        f"print('deaf')\ntime.sleep({NEVER})\n"
    )
    run = ros1.launch(node, NEVER, onward=Until("deaf\n"))
    assert run.status == 128 + signal.SIGKILL
    assert run.console == "deaf\nrosspin: deaf.py ended with status 137 (SIGKILL)\n"


def test_an_error_ends_everything(leaves_nothing: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        with ros1.Workspace() as workspace:
            workspace.start_master()
            assert len(processes(leaves_nothing)) == 1
            1 / 0


def test_a_console_that_is_closed_ends_the_run(leaves_nothing: Path) -> None:
    run = ros1.launch(PACKAGE / "src" / "spinner_py_node.py", NEVER, onward=Until("counter = 2"))
    assert run.status == 0


@pytest.mark.parametrize(
    ("file", "number", "when"),
    [
        ("launch/spinner.launch", signal.SIGINT, "building"),
        ("launch/spinner.launch", signal.SIGINT, "running"),
        ("src/spinner_py_node.py", signal.SIGTERM, "running"),
    ],
)
def test_a_signal_ends_everything(
    file: str, number: signal.Signals, when: str, leaves_nothing: Path, small: Path
) -> None:
    """From the command line, as a reader does it: the nodes end as at Ctrl-C."""
    command = [sys.executable, "-m", "rosspin", "run", "--ros1", str(small / file)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert process.stdout is not None
    console = ""
    languages = ("CPP", "PY") if file.endswith(".launch") else ("PY",)
    if when == "running":
        for line in process.stdout:
            console += line
            if all(f"[SPINNER {language} NODE] counter = 2" in console for language in languages):
                break
    else:
        while not any("make" in command for command in processes(leaves_nothing)):
            assert process.poll() is None
            time.sleep(0.05)
    process.send_signal(number)
    console += process.communicate()[0]
    assert process.returncode == (0 if when == "running" else 130)
    assert "Traceback" not in console


def test_doctor(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["doctor"]) == 0
    *lines, _, _ = capsys.readouterr().out.splitlines()  # the last two are about recordings
    assert [line.split()[0] for line in lines] == ["stand-in", "rospy", "roscpp", "rclpy", "browser", "bwrap"]
    assert all(line.split()[1] in ("yes", "no") for line in lines)
    assert [line.split()[1] for line in lines[:3]] == ["yes"] * 3


# --- what the tutorial says of roscpp ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    ["spinner_cpp_node", "spinner_rate_cpp_node", "3_class", "pubsub_cpp_node", "publisher_cpp_node", "plain_cpp_node"],
)
def test_ctrl_c_ends_a_cpp_node_cleanly(workspace: ros1.Workspace, cpp_nodes: CppNodes, name: str) -> None:
    # Not even a busy machine needs the 15 s after which SIGTERM would follow; that would give another status.
    counts = name not in ("plain_cpp_node", "publisher_cpp_node")
    begins = re.compile("counter = 1" if counts else "namespace of")
    output = workspace.run([cpp_nodes.program(name)], 1.2, begins=begins)
    assert output.status == 0
    seen = counters(output.console)
    assert seen == list(range(1, len(seen) + 1))
    assert bool(seen) == counts


def test_while_ros_ok_does_not_end_at_ctrl_c(workspace: ros1.Workspace, cpp_nodes: CppNodes) -> None:
    ending = Ending(((signal.SIGINT, 2.0), (signal.SIGINT, 2.0), (signal.SIGTERM, 5.0)))
    command = [cpp_nodes.program("while_ros_ok")]
    output = workspace.run(command, 0.2, begins=re.compile("counter = "), ending=ending)
    assert output.status == 128 + signal.SIGTERM


def test_a_global_timer_aborts_at_ctrl_c(workspace: ros1.Workspace, cpp_nodes: CppNodes) -> None:
    output = workspace.run([cpp_nodes.program("global_timer")], 0.2, begins=re.compile("counter = "))
    assert output.status == 128 + signal.SIGABRT
    assert "boost" in output.console and "lock_error" in output.console


def test_a_slow_callback_re_phases_a_cpp_timer(workspace: ros1.Workspace, cpp_nodes: CppNodes) -> None:
    """After 4.4 periods the timer continues from there, one period at a time, and says so of none of it."""
    command = [cpp_nodes.program("timer_probe"), "_period:=0.2", "_block:=0.88", "_block_call:=2"]
    with control(bears=0.1):  # a late call 3 is itself one after which the timer continues from there
        lines = workspace.run(command, NEVER, Until("timerCallback,4,")).console.splitlines()
        rows = [line.split(",") for line in lines if line.startswith("timerCallback")]
        expected = {int(row[1]): float(row[4]) for row in rows}
        real = {int(row[1]): float(row[5]) for row in rows}
        assert expected[4] - expected[3] == pytest.approx(0.2, abs=1e-5)
    assert real[3] - real[2] >= 0.88
    assert expected[3] - expected[2] > 0.8  # rewritten: rospy's would be 0.2
    assert float(rows[2][6]) >= 0.88  # only profile.last_duration shows it
