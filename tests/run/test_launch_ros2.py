"""Launch files of ROS 2 in simulated time, compared with what the real ``ros2 launch`` did with them.

A recording is the console, with its status, without what differs each time. Lines of different processes come in any
order on a real machine, so what is compared is what each of them printed, in its order, and what launch said of each.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosspin import measure, simulate, start
from rosspin.__main__ import main
from tests.helpers.tree import TESTS

PACKAGE = TESTS / "launched_ros2"
RECORDED = PACKAGE / "recorded"
FILES = sorted(path.name for path in (PACKAGE / "launch").iterdir())
FAULTY = sorted(path.name for path in (PACKAGE / "faulty").iterdir())

ARGS = {"arguments.launch.py": ["needed:=given", "extra:=more"], "opaque.launch.py": ["count:=3"]}
SECONDS = {"ctrl_c.launch.py": 6.0, "ctrl_c_respawn.launch.py": 6.0}  # the others end by themselves

# Those in which one thing happens after the other, also on a real machine.
IN_ORDER = {"arguments", "conditions", "exits", "idle", "includes", "leaks", "one", "raises", "respawn"}

Write = Callable[..., Path]


def normal(console: str) -> str:
    """A console without what differs from machine to machine."""
    text = console.replace(str(PACKAGE), "PKG")
    text = re.sub(r"\[\d+\.\d+\]", "[STAMP]", text)
    text = re.sub(r"cmd '\S*?(\w+)(?:\.py)? ", r"cmd '\1 ", text)
    text = re.sub(r"/tmp/launch_params\w*", "FILE", text)
    text = re.sub(r'^\S+ +File "PREFIX.*"(, line 33).*\n.*load_entry_point.*\n.*\^\^\n', "", text, flags=re.MULTILINE)
    text = re.sub(r'^(\S+ +File ").*/(launched/\w+\.py", line.*\n)(?:\S+     .*\n)*', r"\1\2", text, flags=re.MULTILINE)
    return text


def said(console: str) -> dict[str, list[str]]:
    """The lines of a console by who has printed them."""
    found: dict[str, list[str]] = {}
    speaker = ""
    for line in normal(console).splitlines():
        if match := re.match(r"(\[[A-Z]+\] )?\[([\w.]+)(-\d+)?\]", line):
            speaker = match[0]
        found.setdefault(speaker, []).append(line)
    return found


@pytest.mark.parametrize("name", FILES)
def test_a_launch_file_runs_as_under_ros2_launch(name: str) -> None:
    console, _, status = (RECORDED / f"{name}.txt").read_text(encoding="utf-8").rpartition("status ")
    run = simulate(PACKAGE / "launch" / name, SECONDS.get(name, 45.0), ARGS.get(name, []))
    assert said(run.console) == said(console)
    assert name.partition(".")[0] not in IN_ORDER or normal(run.console) == normal(console)
    assert run.status == int(status)


# What is said in other words than on the real one, where all is installed, and other files may be of any format.
OWN_WORDS = {
    "bad_period.launch.py": "'TimerAction' expected 'period' to be a float or a substitution, but got '1'",
    "broken.launch.xml": "this is not XML: mismatched tag",
    "broken.launch.yaml": "while parsing a flow mapping",
    "not_closed.launch.xml": "'$(var lost' is not closed",
    "no_executable.launch.py": "executable 'lost' not found in package 'launched'",
    "no_file.launch.py": "/nowhere/lost.launch.py: No such file or directory",
    "no_keyword.launch.py": "Node.__init__() got an unexpected keyword argument 'colour'",
    "no_name.launch.py": "cannot import name 'Lost' from 'launch.actions'",
    "no_parameter_file.launch.py": "there is no parameter file lost.yaml",
    "no_package.launch.py": "package 'nowhere' not found around the launch file",
    "no_share.launch.py": "package 'nowhere' not found around the launch file",
    "root.launch.xml": "a launch file begins with <launch>, not with <lunch>",
}


@pytest.mark.parametrize("name", FAULTY)
def test_a_fault_is_told_in_the_words_of_ros2_launch_with_its_place(name: str) -> None:
    path = PACKAGE / "faulty" / name
    recorded = (RECORDED / f"{name}.txt").read_text(encoding="utf-8")
    with pytest.raises(ValueError) as caught:
        simulate(path, 1)
    place, line, words = re.fullmatch(r"(.*?):(\d+): (.*)", str(caught.value), re.DOTALL).groups()  # type: ignore[union-attr]
    lines = path.read_text(encoding="utf-8").splitlines()
    assert place == str(path)
    assert int(line) <= len(lines) + 1  # where a file ends too soon
    assert words.replace(str(PACKAGE), "PKG").startswith(OWN_WORDS.get(name, "")), words
    assert name in OWN_WORDS or words.replace(str(PACKAGE), "PKG") in recorded
    assert recorded.endswith("status 1\n")


# --- what is not simulated --------------------------------------------------------------------------------------------

FILE = """
from launch import LaunchDescription
from launch.actions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    return LaunchDescription([
        LogInfo(msg="first"),
        {},
    ])
