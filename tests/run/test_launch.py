"""Launch files in simulated time: what is faulty or not simulated is said with file and line; the command line."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from shlex import quote
from typing import Any

import pytest

from rosspin import measure, simulate
from rosspin.__main__ import main
from rosspin.run.explain import say_error
from rosspin.run.roslaunch.launch import read_launch
from tests.helpers.tree import ROOT

SPINNERS = ROOT / "examples/my_robotics_pkg/launch/spinner_param.launch"

NODE = """
    #!/usr/bin/env python3
    import rospy
    rospy.init_node("node")
    rospy.loginfo(rospy.get_name())
    """

XML = "<?xml version='1.0' encoding='{}'?><launch/>"

Launched = Callable[..., Path]


@pytest.fixture
def launched(write: Any, tmp_path: Path) -> Launched:
    """Writes a launch file of a package ``pkg`` that has nodes in Python and C++; its path."""
    write("<package><name>pkg</name></package>", "package.xml")
    write("add_executable( built\n src/other.cpp)", "CMakeLists.txt")
    (tmp_path / "nodes").mkdir()
    (tmp_path / ".hidden").mkdir()
    for name in ("node.py", "nodes/script", ".hidden/lost.py"):
        write(NODE.lstrip("\n"), name)
    write("int main() {}", "nodes/compiled.cpp")

    def launch(text: str, name: str = "a.launch") -> Path:
        path: Path = write(text if text.startswith(("\n", "<?")) else f"<launch>\n{text}\n</launch>\n", name)
        return path

    return launch


def node(**attributes: str) -> str:
    words = {"pkg": "pkg", "type": "node.py", "name": "n", "output": "screen", **attributes}
    return f"<node {' '.join(f'{name}={value!r}' for name, value in words.items())}/>"


# --- where nodes are --------------------------------------------------------------------------------------------------


def test_nodes_are_found_anywhere_in_their_package(launched: Launched) -> None:
    path = launched(node(name="a") + node(name="b", type="script"))
    assert [os.path.basename(str(each.node)) for each in read_launch(path).nodes] == ["node.py", "script"]
    assert "/a\n" in simulate(path, 1).console


def test_a_relative_path_will_do(launched: Launched, monkeypatch: pytest.MonkeyPatch) -> None:
    path = launched(node())
    monkeypatch.chdir(path.parent)
    assert "/n\n" in simulate(path.name, 1).console


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("built", r"a\.launch:3: pkg/built is a C\+\+ node whose source is not there; --skip-cpp leaves"),
        ("compiled", r"compiled\.cpp: this includes neither ros/ros\.h nor rclcpp/rclcpp\.hpp"),
    ],
)
def test_a_node_in_cpp_that_cannot_run_is_named_or_left_out(launched: Launched, kind: str, said: str) -> None:
    path = launched(node() + "\n" + node(name="c", type=kind))
    with pytest.raises(ValueError, match=said):
        simulate(path, 1)
    run = simulate(path, 1, skip_cpp=True)
    assert run.console.splitlines()[:2] == [
        f"rosspin: {path}:3: pkg/{kind} is left out",
        "[INFO] [0.000000]: /n",
    ]


def test_a_node_of_a_package_that_is_elsewhere_is_named_or_left_out(launched: Launched) -> None:
    path = launched(node() + "\n" + node(name="rviz", pkg="rviz", type="rviz"))
    with pytest.raises(ValueError, match=r"a\.launch:3: there is no package rviz around this file; --skip-cpp leaves"):
        simulate(path, 1)
    assert [each.name for each in read_launch(path, skip_cpp=True).nodes] == ["n"]


def test_the_tutorials_launch_file_runs_without_its_cpp_node() -> None:
    run = simulate(SPINNERS, 2, ["frequency:=1"], skip_cpp=True)
    assert {tick.source for tick in run.ticks} == {"/mrp/spinner_py_node timerCallback"}
    assert [tick.real for tick in run.ticks] == [1.0, 2.0]


# --- what is wrong ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<node", ":3: this is not XML: not well-formed"),
        ("\n<robot/>", ":2: a launch file begins with <launch>, not with <robot>"),
        ("<machine name='a' address='b'/>", ":2: <machine> is not simulated"),
        ("\n\n<launch>\n<nod/></launch>", ":4: <nod> is not simulated"),
        ("<group>\n<foo/></group>", ":3: <foo> is not simulated"),
        (node(machine="a"), ':2: <node machine="..."> is not simulated'),
        (node(**{"launch-prefix": "gdb"}), ':2: <node launch-prefix="..."> is not simulated'),
        ("<node pkg='pkg' name='n'/>", ":2: <node> lacks type"),
        ("<node pkg='pkg' type='node.py' name='n'><node/></node>", ":2: <node> is not simulated"),
        (node(type="lost.py"), ":2: there is no node lost.py in package pkg"),
        (node(name="a/b"), ":2: the name of a node cannot contain a namespace: a/b"),
        (node(output="both"), ":2: output is screen or log, not both"),
        (node(cwd="here"), ":2: cwd is ROS_HOME or node, not here"),
        (node(required="yes"), ":2: required is true or false, not 'yes'"),
        (node(respawn_delay="soon"), ":2: respawn_delay is a number, not 'soon'"),
        (node(required="true", respawn="true"), ":2: a node cannot be both required and started again"),
        (node() + node(), ": there are several nodes named /n"),
        ("<group if='1' unless='1'/>", ":2: <group> has both if and unless"),
        ("<group if='maybe'/>", ":2: if is true or false, not 'maybe'"),
        ("<param name='a'/>", ":2: param a needs one of value, textfile and command"),
        ("<param name='a' value='b' type='int'/>", ":2: a is of type int, and cannot be 'b'"),
        ("<param name='a' value='b' type='list'/>", ":2: type is auto, str, int, double, bool or yaml, not list"),
        ("<param name='a' value='[' type='yaml'/>", ":2: a is not YAML: "),
        ("<rosparam>{</rosparam>", ":2: rosparam is not YAML: "),
        ("<rosparam>5</rosparam>", ":2: rosparam needs a param for a value that is not a dictionary"),
        ("<rosparam command='dump' file='a'/>", ':2: <rosparam command="dump"> is not simulated'),
        ("<arg name='a'/><group if='$(arg a)'/>", ":2: arg a has no value; give it one: a:=..."),
        ("<arg name='a'/>\n<arg name='a'/>", ":3: arg a is declared a second time"),
        ("<arg name='a' value='1' default='2'/>", ":2: arg a has both value and default"),
        ("<arg name='fixed' value='1'/>", ":2: arg fixed has a fixed value, and cannot be set"),
        ("<param name='a' value='$(env ROSSPIN_NOWHERE)'/>", ":2: the environment variable ROSSPIN_NOWHERE is not set"),
        ("<param name='a' value='$(find nowhere)'/>", ":2: there is no package nowhere around this file"),
        ("<param name='a' value='$(fnd pkg)'/>", ":2: $(fnd pkg) is no substitution"),
        ("<param name='a' value='$(arg a b)'/>", ":2: $(arg a b) is no substitution"),
        ("<param name='a' value='$(find $(arg a))'/>", ":2: "),
        ("<param name='a' value='$(eval 1 + 2)'/>", ":2: $(eval) is not simulated"),
        ("<rosparam subst_value='true'/>", ':2: <rosparam subst_value="..."> is not simulated'),
        ("<include file='$(dirname)/b.launch'><param/></include>", ":2: <param> has no place in <include>"),
        ("<include file='$(dirname)/b.launch'><arg name='x'/></include>", ":2: arg x is given no value"),
        ("<include file='$(dirname)/b.launch'><arg name='x' value='1'/></include>", "b.launch has no arg x"),
        ("<include file='$(dirname)/c.launch'/>", "c.launch:3: <foo> is not simulated"),
        ("<param name='a' command='false'/>", ":2: param a: the command 'false' ended with status 1"),
        ("<param name='a' command='rosspin-nowhere'/>", ":2: param a: there is no command 'rosspin-nowhere'"),
        ("<param name='a' command=''/>", ":2: param a: there is no command ''"),
        ("<param name='a' command='echo \"x'/>", ":2: command is no command line: no closing quotation in 'echo \"x'"),
        ("<node pkg='pkg' type='node.py' name='n' args='\"x'/>", ":2: args is no command line: no closing quotation"),
        ("<param name='a' textfile='/bin/sh'/>", ":2: /bin/sh is not UTF-8: "),
        ("<param name='a' value='4294967296'/>", ":2: a has a value that ROS's parameter server does not take: int"),
        (
            "<rosparam>{a: {b: [1, -2147483649]}}</rosparam>",
            ":2: rosparam has a value that ROS's parameter server does not take",
        ),
        ("<rosparam>{a: 2024-01-02}</rosparam>", ":2: rosparam has a value that ROS's parameter server does not"),
        ("<rosparam>{a: 2024-13-02}</rosparam>", ":2: rosparam has a value that YAML cannot read: month must be in"),
        ("<rosparam>{a: null}</rosparam>", ":2: rosparam has a value that ROS's parameter server does not"),
        ("<rosparam>{a: [1, ~]}</rosparam>", "does not take: cannot marshal None"),
        ("<rosparam>{a: !!set {b}}</rosparam>", "does not take: cannot marshal <class 'set'>"),
        ("<rosparam>{1: 2}</rosparam>", "does not take: dictionary key must be string"),
        (XML.format("klingon"), ":1: this cannot be read: unknown encoding"),
        (XML.format("utf-7"), ":1: this cannot be read: multi-byte encodings"),
    ],
)
def test_what_is_wrong_is_said_with_file_and_line(launched: Launched, text: str, message: str) -> None:
    launched("", "b.launch")
    launched("\n\n<launch>\n<foo/></launch>".replace("\n\n<", "\n<"), "c.launch")
    path = launched(text)
    with pytest.raises(ValueError) as caught:
        simulate(path, 1, ["fixed:=2"])
    assert message in str(caught.value)
    assert str(caught.value).startswith(str(path.parent))


# Each line holds ten of the one before.
YAML_LAUGHS = "a: &a x\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 10)}]\n" for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)
YAML_MERGES = "a: &a {x: 1}\n" + "".join(
    f"{name}: &{name} {{<<: [{', '.join([f'*{before}'] * 10)}]}}\n"
    for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)

TENFOLD = ["x"] + [f"&{name};" * 10 for name in "abcdefg"]
LAUGHS = "".join(f'<!ENTITY {name} "{text}">' for name, text in zip("abcdefgh", TENFOLD, strict=True))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (f"\n<!DOCTYPE launch [{LAUGHS}]><launch><rosparam>&h;</rosparam></launch>", ":2: this is not XML: limit on"),
        ("<rosparam>a: &amp;a [*a]</rosparam>", "does not take: cannot marshal recursive sequences"),
        ("<rosparam>a: &amp;a {b: *a}</rosparam>", "does not take: cannot marshal recursive dictionaries"),
        (f"<rosparam>a: {'[' * 5000}</rosparam>", ":2: rosparam is not YAML: it is nested too deeply"),
        (
            f"<rosparam>{YAML_LAUGHS.replace('&', '&amp;')}</rosparam>",
            "is not YAML: its aliases repeat more than 100,000",
        ),
        (
            f"<rosparam>{YAML_MERGES.replace('&', '&amp;').replace('<<', '&lt;&lt;')}</rosparam>",
            "is not YAML: its aliases",
        ),
        (f"<rosparam>a: {'9' * 5000}</rosparam>", ":2: rosparam has a value that YAML cannot read: Exceeds the limit"),
        ("<include file='$(dirname)/a.launch'/>", ":2 -> ..."),
        ("<include file='$(dirname)/d.launch'/>", "d.launch:3 -> "),
    ],
)
def test_what_never_ends_is_said_with_file_and_line(launched: Launched, text: str, message: str) -> None:
    launched("<group/>\n<include file='$(dirname)/a.launch'/>", "d.launch")
    path = launched(text)
    with pytest.raises(ValueError) as caught:
        simulate(path, 1)
    assert message in str(caught.value)
    assert str(caught.value).startswith(f"{path.parent}/")


def test_a_file_that_is_refused_runs_no_command(launched: Launched, tmp_path: Path) -> None:
    (tmp_path / "touch.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')")
    words = quote(sys.executable), quote(str(tmp_path / "touch.py"))
    command = f'<param name="a" command="{" ".join(words)}"/>'
    for refused in ("<foo/>", "<rosparam>[</rosparam>", node(name="a/b"), node(type="lost.py")):
        with pytest.raises(ValueError):
            simulate(launched(command + refused), 1)
        assert not (tmp_path / "ran").exists()
    simulate(launched(command), 1)
    assert (tmp_path / "ran").exists()


@pytest.mark.parametrize("several", [SPINNERS, str(SPINNERS), [lambda: None]], ids=["path", "name", "list"])
def test_on_the_wall_clock_there_is_one_node(several: Any) -> None:
    with pytest.raises(ValueError, match="several nodes and launch files run in simulated time"):
        measure(several, 1)


def test_a_file_that_is_not_there_is_an_error(launched: Launched) -> None:
    with pytest.raises(FileNotFoundError):
        simulate("nowhere.launch", 1)
    with pytest.raises(FileNotFoundError) as caught:
        simulate(launched("<include file='nowhere.launch'/>"), 1)
    assert say_error(caught.value).endswith("a.launch:2)")
    path = launched("<include file='$(dirname)/a.launch'/>", "b.launch")
    with pytest.raises(FileNotFoundError) as caught:
        simulate(path, 1)
    assert say_error(caught.value).endswith("a.launch:2)")


def test_what_roslaunch_passes_over_is_passed_over(launched: Launched) -> None:
    assert "/n\n" in simulate(launched(f"<master auto='start'/><test/><!-- <foo/> -->{node()}"), 1).console


def test_a_name_is_made_anonymous_in_the_same_way_each_time(launched: Launched) -> None:
    path = launched(node(name="$(anon n)", args="$(anon n) $(anon m)"))
    (found,) = read_launch(path).nodes
    assert found.name == "n_anonymous" and list(found.args) == ["n_anonymous", "m_anonymous"]


# --- the command line -------------------------------------------------------------------------------------------------


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "rosspin", "run", *words], capture_output=True, text=True, cwd=ROOT)


def test_launch_files_run_from_the_command_line(launched: Launched) -> None:
    path = str(launched(node(name="$(arg name)") + "<arg name='late'/>").parent / "a.launch")
    Path(path).write_text(Path(path).read_text().replace("<launch>", "<launch><arg name='name'/>"))
    ended = run("--simulated", path, "--seconds", "1", "--", "name:=given")
    assert (ended.returncode, ended.stderr) == (0, "")
    assert ended.stdout.splitlines()[0] == "[INFO] [0.000000]: /given"


def test_leaving_out_cpp_from_the_command_line() -> None:
    ended = run("--simulated", "--skip-cpp", str(SPINNERS), "--seconds", "1")
    assert ended.returncode == 0
    assert "spinner_param_cpp_node is left out" in ended.stderr
    assert "counter = 2" in ended.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([str(SPINNERS)], "launch files run in simulated time or on the real ROS 1: --simulated or --ros1"),
        (["--skip-cpp", "--ros1", str(SPINNERS)], "--skip-cpp is for launch files in simulated time"),
        (
            ["--skip-cpp", "--simulated", "--seconds", "1", "node.py"],
            "--skip-cpp is for launch files in simulated time",
        ),
    ],
)
def test_what_the_command_line_refuses(words: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", *words]) == 1
    assert message in capsys.readouterr().err
