"""Launch files that start nodes in both languages run in simulated time; CMake says which sources belong together."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from rosspin import simulate
from tests.helpers.tree import ROOT

Write = Callable[[str, str], Path]

EXAMPLES = ROOT / "examples"


def test_the_launch_file_of_the_tutorial_in_ros_1() -> None:
    run = simulate(EXAMPLES / "my_robotics_pkg/launch/spinner.launch", 1.2)
    lines = re.findall(r"\[ ?INFO\] (.*?)(?:\x1b\[0m)?\n", run.console)
    assert lines == [
        "[0.000000000]: [SPINNER CPP NODE] namespace of nh = /mrp/spinner_cpp_node",
        "[0.000000]: [SPINNER PY NODE] namespace of node = /mrp/",
        "[0.500000000]: [SPINNER CPP NODE] counter = 1",
        "[0.500000]: [SPINNER PY NODE] counter = 1",
        "[1.000000000]: [SPINNER CPP NODE] counter = 2",
        "[1.000000]: [SPINNER PY NODE] counter = 2",
    ]
    sources = ["/mrp/spinner_cpp_node timerCallback", "/mrp/spinner_py_node timerCallback"]
    assert {each.source for each in run.ticks} == set(sources)


def test_the_launch_file_of_the_tutorial_in_ros_2() -> None:
    """As it was recorded, but for the time that the node in Python takes to start."""
    recorded = (EXAMPLES / "recordings/ros2/launch_cpp.txt").read_text(encoding="utf-8")
    run = simulate(EXAMPLES / "my_robotics_pkg_ros2_cpp/launch/spinner.launch.xml", 8.2)

    def said(console: str, node: str) -> list[str]:
        text = re.sub(r"\[\d+\.\d+\] | with pid \[\d+\]| \[pid \d+\]", "", console)
        return [line for line in text.splitlines() if node in line]

    for node in ("spinner_cpp_node-1", "launch]: user"):
        ours, theirs = said(run.console, node), said(recorded, node)
        assert [line for line in theirs if line not in ours] == []
        assert len(ours) - len(theirs) in (0, 1)
    assert len(said(run.console, "spinner_py_node-2")) > 10


PACKAGE = "<package><name>pkg</name></package>"
PARTS = """\
# What is in a comment counts for nothing: add_executable(talker lost.cpp)
project(pkg)
set(SOURCES src/talker.cpp
  "${CMAKE_CURRENT_SOURCE_DIR}/src/words.cpp")
add_executable(${PROJECT_NAME}_talker ${SOURCES})
add_library(numbers SHARED src/numbers.cpp)
target_link_libraries(${PROJECT_NAME}_talker numbers)
add_library(parts src/part.cpp src/other_part.cpp src/words.cpp)
rclcpp_components_register_node(parts PLUGIN "pkg::Part" EXECUTABLE part_node)
"""
TALKER = """\
#include "pkg/words.hpp"
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  RCLCPP_INFO(rclcpp::get_logger("talker"), "%s %d", words(), number());
}
"""
WORDS_HPP = "#pragma once\nconst char* words();\nint number();\n"
PART = """\
#include "pkg/words.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
namespace pkg
{
class Part : public rclcpp::Node
{
public:
  explicit Part(const rclcpp::NodeOptions& options) : Node("part", options)
  {
    RCLCPP_INFO(get_logger(), "Part %s", words());
  }
};
}
RCLCPP_COMPONENTS_REGISTER_NODE(pkg::Part)
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package with a program of three sources, and a library of two components."""
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": PARTS,
        "include/pkg/words.hpp": WORDS_HPP,
        "src/talker.cpp": TALKER,
        "src/words.cpp": '#include "pkg/words.hpp"\nconst char* words() { return "words"; }\n',
        "src/numbers.cpp": '#include "pkg/words.hpp"\nint number() { return 5; }\n',
        "src/part.cpp": PART,
        "src/other_part.cpp": PART.replace("Part", "OtherPart"),
        "a.launch.py": "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
        "def generate_launch_description():\n    return LaunchDescription([\n"
        "        Node(package='pkg', executable='pkg_talker'),\n"
        "        Node(package='pkg', executable='part_node', name='named'),\n    ])\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_sources_that_belong_together_are_linked(package: Path) -> None:
    run = simulate(package / "src" / "talker.cpp", 1.0)
    assert re.sub(r"\[0\.\d*\] ", "", run.console) == "[INFO] [talker]: words 5\n"


@pytest.mark.parametrize(("file", "line"), [("src/numbers.cpp", 2), ("include/pkg/words.hpp", 3)])
def test_a_fault_names_the_file_that_it_is_in(package: Path, file: str, line: int) -> None:
    """A header by the name that it is included with."""
    (package / "include/pkg/words.hpp").write_text(
        "#pragma once\nconst char* words();\ninline int in_header(int* none) { return *none; }\nint number();\n"
    )
    call = "in_header(nullptr)" if "words" in file else "*static_cast<int*>(nullptr)"
    (package / "src/numbers.cpp").write_text(f'#include "pkg/words.hpp"\nint number() {{ return {call}; }}\n')
    run = simulate(package / "src" / "talker.cpp", 1.0)
    name = file.removeprefix("include/").removeprefix("src/")
    assert f"rosspin: {name}:{line}: it has used a null pointer\n" in run.console
    assert run.status == 139


def test_programs_and_components_are_launched_by_their_names(package: Path) -> None:
    console = simulate(package / "a.launch.py", 1.0).console
    assert "[talker]: words 5\n" in console
    assert "[named]: Part words\n" in console
    assert "OtherPart" not in console