"""


@pytest.fixture
def launched(write: Any, tmp_path: Path) -> Write:
    """Writes a launch file of a package ``pkg`` that has nodes in Python and in C++; its path."""
    write("<package><name>pkg</name></package>", "package.xml")
    write("add_executable(built src/built.cpp)", "CMakeLists.txt")
    (tmp_path / "scripts").mkdir()
    write("print('scripted')", "scripts/script.py")
    write("#!/usr/bin/env python3\nprint('bare')", "scripts/bare")

    def launch(action: str, name: str = "a.launch.py") -> Path:
        path: Path = write(FILE.replace("{}", action) if name.endswith(".py") else action, name)
        return path

    return launch


@pytest.mark.parametrize(
    ("action", "words"),
    [
        ("ComposableNodeContainer(package='pkg', executable='x')", "launch_ros.actions.ComposableNodeContainer"),
        ("LifecycleNode(package='pkg', executable='x', name='y', namespace='')", "launch_ros.actions.LifecycleNode"),
        ("LogInfo(msg=Command(['ls']))", "launch.substitutions.Command"),
        ("GroupAction([], forwarding=False)", "GroupAction(forwarding=False)"),
        ("Node(package='pkg', executable='script.py', prefix='gdb')", "Node(prefix=...)"),
        ("ExecuteProcess(cmd=['ros2', 'run', 'pkg', 'script.py'], shell=True)", "ExecuteProcess(shell=...)"),
        ("ExecuteProcess(cmd=['gazebo', 'world'])", "'gazebo'"),
        ("ExecuteProcess(cmd=['python3', '-m', 'this'])", "'python3'"),
        ("RegisterEventHandler(OnProcessIO(on_stdout=print))", "launch.event_handlers.OnProcessIO"),
        ("SetROSLogDir('/tmp')", "launch_ros.actions.SetROSLogDir"),
    ],
)
def test_what_is_not_simulated_is_named_with_its_place(launched: Write, action: str, words: str) -> None:
    path = launched(action)
    with pytest.raises(ValueError, match=re.escape(f"{path}:12: {words} is not simulated")):
        simulate(path, 1)


def test_an_environment_variable_is_made_longer_in_xml(write: Any) -> None:
    """Source: launch/actions/append_environment_variable.py."""
    path = write(
        '<launch><set_env name="A" value="a"/><append_env name="A" value="b" prepend="true" separator="-"/>'
        '<append_env name="A" value="c"/><log message="$(env A)"/></launch>',
        "a.launch.xml",
    )
    assert "b-a:c\n" in simulate(path, 1).console


def test_a_fault_in_the_midst_ends_the_run(launched: Write) -> None:
    path = launched("Node(package='pkg', executable='script.py'), TimerAction(period=1.0, actions=[LogInfo(msg=5)])")
    with pytest.raises(ValueError, match=r"a\.launch\.py:12: 'int' object is not iterable"):
        simulate(path, 2)
    path = launched("LogInfo(msg=PythonExpression('lost + 1'))")
    with pytest.raises(ValueError, match=r"a\.launch\.py:12: name 'lost' is not defined"):
        simulate(path, 2)
    path = launched("RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: {}['lost']))")
    with pytest.raises(ValueError, match=r"a\.launch\.py:12: KeyError: 'lost'"):
        simulate(path, 2)


def test_what_is_not_simulated_may_be_left_alone(launched: Write) -> None:
    path = launched("LifecycleNode(condition=__import__('launch').conditions.IfCondition('false'))")
    assert simulate(path, 1).console == "[INFO] [launch.user]: first\n"


def test_nodes_in_cpp_are_named_or_left_out(launched: Write) -> None:
    path = launched("Node(package='pkg', executable='built')")
    text = f"{path}:12: pkg/built is a C++ node whose source is not there; --skip-cpp leaves it out"
    with pytest.raises(ValueError, match=re.escape(text)):
        simulate(path, 1)
    assert f"rosspin: {path}:12: pkg/built is left out\n" in simulate(path, 1, skip_cpp=True).console
    path = launched("Node(package='rviz2', executable='rviz2'), ComposableNodeContainer(name='x')")
    console = simulate(path, 1, skip_cpp=True).console
    assert re.findall(r"rosspin: .*:12: (.*) is left out", console) == [
        "rviz2/rviz2",
        "launch_ros.actions.ComposableNodeContainer",
    ]


def test_a_tag_that_is_not_simulated(launched: Write) -> None:
    path = launched("<launch>\n <node_container pkg='a' exec='b'/>\n</launch>", "a.launch.xml")
    with pytest.raises(ValueError, match=r"a\.launch\.xml:2: Unrecognized entity of the type: node_container"):
        simulate(path, 1)


# --- where nodes are --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "said"), [("script.py", "scripted"), ("script", "scripted"), ("bare", "bare")])
def test_scripts_are_found_in_their_package(launched: Write, name: str, said: str) -> None:
    path = launched(f"Node(package='pkg', executable='{name}', output='screen')")
    assert f"[{name}-1] {said}\n" in simulate(path, 1).console


def test_entry_points_are_found_in_setup_cfg_and_below_src(launched: Write, write: Any, tmp_path: Path) -> None:
    write("[options.entry_points]\nconsole_scripts =\n    talk = words.talker:speak\n", "setup.cfg")
    (tmp_path / "src/words").mkdir(parents=True)
    write("", "src/words/__init__.py")
    write("from words.said import WORD\ndef speak():\n    print(WORD)", "src/words/talker.py")
    write("WORD = 'talked'", "src/words/said.py")
    write("raise ImportError('not this one')", "src/words/words.py")
    path = launched("Node(package='pkg', executable='talk', output='screen')")
    assert "[talk-1] talked\n" in simulate(path, 1).console


def test_entry_points_may_be_one_text(launched: Write, write: Any) -> None:
    write('from setuptools import setup\nsetup(entry_points={"console_scripts": "talk = talker:speak"})', "setup.py")
    write("def speak():\n    print('talked')", "talker.py")
    path = launched("Node(package='pkg', executable='talk', output='screen')")
    assert "[talk-1] talked\n" in simulate(path, 1).console


def test_a_node_that_setup_py_does_not_list_is_not_there(launched: Write, write: Any) -> None:
    write('from setuptools import setup\nsetup(entry_points={"console_scripts": []})', "setup.py")
    path = launched("Node(package='pkg', executable='script', output='screen')")
    with pytest.raises(ValueError, match="executable 'script' not found"):
        simulate(path, 1)


# --- other ways to run one --------------------------------------------------------------------------------------------


def test_the_modules_are_there_only_while_the_file_runs() -> None:
    simulate(PACKAGE / "launch/one.launch.py", 1)
    assert not {"launch", "launch_ros", "ament_index_python"} & sys.modules.keys()


def test_ticks_and_messages_are_named_after_the_nodes(launched: Write, write: Any) -> None:
    write(
        """
        import rclpy
        rclpy.init()
        node = rclpy.create_node("ticker")
        timer = node.create_timer(0.5, lambda: None)
        rclpy.spin(node)
        """,
        "ticker.py",
    )
    path = launched("Node(package='pkg', executable='ticker.py', namespace='robot')")
    run = simulate(path, 2)
    assert {tick.source for tick in run.ticks} == {"/robot/ticker <lambda>"}
    assert [tick.real for tick in run.ticks] == [0.5, 1.0, 1.5, 2.0]
    assert run.status == 0


def test_it_runs_in_steps() -> None:
    with start(PACKAGE / "launch/timers.launch.py") as run:
        assert run.advance(0.5).console.endswith("first\n")
        assert run.advance(0.5).console.startswith("[INFO] [launch.user]: second\n")


def test_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    path = str(PACKAGE / "launch/arguments.launch.py")
    assert main(["run", path, "--simulated", "--seconds", "1", "--", "needed:=thing"]) == 0
    assert "[INFO] [launch.user]: needed thing\n" in capsys.readouterr().out
    assert main(["run", path, "--simulated", "--seconds", "1"]) == 1
    assert f"rosspin: {path}:10: Included launch description missing required arg" in capsys.readouterr().err
    assert main(["run", path, "--simulated", "--seconds", "1", "--", "needed"]) == 1
    assert "malformed launch argument 'needed', expected format '<name>:=<value>'" in capsys.readouterr().err


def test_a_file_called_launch_py_is_one(tmp_path: Path) -> None:
    """It does not hide the package ``launch``."""
    text = (
        "from launch import LaunchDescription\nfrom launch.actions import LogInfo\n"
        "def generate_launch_description():\n    return LaunchDescription([LogInfo(msg='here')])\n"
    )
    (tmp_path / "launch.py").write_text(text)
    assert simulate(tmp_path / "launch.py", 2).console == "[INFO] [launch.user]: here\n"


def test_a_file_that_is_not_there_or_not_python(write: Any) -> None:
    with pytest.raises(FileNotFoundError):
        simulate("lost.launch.py", 1)
    with pytest.raises(SyntaxError):
        simulate(write("def", "a.launch.py"), 1)


def test_launch_files_are_not_measured() -> None:
    with pytest.raises(ValueError, match="several nodes and launch files run in simulated time"):
        measure(PACKAGE / "launch/one.launch.py", 1)
